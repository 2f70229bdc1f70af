# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume that is larger than --memory: processed in slabs, within the largest error of the whole."""

import numpy
import vtk

from application import REJECTED, USAGE, ApplicationTest, main, read

RUN = ("--iso", 127.5, "--mode", "Fast", "--max-error", 0.5)


def write(path, voxels, element, kept=1.0):
    """With voxels of 1 mm."""
    header = ("ObjectType = Image\nNDims = 3\nDimSize = {2} {1} {0}\nElementType = {3}\n"
              "ElementSpacing = 1 1 1\nOffset = 10 20 30\nElementDataFile = LOCAL\n").format(*voxels.shape, element)
    path.write_bytes(header.encode() + voxels.tobytes()[:int(kept * voxels.nbytes)])


def write_column(path):
    """A column with a wall in it between segments 3 and 8, in 134 MB of voxels."""
    voxels = numpy.zeros((420, 200, 200))
    z, y, x = numpy.ix_(range(420), range(200), range(200))
    inside = numpy.hypot(x - 40.0 - 4.0 * numpy.sin(0.05 * z), y - 30.0) < 6.3
    voxels[inside & (abs(z - 150) < 50)] = 3
    voxels[inside & (abs(z - 150) < 50) & (x > 41)] = 8
    write(path, voxels, "MET_DOUBLE")


def write_network(path, size, kept=1.0):
    """A gyroid with noise."""
    phase = 2.0 * numpy.pi * numpy.arange(size) / 40.0
    sine, cosine = numpy.sin(phase), numpy.cos(phase)
    z, y, x = numpy.ix_(range(size), range(size), range(size))
    field = sine[x] * cosine[y] + sine[y] * cosine[z] + sine[z] * cosine[x]
    noise = numpy.random.default_rng(1).integers(-8, 9, field.shape)
    voxels = numpy.clip(128.0 + 400.0 * field + noise, 0, 255).astype(numpy.uint8)
    write(path, voxels, "MET_UCHAR", kept)


def open_edges(path):
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(read(path))
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput()


class Memory(ApplicationTest):
    def test_slabs_keep_the_error_of_the_whole(self):
        size = 86
        write_network(self.path("a.mha"), size)
        text = self.succeed("a.mha", "slabs.vtp", *RUN, "--memory", "256M", "--report", "report.json").stdout
        report = self.report()
        self.assertRegex(text, r"slabs +\d+ of up to [\d,]+ triangles")
        self.assertGreater(report["slabs"]["count"], 2)
        self.assertEqual(report["slabs"]["unproved"], 0)
        self.assertEqual(report["proof"]["status"], "proved")
        self.assertEqual(report["proof"]["boundaries"], "both")
        self.assertEqual(report["proof"]["files"], {"slabs.vtp": "same_bits"})
        self.assertEqual(report["output"]["triangles"], read(self.path("slabs.vtp")).GetNumberOfPolys())
        self.succeed("a.mha", "whole.vtp", "--iso", 127.5, "--mode", "Fast", "--target-reduction", 0)
        self.assertEqual(report["input"]["triangles"], read(self.path("whole.vtp")).GetNumberOfPolys())
        self.succeed("certify", "whole.vtp", "slabs.vtp", "--tolerance", 0.5)
        boundary = open_edges(self.path("slabs.vtp"))  # at the ends of the volume, not between slabs
        self.assertGreater(boundary.GetNumberOfPoints(), 0)
        for i in range(boundary.GetNumberOfPoints()):
            p = boundary.GetPoint(i)
            self.assertTrue(any(abs(p[k] - end) < 0.51 for k, first in enumerate((10, 20, 30))
                                for end in (first, first + size - 1)), p)

    def test_segments_in_slabs_keep_the_error_of_the_whole(self):
        write_column(self.path("a.mha"))
        run = ("--segments", "all", "--mode", "Fast", "--format", "vtp")
        self.succeed("a.mha", "slabs", *run, "--max-error", 0.45, "--memory", "256M", "--report", "report.json")
        report = self.report()
        self.assertGreater(report["slabs"]["count"], 2)
        self.assertEqual(report["proof"]["status"], "proved")
        self.succeed("a.mha", "whole", *run, "--target-reduction", 0, "--report", "report.json")
        self.assertEqual(report["input"]["triangles"], self.report()["input"]["triangles"])
        self.assertLess(report["output"]["triangles"], report["input"]["triangles"] / 5)
        for label, others in ((3, {0, 8}), (8, {0, 3})):
            name = f"label_{label}.vtp"
            self.succeed("certify", f"whole/{name}", f"slabs/{name}", "--tolerance", 0.45)
            self.assertEqual(open_edges(self.path("slabs") / name).GetNumberOfCells(), 0)
            labels = read(self.path("slabs") / name).GetCellData().GetArray("OtherLabel")
            self.assertEqual({labels.GetTuple1(i) for i in range(labels.GetNumberOfTuples())}, others)

    def test_a_volume_that_fits_is_processed_as_a_whole(self):
        write_network(self.path("a.mha"), 40)
        self.succeed("a.mha", "a.ply", *RUN, "--memory", "4G", "--report", "report.json")
        self.succeed("a.mha", "b.ply", *RUN)
        self.assertNotIn("slabs", self.report())
        self.assertEqual(self.path("a.ply").read_bytes(), self.path("b.ply").read_bytes())

    def test_files_that_are_cut_off_leave_nothing(self):
        write_network(self.path("a.mha"), 40, kept=0.7)
        self.fail_with(REJECTED, "a.mha", "a.ply", *RUN, "--memory", "256M", says="truncated")

    def test_takes_a_size(self):
        write_network(self.path("a.mha"), 20)
        for size in ("4", "x", "", "-4G", "255M", "nanG", "4GG"):
            self.fail_with(USAGE, "a.mha", "a.ply", *RUN, "--memory", size, says="takes a size")

    def test_what_slabs_do_not_have_is_rejected(self):
        write_network(self.path("a.mha"), 20)
        for words, says in (
            (("--page", "a.html"), "--page"),
            (("--heatmap", "a.vtp"), "--heatmap"),
            (("--region", "rest=0.1"), "--region"),
            (("--fill-volume", 9), "--fill-volume"),
            (("--smooth", "0.1"), "smooth"),
            (("--close-tunnels", 2), "does not close tunnels"),
            (("--target-triangles", 100), "number of triangles"),
            (("--labels", "bone"), "--labels"),
        ):
            self.fail_with(USAGE, "a.mha", "a.ply", *RUN, "--memory", "4G", *words, says=says)
        self.fail_with(USAGE, "a.mha", "a.ply", "--iso", 127.5, "--memory", "4G", says="needs a --max-error, in a mode")
        self.fail_with(USAGE, "a.mha", "a", "--segments", "all", "--memory", "4G", says="needs a --max-error, in a mode")
        self.fail_with(USAGE, "a.mha", "a", "--segments", "all", "--max-error", 0.4, "--memory", "4G", "--page", "a.html",
                       says="--page")


if __name__ == "__main__":
    main()
