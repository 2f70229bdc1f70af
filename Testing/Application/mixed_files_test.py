# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that hold less than others of their kind: some points without texture coordinates, alpha of another type, a spacing that is
not known, voxels of one bit, segments of which one covers another; and outputs that must not replace what a run reads."""

import numpy as np
import vtk

from application import REJECTED, USAGE, ApplicationTest, main, read, sphere, torus, write
from label_maps import blocks, write_map


def positions(surface):
    return [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]


def layers_nrrd(names, layers):
    """A .seg.nrrd with a layer for each segment; layers are (z, y, x) arrays of 0 and 1."""
    size = layers[0].shape[0]
    header = (f"NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: {len(layers)} {size} {size} {size}\n"
              "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nendian: little\nencoding: raw\nspace origin: (0,0,0)\n")
    for i, name in enumerate(names):
        header += f"Segment{i}_ID:=Segment_{i}\nSegment{i}_Name:={name}\nSegment{i}_LabelValue:=1\nSegment{i}_Layer:={i}\n"
    return header.encode() + b"\n" + np.stack(layers, axis=-1).astype(np.uint8).tobytes()


class MixedFiles(ApplicationTest):
    def test_points_without_texture_coordinates_are_written(self):
        ball = sphere()
        lines = [f"v {x} {y} {z}" for x, y, z in positions(ball)] + ["vt 0.25 0.75"] * ball.GetNumberOfPoints()
        for cell in range(ball.GetNumberOfCells()):
            ids = [ball.GetCell(cell).GetPointId(k) + 1 for k in range(3)]
            lines.append("f " + " ".join(f"{i}/{i}" if max(ids) < 200 else str(i) for i in ids))
        self.path("half.obj").write_text("\n".join(lines) + "\n", encoding="ascii")
        self.succeed("half.obj", "out.obj", "--max-error", 0.2)
        text = self.path("out.obj").read_text(encoding="ascii")
        points = text.count("\nv ")
        self.assertEqual(text.count("\nvt "), points)
        self.assertIn("\nvt 0.25 0.75", text)
        self.assertRegex(text, r"\nf \d+ \d+ \d+")
        self.assertEqual(read(self.path("out.obj")).GetNumberOfCells(), text.count("\nf "))

    def test_alpha_of_another_type_leaves_colors_as_they_are(self):
        ball = sphere()
        header = f"ply\nformat ascii 1.0\nelement vertex {ball.GetNumberOfPoints()}\n"
        header += "".join(f"property float {axis}\n" for axis in "xyz") + "".join(f"property uchar {color}\n" for color in ("red", "green", "blue"))
        header += f"property float alpha\nelement face {ball.GetNumberOfCells()}\nproperty list uchar int vertex_indices\nend_header\n"
        rows = [f"{x} {y} {z} 100 50 25 1.0" for x, y, z in positions(ball)]
        rows += ["3 " + " ".join(str(ball.GetCell(c).GetPointId(k)) for k in range(3)) for c in range(ball.GetNumberOfCells())]
        self.path("a.ply").write_text(header + "\n".join(rows) + "\n", encoding="ascii")
        self.succeed("a.ply", "a.vtp", "--target-triangles", 200)
        colors = read(self.path("a.vtp")).GetPointData().GetArray("RGB")
        self.assertEqual(colors.GetTuple(0), (100.0, 50.0, 25.0))

    def test_a_spacing_that_is_partly_unknown_is_none(self):
        header = "NRRD0004\ntype: unsigned char\ndimension: 3\nsizes: 12 12 12\nspacings: 0.5 0.5 nan\nencoding: raw\nendian: little\n\n"
        voxels = np.zeros((12, 12, 12), np.uint8)
        voxels[3:9, 3:9, 3:9] = 200
        self.path("nan.nrrd").write_bytes(header.encode() + voxels.tobytes())
        run = ("nan.nrrd", "nan.vtp", "--iso", 100, "--target-reduction", 0)
        self.succeed(*run, "--spacing", 0.5)
        bounds = read(self.path("nan.vtp")).GetBounds()
        self.assertLess(max(bounds[1::2]) - min(bounds[0::2]), 4.0)

    def test_voxels_of_one_bit_are_rejected(self):
        image = vtk.vtkImageData()
        image.SetDimensions(8, 8, 8)
        bits = vtk.vtkBitArray()
        bits.SetName("bits")
        bits.SetNumberOfValues(512)
        for i in range(512):
            bits.SetValue(i, int(100 < i < 300))
        image.GetPointData().SetScalars(bits)
        writer = vtk.vtkXMLImageDataWriter()
        writer.SetFileName(str(self.path("bit.vti")))
        writer.SetInputData(image)
        writer.Write()
        self.fail_with(REJECTED, "bit.vti", "bit.vtp", "--iso", 0.5, says="its voxels are single bits")

    def test_segments_that_were_not_chosen_cover_nothing_even_if_a_word_could_mean_them(self):
        outer, inner = (np.zeros((20, 20, 20), bool) for _ in range(2))
        outer[3:17, 3:17, 3:17] = inner[7:13, 7:13, 7:13] = True
        for names, choice in ((("pelvis", "sacrum"), "pelvis"), (("bone,left", "left"), "bone,left")):
            self.path("s.seg.nrrd").write_bytes(layers_nrrd(names, (outer, inner)))
            self.succeed("s.seg.nrrd", "s.vtp", "--segments", choice, "--target-reduction", 0, "--report", "r.json")
            self.assertEqual(self.report("r.json")["output"]["components"], 1, choice)

    def test_a_batch_sees_that_the_voxels_of_a_header_changed(self):
        self.path("scans").mkdir()
        header = "NDims = 3\nDimSize = 24 24 24\nElementSpacing = 1 1 1\nElementType = MET_SHORT\nElementDataFile = a.raw\n"
        self.path("scans/a.mhd").write_text("ObjectType = Image\n" + header, encoding="ascii")
        away = sum((k - 12) ** 2 for k in np.indices((24, 24, 24)))
        volumes = []
        for squared in (90, 40, 40):
            self.path("scans/a.raw").write_bytes(np.where(away < squared, 1000, 0).astype("<i2").tobytes()) if len(volumes) < 2 else None
            completed = self.succeed("scans", "out", "--iso", 500, "--max-error", 0.5)
            self.assertEqual("by an earlier run" in completed.stdout, len(volumes) == 2)
            volumes.append(self.report("out/a.json")["output"]["volume"])
        self.assertLess(volumes[1], volumes[0] / 2)

    def test_slices_may_be_numbered_by_tens(self):
        self.path("slices").mkdir()
        for i in range(12):
            image = vtk.vtkImageData()
            image.SetDimensions(12, 12, 1)
            image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
            for x in range(12):
                for y in range(12):
                    image.SetScalarComponentFromDouble(x, y, 0, 0, 200 if all(3 < k < 9 for k in (x, y, i)) else 0)
            writer = vtk.vtkTIFFWriter()
            writer.SetFileName(str(self.path(f"slices/s{10 * i + 1}.tif")))
            writer.SetInputData(image)
            writer.Write()
        self.succeed("slices", "out.vtp", "--iso", 100, "--spacing", 1, "--target-reduction", 0)


class Overwriting(ApplicationTest):
    def test_no_output_replaces_the_surface_of_a_segment(self):
        write_map(blocks(5, 7), self.path("map.mha"))
        self.fail_with(USAGE, "map.mha", "out/", "--segments", "all", "--format", "vtp", "--max-error", 0.5, "--heatmap", "out/label_5.vtp",
                       says="would be written twice")

    def test_no_report_replaces_a_table_that_the_run_reads(self):
        write_map(blocks(5), self.path("map.mha"))
        self.path("names.json").write_text('{"labels": {"femur": 5}}', encoding="ascii")
        self.fail_with(USAGE, "map.mha", "out.vtp", "--segments", "all", "--max-error", 0.5, "--label-names", "names.json", "--report", "names.json",
                       says="'names.json' is an input")

    def test_the_demo_replaces_no_file_but_its_own(self):
        self.path("mine").mkdir()
        self.path("mine/ct.mha").write_bytes(b"my own scan")
        completed = self.run_program("demo", "mine")
        self.assertEqual((completed.returncode, self.path("mine/ct.mha").read_bytes()), (USAGE, b"my own scan"))

    def test_values_of_options_of_3d_slicer_keep_their_underscores(self):
        write(torus(), self.path("in.vtp"))
        self.succeed("--returnparameterfile", "r.txt", "in.vtp", "out.vtp", "--max_error", 0.5, "--report=my_report.json")
        self.assertTrue(self.path("my_report.json").is_file())

    def test_a_preset_limits_the_error_within_a_region_of_3d_slicer(self):
        write(torus(), self.path("in.vtp"))
        self.succeed("--returnparameterfile", "r.txt", "in.vtp", "out.vtp", "--max_error", 0, "--preset", "HalfVoxel", "--voxel_size", 1,
                     "--roi", "0,0,0,50,50,50")
        self.assertLess(read(self.path("out.vtp")).GetNumberOfCells(), 1900)


if __name__ == "__main__":
    main()
