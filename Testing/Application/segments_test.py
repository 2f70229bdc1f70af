# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--segments: from a label map to the surfaces of its segments."""

import csv
import json
import os
import resource

import numpy
import vtk
from vtk.util import numpy_support

from application import NOT_WRITTEN, REJECTED, USAGE, ApplicationTest, limit, main, read, without_root_powers
from label_maps import write_map

SIZE = (22, 18, 16)
SPACING = (0.5, 0.5, 0.75)
ORIGIN = (-20.0, 7.0, 100.0)
NAMES_OF_FILES = {1: "Femur", 2: "knee___cap", 7: "label_7"}
NAMES = {1: "Femur", 2: "knee / cap", 7: ""}
COLORS = {1: (230, 200, 150), 2: (100, 150, 200), 7: (10, 250, 30)}
ISLAND = (19, 14, 13)  # a voxel of label 7


def voxels():
    """Two halves of an ellipsoid, 1 and 2, that touch, a block of 7 beside them, and a voxel of 7 apart from it."""
    x, y, z = numpy.meshgrid(*(numpy.arange(n) for n in SIZE), indexing="ij")
    inside = ((x - 7.2) / 5.5) ** 2 + ((y - 8.1) / 6.0) ** 2 + ((z - 7.4) / 5.8) ** 2 < 1
    labels = numpy.where(inside, numpy.where(x + 0.3 * y < 10, 1, 2), 0).astype(numpy.uint8)
    labels[15:19, 4:9, 4:10] = 7
    labels[ISLAND] = 7
    return labels


def label_map(labels=None, with_names=True, order=(7, 2, 1)):
    labels = voxels() if labels is None else labels
    image = vtk.vtkImageData()
    image.SetDimensions(labels.shape)
    image.SetSpacing(SPACING)
    image.SetOrigin(ORIGIN)
    array = numpy_support.numpy_to_vtk(labels.ravel(order="F"), deep=True)
    array.SetName("labels")
    image.GetPointData().SetScalars(array)
    if with_names:
        add_names(image.GetFieldData(), order)
    return image


def add_names(fields, order):
    values, names, colors = vtk.vtkIntArray(), vtk.vtkStringArray(), vtk.vtkUnsignedCharArray()
    colors.SetNumberOfComponents(3)
    for array, name in ((values, "LabelValues"), (names, "LabelNames"), (colors, "LabelColors")):
        array.SetName(name)
        fields.AddArray(array)
    for label in order:
        values.InsertNextValue(label)
        names.InsertNextValue(NAMES[label])
        colors.InsertNextTuple3(*COLORS[label])


def edges(surface, boundary):
    """Boundary edges, or else those of more than two triangles."""
    features = vtk.vtkFeatureEdges()
    features.SetInputData(surface)
    features.SetBoundaryEdges(boundary)
    features.SetNonManifoldEdges(not boundary)
    features.FeatureEdgesOff()
    features.ManifoldEdgesOff()
    features.Update()
    return features.GetOutput().GetNumberOfCells()


def triangles(surface, other):
    """The sets of the corners of those that have that label on their other side."""
    labels = surface.GetCellData().GetArray("OtherLabel")
    found = set()
    for cell in range(surface.GetNumberOfCells()):
        if labels.GetTuple1(cell) == other:
            points = surface.GetCell(cell).GetPoints()
            found.add(frozenset(points.GetPoint(k) for k in range(3)))
    return found


def voxels_inside(surface):
    stencil = vtk.vtkPolyDataToImageStencil()
    stencil.SetInputData(surface)
    stencil.SetOutputOrigin(ORIGIN)
    stencil.SetOutputSpacing(SPACING)
    stencil.SetOutputWholeExtent([size for n in SIZE for size in (0, n - 1)])
    image = vtk.vtkImageStencilToImage()
    image.SetInputConnection(stencil.GetOutputPort())
    image.SetInsideValue(1)
    image.SetOutsideValue(0)
    image.SetOutputScalarTypeToUnsignedChar()
    image.Update()
    array = numpy_support.vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
    return array.reshape(SIZE, order="F")


class Segments(ApplicationTest):
    def setUp(self):
        super().setUp()
        write_map(label_map(), self.path("map.vti"))
        write_map(label_map(), self.path("plain.mha"))

    def fields(self, surface):
        fields = surface.GetFieldData()
        values, names, colors = (fields.GetAbstractArray(name) for name in ("LabelValues", "LabelNames", "LabelColors"))
        return {values.GetTuple1(i): (names.GetValue(i), colors.GetTuple(i)) for i in range(values.GetNumberOfTuples())}

    def test_one_command_gives_a_folder_of_proved_bones(self):
        text = self.succeed("map.vti", "out/bones/", "--segments", "all", "--max-error", "halfvoxel", "--smooth", "auto").stdout
        self.assertEqual(
            [name for name in self.names() if name.startswith("out/bones/")],
            ["out/bones/" + name for name in
             ("Femur.vtp", "index.html", "knee___cap.vtp", "label_7.vtp", "picture.png", "report.json")])
        surfaces = {label: read(self.path(f"out/bones/{name}.vtp")) for label, name in NAMES_OF_FILES.items()}
        for label, surface in surfaces.items():
            self.assertEqual((edges(surface, True), edges(surface, False)), (0, 0))
            self.assertTrue((voxels_inside(surface) == (voxels() == label)).all(), label)
            self.succeed("certify", f"out/bones/{NAMES_OF_FILES[label]}.vtp", "--labels", "plain.mha", "--json", "c.json")
            self.assertEqual(self.report("c.json")["voxels"]["changed"], 0)
        wall = triangles(surfaces[1], 2)
        self.assertGreater(len(wall), 5)
        self.assertEqual(triangles(surfaces[2], 1), wall)
        self.check_report(self.report("out/bones/report.json"), surfaces)
        self.assertIn("segment         1 (Femur): ", text)
        page = self.path("out/bones/index.html").read_text(encoding="utf-8")
        for words in ("label 2 (knee / cap)", "<td>0</td><td>100 %</td>", "Of the voxels of all labels 100 % keep theirs. The largest error is "
                      "0.5 of the smallest voxel spacing, 0.5 mm.", "data:image/png"):
            self.assertIn(words, page)

    def check_report(self, report, surfaces):
        self.assertEqual((report["proof"]["status"], report["proof"]["tolerance"]), ("proved", 0.25))
        self.assertEqual(set(report["proof"]["files"].values()), {"same_bits"})
        self.assertEqual((report["voxels"]["guard"], report["voxels"]["changed"]), ("on", 0))
        self.assertGreater(report["smoothing"]["largest_displacement"], 0.05)
        segments = report["segments"]
        self.assertEqual((segments["bound_in_voxels"], segments["kept_voxels"]), (0.5, 1.0))
        for segment in segments["list"]:
            label = segment["label"]
            self.assertEqual((segment["name"], tuple(segment["color"])), (NAMES[label], COLORS[label]))
            self.assertEqual(segment["triangles"], surfaces[label].GetNumberOfPolys())
            self.assertEqual(segment["components"], 2 if label == 7 else 1)
            mass = vtk.vtkMassProperties()
            mass.SetInputData(surfaces[label])
            self.assertAlmostEqual(sum(segment["volumes"]), mass.GetVolume(), delta=1e-3)

    def test_one_file_has_all_segments_and_is_certified(self):
        self.succeed("map.vti", "raw.vtp", "--segments", "all", "--target-reduction", 0, "--measure", "off")
        self.succeed("map.vti", "out.vtp", "--also", "out.ply", "--segments", "all", "--max-error", "0.5voxel", "--smooth", "auto",
                     "--measure", "off", "--report", "report.json")
        self.succeed("certify", "raw.vtp", "out.vtp", "--tolerance", 0.25, "--quiet")
        self.succeed("certify", "out.vtp", "--labels", "plain.mha", "--quiet")
        surface = read(self.path("out.vtp"))
        self.assertLess(surface.GetNumberOfPolys(), read(self.path("raw.vtp")).GetNumberOfPolys())
        labels = surface.GetCellData().GetArray("BoundaryLabels")
        self.assertEqual({labels.GetTuple(i) for i in range(labels.GetNumberOfTuples())}, {(1, 0), (2, 0), (7, 0), (1, 2)})
        self.assertEqual({label: self.fields(surface)[label] for label in NAMES}, {label: (NAMES[label], COLORS[label]) for label in NAMES})
        colors = read(self.path("out.ply")).GetCellData().GetArray("RGB")
        for cell in range(surface.GetNumberOfCells()):
            self.assertEqual(colors.GetTuple(cell), COLORS[labels.GetTuple(cell)[0]])
        self.assertNotIn("file", self.report()["segments"]["list"][0])

    def test_a_limit_too_small_to_smooth_is_named(self):
        for error, is_small in ((0.02, True), ("halfvoxel", False)):
            said = self.succeed("map.vti", "all.vtp", "--segments", "all", "--smooth", "auto", "--max-error", error).stdout
            self.assertEqual("too small for the steps of the voxels" in said, is_small, said)

    def test_blocks_have_names(self):
        self.succeed("map.vti", "bones.vtm", "--segments", "all", "--target-reduction", 0.5, "--measure", "off")
        self.assertEqual([name for name in self.names() if name.startswith("bones")],
                         ["bones", "bones.vtm", "bones/Femur.vtp", "bones/knee___cap.vtp", "bones/label_7.vtp"])
        reader = vtk.vtkXMLMultiBlockDataReader()
        reader.SetFileName(str(self.path("bones.vtm")))
        reader.Update()
        blocks = reader.GetOutput()
        names = [blocks.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME()) for i in range(blocks.GetNumberOfBlocks())]
        self.assertEqual(names, ["Femur", "knee / cap", "7"])
        self.assertEqual(edges(blocks.GetBlock(1), True), 0)
        self.assertTrue(triangles(blocks.GetBlock(0), 2))

    def test_segments_are_chosen_by_label_or_name(self):
        for choice, labels in (("femur,7", {1, 7}), ("2", {2}), ("Knee / Cap, 1", {1, 2})):
            self.succeed("map.vti", "out.vtp", "--segments", choice, "--target-reduction", 0.3, "--measure", "off", "--report", "report.json")
            self.assertEqual({segment["label"] for segment in self.report()["segments"]["list"]}, labels)
            self.assertEqual(self.report()["voxels"]["changed"] if choice == "2" else 0, 0)
        self.succeed("plain.mha", "out.stl", "--segments", "1,7", "--target-reduction", 0.3, "--measure", "off")

    def test_segments_that_are_not_there_are_rejected_with_those_that_are(self):
        for name, there in (("map.vti", "1 (Femur), 2 (knee / cap), 7"), ("plain.mha", "1, 2, 7")):
            self.fail_with(REJECTED, name, "new/folder", "--segments", "1,rib", says=f"it has no segment 'rib'; its segments are {there}")
        write_map(label_map(numpy.zeros(SIZE, numpy.uint8)), self.path("empty.mha"))
        self.fail_with(REJECTED, "empty.mha", "out", "--segments", "all", says="none of its voxels has a label")
        gray = numpy.arange(numpy.prod(SIZE), dtype=numpy.int16).reshape(SIZE)
        write_map(label_map(gray), self.path("gray.mha"))
        self.fail_with(REJECTED, "gray.mha", "out", "--segments", "all", says="more than 1000 different values")

    def test_names_of_totalsegmentator(self):
        labels = voxels()
        for old, new in ((1, 25), (2, 92), (7, 5)):
            labels[labels == old] = new
        write_map(label_map(labels, with_names=False), self.path("total.mha"))
        words = ("--label-names", "totalsegmentator", "--target-reduction", 0.5, "--measure", "off")
        self.succeed("total.mha", "out.vtm", "--segments", "bones", *words)
        self.assertEqual(sorted(p.name for p in self.path("out").iterdir()), ["rib_left_1.vtp", "sacrum.vtp"])
        self.succeed("total.mha", "all", "--segments", "all", "--format", "STL", *words)
        self.assertEqual(sorted(p.name for p in self.path("all").iterdir()), ["index.html", "label_5.stl", "picture.png", "report.json", "rib_left_1.stl", "sacrum.stl"])
        self.fail_with(REJECTED, "total.mha", "no", "--segments", "bones", says="the name of none of its segments is one that 'bones' means; its segments are 5, 25, 92")
        self.fail_with(REJECTED, "plain.mha", "no", "--segments", "bones", *words, says="the name of none of its segments is one that 'bones' means")

    def changed_before(self, kind):
        """By label: count and voxels."""
        return {segment["label"]: tuple(segment["changed_before"][kind][key] for key in ("count", "voxels", "volume"))
                for segment in self.report()["segments"]["list"]}

    def components(self):
        return {segment["label"]: segment["components"] for segment in self.report()["segments"]["list"]}

    def test_islands_get_the_label_around_them_on_request(self):
        labels = voxels()
        labels[5:7, 8, 7] = 2  # within 1
        write_map(label_map(labels), self.path("map.vti"))
        words = ("map.vti", "out.vtp", "--segments", "all", "--max-error", "halfvoxel", "--measure", "off", "--report", "report.json")
        self.succeed(*words)
        self.assertEqual(self.components(), {1: 2, 2: 2, 7: 2})
        self.assertNotIn("changed_before", self.report()["segments"]["list"][0])
        text = self.succeed(*words, "--prune-volume", 0.6, "--page", "page.html").stdout
        volume = SPACING[0] * SPACING[1] * SPACING[2]
        self.assertEqual(self.changed_before("islands_removed"), {1: (0, 0, 0), 2: (1, 2, 2 * volume), 7: (1, 1, volume)})
        self.assertEqual(self.components(), {1: 1, 2: 1, 7: 1})
        self.assertEqual(self.report()["voxels"]["changed"], 0)
        self.assertNotIn("pruned", self.report())
        self.assertRegex(text, r"segment         2 .*; 1 island of 2 voxels \(0.375 mm3\) removed\n")
        self.assertIn("label 7: 1 island of 1 voxel (0.188 mm3) removed", self.path("page.html").read_text(encoding="utf-8"))
        self.succeed(*words[:1], "femur.vtp", *words[2:], "--prune-size", 1.1)
        self.assertEqual(self.changed_before("islands_removed"), {1: (0, 0, 0), 2: (1, 2, 2 * volume), 7: (1, 1, volume)})
        text = self.succeed(*words, "--prune-area", 1000).stdout
        self.assertIn("warning: the largest piece of segment 1 (Femur) is below a limit of --prune, too; it stays", text)
        self.assertEqual(self.components(), {1: 1, 2: 1, 7: 1})

    def test_cavities_are_filled_on_request_alone(self):
        labels = voxels()
        labels[5:7, 8, 7] = 0
        write_map(label_map(labels), self.path("map.vti"))
        words = ("map.vti", "out.vtp", "--segments", "1", "--target-reduction", 0.3, "--measure", "off", "--report", "report.json")
        for limit, filled in ((None, 0), (0.3, 0), (0.375, 1)):
            self.succeed(*words, *(("--fill-volume", limit) if limit else ()))
            self.assertEqual(self.components(), {1: 1 if filled else 2})
            if limit:
                self.assertEqual(self.changed_before("cavities_filled"), {1: (filled, 2 * filled, 0.375 * filled)})
        labels[5:7, 8, 7] = 2  # is not chosen, and no cavity
        write_map(label_map(labels), self.path("map.vti"))
        self.succeed(*words, "--fill-volume", 10)
        self.assertEqual(self.components(), {1: 2})

    def test_the_volume_of_all_is_the_sum_of_the_segments(self):
        self.succeed("map.vti", "out.vtp", "--segments", "all", "--max-error", "halfvoxel", "--smooth", "auto", "--report", "report.json")
        report = self.report()
        self.assertAlmostEqual(report["output"]["volume"], sum(sum(segment["volumes"]) for segment in report["segments"]["list"]), delta=1e-3)
        inside = numpy.count_nonzero(voxels()) * SPACING[0] * SPACING[1] * SPACING[2]
        self.assertAlmostEqual(report["input"]["volume"], inside, delta=0.1 * inside)

    def test_nothing_is_left_of_a_run_that_fails(self):
        words = ("--segments", "all", "--target-reduction", 0.5, "--measure", "off")
        self.path("file").write_text("no folder", encoding="utf-8")
        self.fail_with(NOT_WRITTEN, "map.vti", "file/bones/", *words, says="could not make")
        self.fail_with(NOT_WRITTEN, "map.vti", "new/bones", "--also", "nowhere/all.vtp", *words, says="nowhere")
        self.fail_with(NOT_WRITTEN, "map.vti", "new/bones", *words, preexec_fn=limit(resource.RLIMIT_FSIZE, 3000))
        self.path("closed").mkdir(mode=0o500)
        self.fail_with(NOT_WRITTEN, "map.vti", "closed/bones", *words, preexec_fn=without_root_powers)

    def test_surfaces_of_an_earlier_run_are_named(self):
        words = ("plain.mha", "bones/", "--target-reduction", 0.3, "--measure", "off")
        self.assertNotIn("not of this run", self.succeed(*words, "--segments", "all", "--format", "stl").stdout)
        said = self.succeed(*words, "--segments", "1,7", "--format", "ply").stdout
        self.assertIn("warning: the folder has surfaces that are not of this run: 'label_1.stl', 'label_2.stl', 'label_7.stl'\n", said)
        said = self.succeed(*words, "--segments", "1,7", "--format", "ply", "--also", "bones/all.ply").stdout
        self.assertIn("not of this run: 'label_1.stl', 'label_2.stl', 'label_7.stl'\n", said)
        said = self.succeed(*words, "--segments", "1,7", "--format", "ply").stdout
        self.assertIn("not of this run: 'all.ply', 'label_1.stl', 'label_2.stl', 'label_7.stl'\n", said)

    def test_folders_have_closed_surfaces_and_no_number_as_their_name(self):
        words = ("--segments", "all", "--target-reduction", 0.3, "--measure", "off", "--format", ".stl")
        self.assertNotIn("walls between labels", self.succeed("plain.mha", "closed", *words).stdout)
        self.assertTrue(self.path("closed/label_7.stl").exists())
        self.assertIn("walls between labels", self.succeed("plain.mha", "all.stl", *words[:-2]).stdout)
        self.assertNotIn("walls between labels", self.succeed("plain.mha", "one.stl", "--segments", "1", *words[2:-2]).stdout)
        self.fail_with(USAGE, "plain.mha", "0.45", *words, says="'0.45' is no folder; an option takes its value behind its name")

    def test_a_surface_of_several_labels_is_not_smoothed_and_the_warning_says_so(self):
        self.succeed("plain.mha", "all.vtp", "--segments", "all", "--target-reduction", 0)
        self.assertIn("was not smoothed: it has several labels", self.succeed("smooth", "all.vtp", "smooth.vtp").stdout)

    def test_the_page_begins_with_the_voxels_that_changed(self):
        words = ("--segments", "all", "--max-error", "voxel", "--keep-voxels", "off", "--smooth", "auto")
        self.succeed("plain.mha", "bones/", *words)
        changed = json.loads(self.path("bones/report.json").read_text(encoding="utf-8"))["voxels"]["changed"]
        self.assertGreater(changed, 0)
        page = self.path("bones/index.html").read_text(encoding="utf-8")
        self.assertIn(f"labels in the input kept; {changed:,} voxels have another label", page)

    def test_a_batch_makes_a_folder_for_each_map_and_goes_on_where_it_ended(self):
        maps = self.path("maps")
        maps.mkdir()
        for name in ("a.mha", "b.mha"):
            os.link(self.path("plain.mha"), maps / name)
        words = ("maps", "out", "--segments", "1,7", "--max-error", "halfvoxel", "--format", "ply", "--measure", "off")
        self.succeed(*words)
        folder = ["index.html", "label_1.ply", "label_7.ply", "picture.png", "report.json"]
        for name in "ab":
            self.assertEqual(sorted(p.name for p in self.path(f"out/{name}").iterdir()), folder)
        self.assertEqual(self.column("status"), ["done", "done"])
        self.assertEqual(self.column("output"), ["a/", "b/"])
        self.path("out/b/label_7.ply").unlink()
        self.assertEqual(self.succeed(*words).stdout.count("by an earlier run"), 1)
        self.assertEqual(self.column("status"), ["done", "done"])
        self.assertTrue(self.path("out/b/label_7.ply").exists())

    def column(self, heading):
        with open(self.path("out/summary.csv"), newline="", encoding="utf-8") as file:
            return [row[heading] for row in csv.DictReader(file)]

    def test_contradictions_are_rejected(self):
        self.succeed("map.vti", "bone.vtp", "--segments", "1", "--target-reduction", 0.3, "--measure", "off")
        for words, says in (
            (("map.vti", "out.vtp"), "--segments"),
            (("map.vti", "out.vtp", "--segments", "all", "--iso", 5), "exclude each other"),
            (("map.vti", "out.vtp", "--segments", "all", "--label-map", "plain.mha"), "the input is the label map"),
            (("map.vti", "out.vtp", "--segments", "all", "--labels", "BoundaryLabels"), "--labels names an array"),
            (("map.vti", "out.vtp", "--segments", "all", "--tolerance-array", "t"), "use --region"),
            (("map.vti", "out.vtp", "--segments", "all", "--unit", "m"), "--unit"),
            (("map.vti", "out.vtp", "--segments", "all", "--format", "stl"), "--format"),
            (("map.vti", "out.vtm", "--segments", "all", "--format", "stl"), "--format"),
            (("map.vti", "out.vtp", "--segments", "all", "--prune-triangles", 9), "use --prune-size, --prune-area or --prune-volume"),
            (("bone.vtp", "out.vtp", "--fill-volume", 9), "--fill-volume is for volumes"),
            (("map.vti", "out.json", "--segments", "all"), "vtm"),
            (("map.vti", "out.vtp", "--segments", ""), "--segments takes all"),
            (("map.vti", "out.vtp", "--label-names", "totalsegmentator", "--iso", 1), "--label-names has no effect"),
            (("map.vti", "out.vtp", "--segments", "all", "--label-names", "mine"), "--label-names"),
            (("bone.vtp", "out.vtp", "--segments", "all"), "is none"),
            (("map.vti", "out.vtm"), "--segments"),
            (("map.vti", "out", "--segments", "all", "--preset", "OneVoxel", "--max-error", "halfvoxel"), "--preset is both"),
            (("map.vti", "out", "--segments", "all", "--max-error", "third"), "quartervoxel, halfvoxel or voxel, not 'third'"),
        ):
            with self.subTest(words=words):
                self.fail_with(USAGE, *words, says=says)


if __name__ == "__main__":
    main()
