# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A CT volume instead of a surface."""

import random

import vtk
from vtk.util import numpy_support

from application import REJECTED, USAGE, ApplicationTest, main, read


def ball(size=24):
    """A ball of 1000 HU and radius 8 mm in air, its center at x = 100 mm."""
    image = vtk.vtkImageData()
    image.SetDimensions(size, size, size)
    image.SetOrigin(100.0 - (size - 1) / 2, 0.0, 0.0)
    image.AllocateScalars(vtk.VTK_SHORT, 1)
    middle = (size - 1) / 2
    for z in range(size):
        for y in range(size):
            for x in range(size):
                distance = ((x - middle) ** 2 + (y - middle) ** 2 + (z - middle) ** 2) ** 0.5
                image.SetScalarComponentFromDouble(x, y, z, 0, max(-1000.0, min(1000.0, (8.0 - distance) * 400.0)))
    return image


def labeled(labels, size=24, kind=vtk.VTK_UNSIGNED_CHAR, background=0):
    """Slabs of those labels side by side in a block within the background."""
    image = vtk.vtkImageData()
    image.SetDimensions(size, size, size)
    image.AllocateScalars(kind, 1)
    image.GetPointData().GetScalars().Fill(background)
    width = (size - 8) // len(labels)
    for x in range(4, 4 + width * len(labels)):
        for y in range(6, size - 6):
            for z in range(6, size - 6):
                image.SetScalarComponentFromDouble(x, y, z, 0, labels[(x - 4) // width])
    return image


def bytes_of(image):
    return numpy_support.vtk_to_numpy(image.GetPointData().GetScalars()).tobytes()


def segmentation(segments, layers=1, size=24):
    """The .seg.nrrd of 3D Slicer with those labels; with layers each segment has one, as where they overlap."""
    shape = f"{layers} {size} {size} {size}" if layers > 1 else f"{size} {size} {size}"
    kinds = "list domain domain domain" if layers > 1 else "domain domain domain"
    none = "none " if layers > 1 else ""
    header = (f"NRRD0004\n# Complete NRRD file format specification at:\ntype: unsigned char\n"
              f"dimension: {4 if layers > 1 else 3}\nspace: left-posterior-superior\nsizes: {shape}\n"
              f"space directions: {none}(1,0,0) (0,1,0) (0,0,1)\nkinds: {kinds}\nendian: little\nencoding: raw\n"
              "space origin: (0,0,0)\n")
    for i, label in enumerate(segments):
        header += (f"Segment{i}_ID:=Segment_{i + 1}\nSegment{i}_LabelValue:={label}\n"
                   f"Segment{i}_Layer:={i if layers > 1 else 0}\n")
    if layers == 1:
        return header.encode() + b"\n" + bytes_of(labeled(segments, size))
    which = bytes_of(labeled(range(1, layers + 1), size))
    voxels = (label if value == i + 1 else 0 for value in which for i, label in enumerate(segments))
    return header.encode() + b"\n" + bytes(voxels)


class Volumes(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.write_ball(self.path("ct.vti"))
        self.write_ball(self.path("ct.mha"))

    def write_ball(self, path):
        self.write(ball(), path)

    def write(self, image, path):
        writer = vtk.vtkXMLImageDataWriter() if path.suffix == ".vti" else vtk.vtkMetaImageWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(image)
        writer.Write()

    def test_bone_surface_of_a_volume(self):
        for name in ("ct.vti", "ct.mha"):
            with self.subTest(name=name):
                self.succeed(name, "out.vtp", "--iso", 226, "--target-reduction", 0.2, "--report", "report.json")
                bounds = read(self.path("out.vtp")).GetBounds()
                self.assertAlmostEqual(bounds[0], 92.5, 0)
                self.assertAlmostEqual(bounds[1], 107.5, 0)
                self.assertGreater(self.report()["output"]["volume"], 1000.0)
                self.assertEqual(self.report()["command_line"]["iso"], "226")

    def test_a_whole_value_makes_no_triangles_without_area(self):
        image = ball()
        values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
        values[:] = (values / 226).round() * 226  # many voxels have the very value
        self.write(image, self.path("whole.vti"))
        said = self.succeed("whole.vti", "out.vtp", "--iso", 226, "--max-error", 0.1, "--report", "report.json").stdout
        self.assertEqual(self.report()["input"]["dropped_triangles"], 0)
        self.assertNotIn("without area", said)

    def test_voxels_of_a_preset_are_those_of_the_header(self):
        image = ball()
        image.SetSpacing(1.5, 0.75, 0.9)
        for name in ("spaced.mha", "spaced.vti"):
            self.write(image, self.path(name))
            self.succeed(name, "out.vtp", "--iso", "bone", "--max-error", "halfvoxel", "--measure", "off", "--report", "report.json")
            report = self.report()
            self.assertAlmostEqual(report["voxel"]["size"], 0.75)
            self.assertAlmostEqual(report["proof"]["tolerance"], 0.375)
            self.assertEqual((report["command_line"]["iso"], report["command_line"]["preset"]), ("226", "HalfVoxel"))

    def test_volume_tells_the_voxels_of_a_preset(self):
        words = ("--iso", 226, "--preset", "half-voxel", "--report", "report.json")
        self.succeed("ct.vti", "out.vtp", *words)
        self.assertEqual(self.report()["voxel"]["from"], "given")
        self.assertEqual(self.report()["proof"]["tolerance"], 0.5)
        self.assertEqual(self.report()["proof"]["status"], "proved")

    def test_volume_needs_a_value(self):
        self.fail_with(USAGE, "ct.vti", "out.vtp", says="--iso")

    def test_value_beyond_the_volume_is_rejected(self):
        self.fail_with(REJECTED, "ct.vti", "out.vtp", "--iso", 5000)

    def test_damaged_volume_is_rejected(self):
        for name in ("ct.vti", "ct.mha"):
            whole = self.path(name).read_bytes()
            self.path(name).write_bytes(whole[: len(whole) // 2])
            self.fail_with(REJECTED, name, "out.vtp", "--iso", 226)

    def reject_labels(self, name, says):
        for iso in (0.5, 1.5):
            completed = self.fail_with(REJECTED, name, "out.vtp", "--iso", iso, says=says)
            self.assertIn("label map", completed.stderr)

    def test_label_maps_are_rejected_with_the_way_to_go(self):
        self.path("two.seg.nrrd").write_bytes(segmentation((1, 2)))
        self.reject_labels("two.seg.nrrd", "with the labels 1, 2,")
        self.path("layers.seg.nrrd").write_bytes(segmentation((1, 1), layers=2))
        self.reject_labels("layers.seg.nrrd", "with the labels 1, 2,")
        for name in ("map.mha", "map.vti"):
            for kind in (vtk.VTK_UNSIGNED_CHAR, vtk.VTK_SHORT, vtk.VTK_FLOAT):
                with self.subTest(name=name, kind=kind):
                    self.write(labeled((3, 17, 4), kind=kind), self.path(name))
                    self.reject_labels(name, "with the labels 3, 4, 17,")
        self.write(labeled((1, 2, 3, 4, 5, 6, 7, 8)), self.path("many.mha"))
        self.reject_labels("many.mha", "1, 2, 3, 4, 5 and 3 more")
        self.fail_with(REJECTED, "many.mha", "out.vtp", "--iso", 0.5, says="--intensities on")

    def test_label_maps_can_be_taken_for_intensities_on_request(self):
        self.write(labeled((1, 2)), self.path("map.mha"))
        words = ("--iso", 0.5, "--intensities", "on", "--report", "report.json")
        self.succeed("map.mha", "out.vtp", *words)
        self.assertEqual(self.report()["command_line"]["intensities"], "on")
        self.fail_with(REJECTED, "map.mha", "out.vtp", "--iso", 0.5, "--intensities", "off", says="label map")
        self.fail_with(USAGE, "map.mha", "out.vtp", "--iso", 0.5, "--intensities", "yes", says="--intensities")
        self.fail_with(USAGE, "out.vtp", "again.vtp", "--intensities", "on", says="together with --iso")
        self.path("maps").mkdir()
        self.write(labeled((1, 2)), self.path("maps/map.mha"))
        self.succeed("maps", "out", "--iso", 0.5, "--intensities", "on")
        self.assertTrue(self.path("out/map.vtp").exists())

    def test_masks_are_taken_with_a_note(self):
        for label, iso in ((1, 0.5), (255, 127.5)):
            for name in ("mask.mha", "mask.vti"):
                self.write(labeled((label,)), self.path(name))
                text = self.succeed(name, "out.vtp", "--iso", iso).stdout
                self.assertIn(f"its values are 0 and {label} alone: a mask", text)
        self.path("one.seg.nrrd").write_bytes(segmentation((1,)))
        self.assertIn("a mask", self.succeed("one.seg.nrrd", "out.vtp", "--iso", 0.5).stdout)

    def test_intensities_are_never_taken_for_labels(self):
        """Whole numbers that are not negative, in all the ways in which intensities are stored so."""
        generator = random.Random(1)
        noisy = ball(16)
        for window in (255, 15, 7):
            scalars = noisy.GetPointData().GetScalars()
            values = vtk.vtkUnsignedCharArray()
            for i in range(scalars.GetNumberOfTuples()):
                fraction = (scalars.GetTuple1(i) + 1000.0) / 2000.0 + generator.gauss(0.0, 0.07)
                values.InsertNextValue(int(max(0.0, min(1.0, fraction)) * window))
            image = vtk.vtkImageData()
            image.SetDimensions(noisy.GetDimensions())
            image.GetPointData().SetScalars(values)
            for name in ("window.mha", "window.vti"):
                self.write(image, self.path(name))
                text = self.succeed(name, "out.vtp", "--iso", 0.61 * window).stdout
                self.assertNotIn("mask", text)
        for kind, shift in ((vtk.VTK_UNSIGNED_SHORT, 1000), (vtk.VTK_SHORT, 0)):
            shifted = vtk.vtkImageShiftScale()
            shifted.SetInputData(ball())
            shifted.SetShift(shift)
            shifted.SetOutputScalarType(kind)
            shifted.Update()
            self.write(shifted.GetOutput(), self.path("ct.mha"))
            self.assertNotIn("mask", self.succeed("ct.mha", "out.vtp", "--iso", 226 + shift).stdout)
        tissues = labeled((40, 700), kind=vtk.VTK_SHORT, background=-1000)
        self.write(tissues, self.path("tissues.mha"))
        self.succeed("tissues.mha", "out.vtp", "--iso", 300)

    def test_nifti_that_is_none_is_rejected(self):
        for name in ("scan.nii", "scan.nii.gz"):
            self.path(name).write_bytes(b"\x5c\x01\0\0")
            self.fail_with(REJECTED, name, "out.vtp", "--iso", 226, says="it is not a NIfTI-1 file")

    def write_tiff(self):
        writer = vtk.vtkTIFFWriter()
        writer.SetFileDimensionality(3)
        writer.SetFileName(str(self.path("ct.tif")))
        shifted = vtk.vtkImageShiftScale()
        shifted.SetInputData(ball())
        shifted.SetShift(1000)
        shifted.SetOutputScalarTypeToUnsignedShort()
        writer.SetInputConnection(shifted.GetOutputPort())
        writer.Write()

    def test_tiff_has_the_requested_spacing(self):
        self.write_tiff()
        self.fail_with(REJECTED, "ct.tif", "out.vtp", "--iso", 1226, says="give --spacing X,Y,Z in mm")
        for words, heights in (("0.5", 7.5), ("0.5,0.5,2", 30)):
            self.succeed("ct.tif", "out.vtp", "--iso", 1226, "--spacing", words, "--report", "report.json")
            bounds = read(self.path("out.vtp")).GetBounds()
            self.assertAlmostEqual(bounds[1] - bounds[0], 7.5, 0)
            self.assertAlmostEqual(bounds[5] - bounds[4], heights, 0)
            self.assertEqual(self.report()["command_line"]["spacing"], words)
        self.path("scans").mkdir()
        self.write_ball(self.path("scans/ct.mha"))
        self.path("ct.tif").rename(self.path("scans/micro.tif"))
        self.succeed("scans", "out", "--iso", 1226 - 1000, "--spacing", 0.5)
        self.assertTrue(self.path("out/micro.vtp").exists())

    def test_spacing_is_rejected_where_it_has_no_effect(self):
        self.write_tiff()
        self.path("scans").mkdir()
        self.write_ball(self.path("scans/ct.mha"))
        for words in (("ct.mha", "out.vtp", "--iso", 226), ("scans", "out", "--iso", 226)):
            self.fail_with(USAGE, *words, "--spacing", 0.5, says="--spacing has no effect")
        self.fail_with(USAGE, "ct.tif", "out.vtp", "--iso", 226, "--spacing", "1,2", says="one or three numbers")
        self.fail_with(USAGE, "ct.tif", "out.vtp", "--iso", 226, "--spacing", 0, says="--spacing")

    def test_output_says_its_coordinate_system(self):
        text = self.succeed("ct.mha", "out.vtp", "--iso", 226, "--report", "report.json").stdout
        self.assertIn("coordinates     LPS", text)
        self.assertEqual(self.report()["files"]["coordinate_system"], "LPS")
        self.succeed("out.vtp", "again.vtp", "--report", "report.json")
        self.assertNotIn("coordinate_system", self.report()["files"])

    def test_cavities_are_filled_up_to_a_volume_on_request(self):
        image = ball()
        for x, size in ((9, 1), (13, 2)):  # of 1 and 8 voxels
            for i in range(size ** 3):
                image.SetScalarComponentFromDouble(x + i % size, 11 + i // size % size, 11 + i // size ** 2, 0, -50.0)
        self.write(image, self.path("ct.mha"))
        words = ("ct.mha", "out.vtp", "--iso", 226.5, "--target-reduction", 0, "--measure", "off", "--report", "report.json")
        for limit, components, filled in ((None, 3, None), (1, 2, 1), (7.5, 2, 1), (8, 1, 9)):
            text = self.succeed(*words, *(("--fill-volume", limit) if limit else ())).stdout
            self.assertEqual(self.report()["output"]["components"], components)
            changed = self.report().get("changed_before", {}).get("cavities_filled", {})
            self.assertEqual(changed.get("voxels"), filled)
        self.assertIn("volume          2 cavities of 9 voxels (9.00 mm3) filled\n", text)
        self.write_ball(self.path("whole.mha"))
        self.succeed("whole.mha", "whole.vtp", *words[2:])
        points = [numpy_support.vtk_to_numpy(read(self.path(name)).GetPoints().GetData()) for name in ("out.vtp", "whole.vtp")]
        self.assertEqual(points[0].tolist(), points[1].tolist())

    def test_volumes_of_a_batch(self):
        self.path("scans").mkdir()
        self.write_ball(self.path("scans") / "ct.vti")
        self.succeed("scans", "out", "--iso", 226)
        self.assertGreater(read(self.path("out/ct.vtp")).GetNumberOfPolys(), 4)
        self.assertIn("by an earlier run", self.succeed("scans", "out", "--iso", 226).stdout)
        self.fail_with(USAGE, "scans", "out", "--iso", 300, says="1 result of other options, the first is 'ct' (--iso 226)")
        self.succeed("certify", "scans", "out", "--iso", 226)
        self.fail_with(REJECTED, "certify", "scans", "out", says="no surface is in it; --iso takes the bone surface of CT volumes")
        self.fail_with(REJECTED, "scans", "none", says="no surface")


if __name__ == "__main__":
    main()
