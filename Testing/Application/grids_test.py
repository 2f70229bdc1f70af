# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Label maps and scans on grids of a tilted gantry, and of slices whose spacing changes: every voxel kept where it is, bounds in mm."""

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from application import REJECTED, ApplicationTest, main, read, write
from volume_headers_test import nifti, slice_file
from voxel_oracle import largest_distance, wrong_voxels

SIZE = 24
TILT = numpy.array([0.0, numpy.sin(0.35), numpy.cos(0.35)])  # 20 degrees
UNEVEN = numpy.array([1.5 * k if k < 14 else 21 + 4 * (k - 14) for k in range(SIZE)])
EVEN = 1.5 * numpy.arange(SIZE)
# Direction of the third axis, and mm along it of each layer.
GRIDS = {"uneven": (numpy.array([0.0, 0.0, 1.0]), UNEVEN), "tilted": (TILT, EVEN), "both": (TILT, UNEVEN)}
VOXELS = ("--segments", "all", "--mode", "Fast", "--measure", "off", "--report", "report.json")
HALF = ("--max-error", "halfvoxel")
VIOLATED = 6


def head():
    """A shell (1) around a core (2) that touches it, with noise; indices z, y, x."""
    z, y, x = numpy.indices((SIZE, SIZE, SIZE)) - 11.5
    noise = numpy.random.default_rng(3).uniform(-0.6, 0.6, z.shape)
    r = numpy.sqrt(x**2 + y**2 + z**2) + noise
    labels = numpy.zeros(z.shape, int)
    labels[(r > 7) & (r < 9.5)] = 1
    labels[((numpy.abs(x) < 2) | (r < 3)) & (r <= 7)] = 2
    return labels


def matrix_of(axis):
    """From (i, j, mm along the third axis) to mm."""
    matrix = numpy.eye(4)
    matrix[:3, 2] = axis
    return matrix


class Grids(ApplicationTest):
    def write_slices(self, folder, images, axis, layers, value=lambda label: label + 1024):
        """A series of slices, each where it lies."""
        self.path(folder).mkdir()
        for k, (image, height) in enumerate(zip(images, layers)):
            position = "\\".join(f"{each:.10g}" for each in axis * height)
            data = slice_file(value(image), 0, k, more={(0x20, 0x32): ("DS", position)})
            self.path(f"{folder}/{k:03d}.dcm").write_bytes(data)

    def each_grid(self):
        for name, (axis, layers) in GRIDS.items():
            if not self.path(name).exists():
                self.write_slices(name, head(), axis, layers)
            yield name, matrix_of(axis), layers

    def expect_voxels(self, folder, matrix, layers, labels=None):
        labels = head() if labels is None else labels
        for label in numpy.unique(labels[labels > 0]):
            surface = read(self.path(f"{folder}/label_{label}.vtp"))
            self.assertGreater(surface.GetNumberOfCells(), 100)
            self.assertEqual(wrong_voxels(surface, labels == label, matrix, layers), 0)

    def test_smoothing_and_simplification_keep_every_voxel_where_it_is(self):
        for name, matrix, layers in self.each_grid():
            self.succeed(name, f"{name}0.vtp", "--segments", "all", "--measure", "off", "--target-reduction", 0)
            self.succeed(name, f"{name}-out.vtm", *VOXELS, *HALF, "--smooth", "auto")
            self.assertEqual((self.report()["voxels"]["guard"], self.report()["voxels"]["changed"]), ("on", 0))
            self.expect_voxels(f"{name}-out", matrix, layers)
            self.succeed(name, f"{name}1.vtp", "--segments", "all", *HALF, "--smooth", "auto", "--measure", "off", "--report", "report.json")
            distance = largest_distance(read(self.path(f"{name}0.vtp")), read(self.path(f"{name}1.vtp")))
            self.assertGreater(distance, 0.2)
            proof = self.report()["proof"]
            self.assertEqual(proof["status"], "proved")
            self.assertLessEqual(distance, proof["upper"] + 1e-5)
            self.assertLessEqual(proof["upper"], 0.5)

    def test_errors_beyond_a_voxel_keep_every_voxel_on_request(self):
        for name, matrix, layers in self.each_grid():
            for smooth in ("0", "auto"):
                self.succeed(name, f"{name}-{smooth}.vtm", *VOXELS, "--max-error", 5, "--keep-voxels", "On", "--smooth", smooth)
                self.expect_voxels(f"{name}-{smooth}", matrix, layers)
            self.succeed(name, f"{name}-off.vtm", *VOXELS, "--max-error", 2, "--keep-voxels", "Off")
            changed = sum(wrong_voxels(read(self.path(f"{name}-off/label_{label}.vtp")), head() == label, matrix, layers) for label in (1, 2))
            self.assertGreater(changed, 0)

    def test_slabs_keep_every_voxel(self):
        for name, matrix, layers in self.each_grid():
            self.succeed(name, f"{name}-slabs/", "--segments", "all", *HALF, "--memory", "256M", "--measure", "off")
            self.expect_voxels(f"{name}-slabs", matrix, layers)

    def test_certify_counts_voxels_where_they_are(self):
        for name, _, _ in self.each_grid():
            self.succeed(name, f"{name}.vtp", *VOXELS, *HALF)
            self.assertEqual(self.run_program("certify", f"{name}.vtp", "--labels", name, "--quiet").returncode, 0)
            transform = vtk.vtkTransform()
            transform.Translate(0, 0, 0.8)
            moved = vtk.vtkTransformPolyDataFilter()
            moved.SetTransform(transform)
            moved.SetInputData(read(self.path(f"{name}.vtp")))
            moved.Update()
            write(moved.GetOutput(), self.path("moved.vtp"))
            self.assertEqual(self.run_program("certify", "moved.vtp", "--labels", name, "--quiet").returncode, VIOLATED)

    def test_saved_surfaces_know_the_grid(self):
        for name, matrix, layers in self.each_grid():
            self.succeed(name, f"{name}-whole.vtm", *VOXELS, "--max-error", 0.01)
            whole = f"{name}-whole/label_1.vtp"
            self.succeed(whole, "small.vtp", "--keep-voxels", "On", "--measure", "off")
            self.assertLess(read(self.path("small.vtp")).GetNumberOfCells(), 0.5 * read(self.path(whole)).GetNumberOfCells())
            self.assertEqual(wrong_voxels(read(self.path("small.vtp")), head() == 1, matrix, layers), 0)
            bare = vtk.vtkPolyData()
            bare.SetPoints(read(self.path(whole)).GetPoints())
            bare.SetPolys(read(self.path(whole)).GetPolys())
            write(bare, self.path("bare.stl"))
            self.succeed("bare.stl", "small.stl", "--label-map", name, "--label", 1, "--keep-voxels", "On", "--max-error", 1, "--measure", "off")
            self.assertEqual(wrong_voxels(read(self.path("small.stl")), head() == 1, matrix, layers), 0)

    def test_levels_and_files_of_parts_are_those_of_any_grid(self):
        for name, _, _ in self.each_grid():
            for output in ("g.glb", "m.3mf", "s.vtm"):
                self.succeed(name, output, *VOXELS, *HALF)
            self.fail_with(REJECTED, name, "t.vtp", *VOXELS, *HALF, "--close-tunnels", 3, says="close tunnels in the label map")
            self.succeed(name, "b.vtp", *VOXELS, "--max-error", 0.01)
            self.succeed("levels", "b.vtp", "--keep-voxels", "On", "--triangles", 400, "--output", "level.vtp", "--no-errors")

    def test_islands_and_cavities_have_the_volume_of_their_layers(self):
        """A voxel of a thin layer has 1.5 mm3, of a thick one 4; a tilt of 20 degrees takes 6 %."""
        labels = numpy.zeros((SIZE, SIZE, SIZE), int)
        labels[6:18, 6:18, 6:18] = labels[2, 2, 2] = labels[19, 2, 2] = 1
        for name, (axis, layers) in GRIDS.items():
            with self.subTest(grid=name):
                self.write_slices(f"islands-{name}", labels, axis, layers)
                self.succeed(f"islands-{name}", "out.vtm", *VOXELS, *HALF, "--prune-volume", 3)
                removed = self.report()["segments"]["list"][0]["changed_before"]["islands_removed"]
                thick = layers[20] - layers[19]
                count = 1 if thick * axis[2] > 3 else 2
                self.assertEqual((removed["count"], removed["voxels"]), (count, count))
                self.assertAlmostEqual(removed["volume"], count * 1.5 * axis[2], delta=1e-5)

    def test_sheared_files_of_all_formats_are_extracted_where_their_matrix_says(self):
        matrix = matrix_of(TILT)
        matrix[:3, :3] *= [0.8, 0.9, 1.5]
        ras = numpy.diag([-1.0, -1.0, 1.0, 1.0]) @ matrix
        labels = head()
        self.path("map.nii").write_bytes(nifti(labels.transpose(), matrix=ras))
        columns = [" ".join(f"{each:.17g}" for each in column) for column in matrix[:3, :3].T]
        nrrd = ("NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 24 24 24\nspace directions: "
                + " ".join(f"({','.join(column.split())})" for column in columns)
                + "\nkinds: domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n\n")
        self.path("map.nrrd").write_bytes(nrrd.encode() + labels.astype("u1").tobytes())
        lengths = numpy.linalg.norm(matrix[:3, :3], axis=0)
        directions = " ".join(f"{each:.17g}" for each in (matrix[:3, :3] / lengths).T.ravel())
        meta = (f"ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix = {directions}\nOffset = 0 0 0\n"
                f"ElementSpacing = {lengths[0]} {lengths[1]} {lengths[2]}\nDimSize = 24 24 24\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n")
        self.path("map.mha").write_bytes(meta.encode() + labels.astype("u1").tobytes())
        steps = matrix.copy()
        steps[:3, 2] /= 1.5
        for name in ("map.nii", "map.nrrd", "map.mha"):
            with self.subTest(name=name):
                self.succeed(name, f"{name}-out.vtm", *VOXELS, *HALF, "--smooth", "auto")
                self.expect_voxels(f"{name}-out", steps, EVEN)

    def vti(self, name, layers):
        image = vtk.vtkImageData()
        image.SetDimensions(SIZE, SIZE, SIZE)
        image.GetPointData().SetScalars(numpy_to_vtk(head().astype("u1").ravel(), deep=True))
        array = numpy_to_vtk(numpy.asarray(layers, float), deep=True)
        array.SetName("VoxelGridLayers")
        image.GetFieldData().AddArray(array)
        writer = vtk.vtkXMLImageDataWriter()
        writer.SetFileName(str(self.path(name)))
        writer.SetInputData(image)
        writer.Write()

    def test_vtk_images_say_where_their_layers_are(self):
        self.vti("map.vti", UNEVEN)
        self.succeed("map.vti", "out.vtm", *VOXELS, *HALF)
        self.expect_voxels("out", numpy.eye(4), UNEVEN)
        for wrong in (UNEVEN[:-1], UNEVEN[::-1], UNEVEN + 1, [*UNEVEN[:5], numpy.nan, *UNEVEN[6:]]):
            self.vti("wrong.vti", wrong)
            self.fail_with(REJECTED, "wrong.vti", "none/", *VOXELS, *HALF, says="its array VoxelGridLayers has no position for each of its layers")

    def test_scans_fill_cavities_of_their_volume(self):
        labels = head()
        shell = (labels > 0).astype(int) * 1600 + 100
        shell[8:10, 11:13, 11:13] = 1700
        shell[9, 11, 11] = 100
        for name, (axis, layers) in GRIDS.items():
            with self.subTest(grid=name):
                self.write_slices(f"scan-{name}", shell, axis, layers, value=lambda image: image)
                text = self.succeed(f"scan-{name}", "scan.vtp", "--iso", "bone", *HALF, "--fill-volume", 2, "--measure", "off").stdout
                self.assertRegex(text, r"cavit(y|ies) of ")


if __name__ == "__main__":
    main()
