# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--model-grid: label maps that were copied from the coarser grid of a network."""

import math

import numpy
import vtk
from vtk.util import numpy_support

from application import REJECTED, USAGE, ApplicationTest, main, read
from label_maps import write_map
from voxel_oracle import wrong_voxels

SAMPLES = (44, 40, 36)
SPACING = (0.7, 0.7, 0.8)  # of the file, mm
LENGTHS = (2.15, 2.3, 1.9)  # layers per sample
VIOLATED = 6


def model():
    """Three uneven bodies, x first."""
    x, y, z = numpy.meshgrid(*(numpy.arange(n, dtype=float) for n in SAMPLES), indexing="ij")
    labels = numpy.zeros(SAMPLES, numpy.uint8)
    for label, (center, radii) in enumerate((((13, 13, 17), (11, 10, 14)), ((31, 17, 12), (10, 13, 9)), ((25, 31, 25), (16, 7, 9))), 1):
        distance = sum(((v - c) / r) ** 2 for v, c, r in zip((x, y, z), center, radii))
        labels[distance + 0.2 * numpy.sin(x / 2 + label) * numpy.cos(y / 3) * numpy.sin(z / 2.5) < 1] = label
    return labels


def copied(convention):
    """The map of the file, and its cropped layers."""
    axes = []
    for samples, length in zip(SAMPLES, LENGTHS):
        layers = round(samples * length)
        i = numpy.arange(layers)
        position = {"corners": i * (samples - 1) / (layers - 1), "centers": (i + 0.5) * samples / layers - 0.5}.get(convention, (i + 0.3) / length)
        axes.append(numpy.clip(numpy.floor(position + 0.5).astype(int), 0, samples - 1))
        if convention == "crop":
            axes[-1] = axes[-1][5:-4]
    return model()[numpy.ix_(*axes)]


def image_of(labels):
    image = vtk.vtkImageData()
    image.SetDimensions(labels.shape)
    image.SetSpacing(SPACING)
    image.SetOrigin(-30.0, 12.0, 100.0)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(labels.ravel(order="F"), deep=True))
    return image


def field(surface, name):
    return numpy_support.vtk_to_numpy(surface.GetFieldData().GetArray(name)).ravel()


class ModelGrid(ApplicationTest):
    def write(self, convention):
        write_map(image_of(copied(convention)), self.path("map.mha"))

    def run_with(self, *words):
        return self.succeed("map.mha", "out.vtp", "--segments", "all", "--max-error", "halfvoxel", "--report", "report.json", *words)

    def test_the_map_of_the_network_is_kept(self):
        for convention in ("corners", "centers", "crop"):
            with self.subTest(convention):
                self.write(convention)
                text = self.run_with("--smooth", "auto").stdout
                report = self.report()
                self.assertIn("model grid      the label map is a copy of one with voxels of", text)
                self.assertEqual((report["voxels"]["changed"], report["model_grid"]["changed_copies"]), (0, 0))
                self.assertLess(report["model_grid"]["chance"], 1e-6)
                for found, length, spacing in zip(report["model_grid"]["spacing"], LENGTHS, SPACING):
                    self.assertAlmostEqual(found / spacing, length, delta=0.05)
                of_file = report["model_grid"]["voxels_of_file"]
                self.assertGreater(of_file["changed"], 0)
                self.assertLess(of_file["changed"], 0.1 * of_file["compared"])
                self.check_by_vtk(convention)
                self.check_certificate(of_file)
                self.check_distance_to_file(report["model_grid"]["distance_to_file"], text)

    def check_by_vtk(self, convention):
        """The voxels of the network, each label alone, by VTK's stencil."""
        surface = read(self.path("out.vtp"))
        size, spacing, origin = (field(surface, f"VoxelGrid{name}") for name in ("Dimensions", "Spacing", "Origin"))
        axes = []
        for k in range(3):
            center = (origin[k] - (-30.0, 12.0, 100.0)[k] + spacing[k] * numpy.arange(size[k])) / SPACING[k]
            axes.append(numpy.clip(numpy.rint(center).astype(int), 0, copied(convention).shape[k] - 1))
        labels = copied(convention)[numpy.ix_(*axes)].transpose()
        matrix = numpy.diag([spacing[0], spacing[1], 1.0, 1.0])
        matrix[:3, 3] = origin
        sides = numpy_support.vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels"))
        for label in (1, 2, 3):
            one = vtk.vtkPolyData()
            one.SetPoints(surface.GetPoints())
            triangles = vtk.vtkCellArray()
            for cell in numpy.flatnonzero((sides == label).any(axis=1)):
                corners = surface.GetCell(int(cell)).GetPointIds()
                order = (0, 1, 2) if sides[cell][0] == label else (2, 1, 0)
                triangles.InsertNextCell(3, [corners.GetId(i) for i in order])
            one.SetPolys(triangles)
            self.assertEqual(wrong_voxels(one, labels == label, matrix, spacing[2] * numpy.arange(size[2])), 0)

    def check_certificate(self, of_file):
        text = self.succeed("certify", "out.vtp", "--labels", "map.mha", "--json", "voxels.json").stdout
        voxels = self.report("voxels.json")["voxels"]
        self.assertIn("model grid           the label map is a copy", text)
        self.assertEqual(voxels["changed"], 0)
        self.assertEqual(voxels["model_grid"]["changed_in_file"], of_file["changed"])

    def check_distance_to_file(self, bound, text):
        """Points of both surfaces by VTK's locators: none is farther, and some nearly as far."""
        self.succeed("map.mha", "file.vtp", "--segments", "all", "--model-grid", "off", "--max-error", "0.001")
        surfaces = [read(self.path(name)) for name in ("out.vtp", "file.vtp")]
        largest = 0.0
        for one, other in (surfaces, surfaces[::-1]):
            distances = vtk.vtkDistancePolyDataFilter()
            distances.SetInputData(0, one)
            distances.SetInputData(1, other)
            distances.SignedDistanceOff()
            distances.ComputeSecondDistanceOff()
            distances.Update()
            largest = max(largest, distances.GetOutput().GetPointData().GetScalars().GetRange()[1])
        self.assertLessEqual(largest, bound + 0.001)
        self.assertGreater(largest, 0.8 * bound)
        self.assertIn(f"the surface of these voxels is at most {math.ceil(100 * bound) / 100:.2f} mm away", text)

    def test_off_keeps_the_voxels_of_the_file(self):
        self.write("corners")
        text = self.run_with("--model-grid", "off").stdout
        self.assertNotIn("model grid", text)
        self.assertEqual(self.report()["voxels"]["changed"], 0)
        self.assertEqual(self.report("report.json").get("model_grid"), None)
        text = self.succeed("certify", "out.vtp", "--labels", "map.mha").stdout
        self.assertNotIn("model grid", text)

    def test_a_spacing_has_to_fit(self):
        self.write("centers")
        self.run_with("--model-grid", ",".join(f"{length * spacing:.2f}" for length, spacing in zip(LENGTHS, SPACING)))
        self.assertEqual(self.report()["voxels"]["changed"], 0)
        self.fail_with(REJECTED, "map.mha", "out.vtp", "--segments", "all", "--model-grid", 2.5, says="not a copy of one with the requested spacing")
        for text in ("1,2", "-1", "on", "0"):
            self.fail_with(USAGE, "map.mha", "out.vtp", "--segments", "all", "--model-grid", text, says="takes auto, off, or one or three")
        self.fail_with(USAGE, "out.vtp", "o.vtp", "--model-grid", "auto", says="--segments")

    def test_changed_voxels_of_the_network_are_found(self):
        self.write("corners")
        self.succeed("map.mha", "out.vtp", "--segments", "all", "--max-error", 2, "--keep-voxels", "off", "--report", "report.json")
        self.assertGreater(self.report()["voxels"]["changed"], 0)
        completed = self.run_program("certify", "out.vtp", "--labels", "map.mha")
        self.assertEqual(completed.returncode, VIOLATED)
        self.assertIn("model grid", completed.stdout)


if __name__ == "__main__":
    main()
