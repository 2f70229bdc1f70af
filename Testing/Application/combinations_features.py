# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What can be combined in one run of the program: each feature with its words and how its outputs show that it took effect."""

import dataclasses
import functools
import json
import math
import re
import subprocess
import typing

import vtk

import option_rows
from application import FORMATS, MODES, OTHER_FORMATS, PROGRAM, PROVING_MODES, SURFACES, array_names, read
from combinations_inputs import METERS, isosurface, label_surface, scaled

ERROR = 0.3  # mm, of the features that bound it
LARGE_ERROR = 40.0  # mm, more than a quarter of the diagonal
CONSTRAINED = (28.0, 0.0, 0.0, 9.0)  # center and radius of the constrained region, mm


@dataclasses.dataclass
class Feature:
    """words: on the command line. problem: of a run that succeeded, why the feature is not seen to have taken effect."""

    name: str
    words: tuple = ()
    problem: typing.Callable = lambda run: ""
    rejected_by: tuple = ()  # words of which a rejection has one
    goal: bool = False  # says where to stop
    input: str = ""  # a kind of input
    output: str = ""  # a format of the output
    command: str = ""  # a subcommand

    def __post_init__(self):
        flags = [str(word) for word in self.words if str(word).startswith("--")]
        names = [word.lstrip("-").replace("-", " ") for word in flags]
        self.rejected_by = (*self.rejected_by, *flags, *names, *filter(None, (self.command, self.name)))

    @property
    def shown(self):
        words = " ".join(map(str, (*filter(None, (self.command,)), *self.words)))
        return words or (f"OUTPUT.{self.output}" if self.output else self.input)

    def problem_in(self, run):
        return self.problem(run) or ""


class Run:
    """One call of the program with the words of two features."""

    def __init__(self, program, pair):
        self.program, self.pair = program, pair
        self.kinds = {feature.input for feature in pair} - {""}
        self.command = next((feature.command for feature in pair if feature.command), "")
        formats = [feature.output for feature in pair if feature.output]
        self.formats = list(dict.fromkeys(formats)) or ["obj" if "thesis form" in self.kinds else "vtp"]

    def has(self, name):
        return any(feature.name == name for feature in self.pair)

    def has_word(self, word):
        return any(word in feature.words for feature in self.pair)

    def proves_nothing(self):
        return any(self.has_word(name) for name in MODES if name not in PROVING_MODES)

    def prunes(self):
        return any(str(word).startswith("--prune") for feature in self.pair for word in feature.words)

    def extra(self):
        """The words of both, those that both have once."""
        first, second = ([tuple(feature.words[i:i + 2]) for i in range(0, len(feature.words), 2)] for feature in self.pair)
        words = [word for words in first + [words for words in second if words not in first] for word in words]
        return ["first_m.vtp" if word == "first.vtp" and "unit" in self.kinds else word for word in words]

    def execute(self, folder):
        self.folder = folder
        self.words = [self.program, *map(str, self.line())]
        return subprocess.run(
            self.words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", check=False)

    def line(self):
        extra = self.extra()
        if len([feature for feature in self.pair if feature.command]) == 2:
            return [self.pair[0].command, self.pair[1].command, "bone.vtp"]
        if self.command:
            return [self.command, *self.command_inputs(), *extra, "--quiet"]
        if "thesis form" in self.kinds:
            source = "bones" if "batch" in self.kinds else self.source("bone", "obj")
            return ["thesis", source, 300, 0.95, 0, self.output_words(), *extra, *self.listing()]
        if not any(feature.goal for feature in self.pair):
            extra += ["--target-reduction", 0.5]
        if not any("--measure" in feature.words for feature in self.pair):
            extra += ["--measure", "off"]  # half of the time of a small run
        return [self.input(), self.output_words(), *self.other_formats(), *extra, *self.listing()]

    def other_formats(self):
        if "batch" in self.kinds:
            return ["--format", self.formats[0]] if any(feature.output for feature in self.pair) else []
        return ["--also", "out." + self.formats[1]] if len(self.formats) > 1 else []

    def listing(self):
        return ["--quiet"] if "batch" in self.kinds else ["--report", "report.json", "--quiet"]

    def source(self, stem, extension):
        return f"{stem}_m.{extension}" if "unit" in self.kinds else f"{stem}.{extension}"

    def command_inputs(self):
        source = self.input()
        return [source, source] if self.command == "certify" else [source]

    def input(self):
        if "batch" in self.kinds:
            return "maps" if "segments" in self.kinds else "volumes" if "CT" in self.kinds else "meters" if "unit" in self.kinds else "bones"
        if "segments" in self.kinds:
            return "bone_map.mha"
        return "bone.mha" if "CT" in self.kinds else self.source("bone", "vtp")

    def output_words(self):
        return "small" if "batch" in self.kinds else self.output()

    def output(self):
        batch = "small/bone/label_1." if "segments" in self.kinds else "small/bone."
        return (batch if "batch" in self.kinds else "out.") + self.formats[0]

    # What the run wrote.

    @functools.cached_property
    def report(self):
        name = ("small/bone/report.json" if "segments" in self.kinds else "small/bone.json") if "batch" in self.kinds else "report.json"
        path = self.folder / name
        return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}

    @functools.cached_property
    def result(self):
        surface = read(self.folder / self.output())
        return surface if FORMATS[self.formats[0]]["names_unit"] else in_millimeters(surface, self)

    @functools.cached_property
    def bone(self):
        """The surface that went in, or of the volume the one that the program extracted."""
        if "segments" in self.kinds:
            return label_surface(self.folder / "bone_map.mha")
        if "CT" in self.kinds:
            return isosurface(self.folder / "bone.mha")
        return in_millimeters(read(self.folder / self.source("bone", "vtp")), self)

    def holds_arrays(self):
        return FORMATS[self.formats[0]]["holds_arrays"]

    def option(self, name):
        return self.report["options"][name]

    def warnings(self):
        return [generic(text) for text in self.report.get("warnings", [])]


def generic(sentence):
    """Without numbers that differ from run to run."""
    return re.sub(r"\d+(\.\d+)?(e-?\d+)?", "N", sentence)


def in_millimeters(surface, run):
    return scaled(surface, 1.0 / METERS) if "unit" in run.kinds else surface


# How it shows that a feature took effect.
def distance(a, b):
    """mm, the largest from the points and the centers of the triangles of one to the other."""
    locator = vtk.vtkStaticCellLocator()
    locator.SetDataSet(b)
    locator.BuildLocator()
    position, cell, sub, squared = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
    largest = 0.0
    centers = vtk.vtkCellCenters()
    centers.SetInputData(a)
    centers.Update()
    for surface in (a, centers.GetOutput()):
        for i in range(surface.GetNumberOfPoints()):
            locator.FindClosestPoint(surface.GetPoint(i), position, cell, sub, squared)
            largest = max(largest, float(squared))
    return math.sqrt(largest)


def shows(path, value):
    """The report says so."""
    def problem(run):
        if run.command:
            return ""
        found = functools.reduce(lambda at, key: at.get(key, {}), path.split("."), run.report)
        return "" if found == value else f"report.{path} is {found!r}"
    return problem


def stops_there(run):
    if run.command:
        return ""
    faces, stop = run.report["output"]["triangles"], run.report["stop_reason"]
    limit = 300 if run.has_word("--target-triangles") else 0.3 * run.report["input"]["triangles"]
    return "" if faces <= limit + 1 or stop not in ("target_reached",) else f"{faces} triangles, {stop}"


def moves_at_most(run):
    if run.command:
        return ""
    worst = max(distance(run.result, run.bone), 0.0 if run.prunes() else distance(run.bone, run.result))
    if run.proves_nothing() or "thesis form" in run.kinds:
        return ""
    if worst > ERROR + 1e-5:
        return f"{worst} mm away"
    proof = run.report.get("proof", {})
    if run.has("no proof"):
        return "a proof" if proof else ""
    return "" if proof.get("status") == "proved" and proof["upper"] <= ERROR else f"proof: {proof}"


def keeps_points(inside):
    def problem(run):
        if run.command:
            return ""
        digits = 5 if "unit" in run.kinds or not run.holds_arrays() else 12
        rounded = lambda p: tuple(round(x, digits) for x in p)
        after = {rounded(run.result.GetPoint(i)) for i in range(run.result.GetNumberOfPoints())}
        gone = [p for i in range(run.bone.GetNumberOfPoints())
                if inside(p := run.bone.GetPoint(i)) and rounded(p) not in after]
        return f"{len(gone)} constrained points moved, the first {gone[0]}" if gone else ""
    return problem


def has_labels(run):
    if run.command:
        return ""
    labels = run.report.get("labels", {})
    if labels.get("count") != 2:
        return f"labels: {labels}"
    if not run.holds_arrays() or run.has("no arrays"):
        return ""
    array = run.result.GetCellData().GetArray("Bone")
    found = {array.GetValue(i) for i in range(array.GetNumberOfValues())} if array else set()
    return "" if found == {1, 2} else f"labels of the result: {found}"


def without_crumb(run):
    if run.command or run.has("no merging of points"):  # its triangles are components of their own then, and open
        return ""
    if "segments" in run.kinds:  # an island of voxels
        return "" if run.report["segments"]["list"][0]["changed_before"]["islands_removed"]["count"] >= 1 else "the crumb is still there"
    return "" if run.report["pruned"]["components"] >= 1 and run.result.GetBounds()[1] < 50.0 else "the crumb is still there"


def keeps_to_the_cap(run):
    proof = run.report.get("proof", {})
    return "" if run.command or run.proves_nothing() or proof.get("status") == "proved" and proof["upper"] <= LARGE_ERROR else f"proof: {proof}"


def keeps_duplicates(run):
    return "" if run.command or run.report["input"]["merged_points"] == 0 else "points were merged"


def is_double(run):
    if run.command or not run.holds_arrays():
        return ""
    return "" if read(run.folder / run.output()).GetPoints().GetDataType() == vtk.VTK_DOUBLE else "single precision"


def lacks_arrays(run):
    return "" if run.command or "allowed" not in array_names(run.result.GetPointData()) else "arrays"


def has_point_array(name):
    def problem(run):
        if run.command or not run.holds_arrays():
            return ""
        return "" if name in array_names(run.result.GetPointData()) else f"no {name}"
    return problem


def has_segments(run):
    if run.command:
        return ""
    segments = run.report.get("segments", {}).get("list", [])
    found = [(segment["label"], segment["triangles"] > 0) for segment in segments]
    return "" if found == [(1, True)] else f"segments: {segments}"


def has_voxels(run):
    voxels = run.report.get("voxels", {})
    return "" if run.command or voxels.get("of_1", {}).get("voxels", 0) > 100 else f"voxels: {voxels}"


def wrote(name, text=None):
    def problem(run):
        path = run.folder / name
        if run.command:
            return ""
        if not path.exists():
            return f"no {name}"
        return "" if text is None or text in path.read_bytes() else f"no {text!r} in {name}"
    return problem


def wrote_surface(run):
    if run.command:
        return ""
    paths = [run.output(), *("out." + extension for extension in run.formats[1:])]
    counts = {read(run.folder / path).GetNumberOfPolys() for path in paths}
    return "" if counts == {run.report["output"]["triangles"]} else f"{paths}: {counts} triangles"


def wrote_colors(run):
    path = run.output() if run.formats[0] == "glb" else "out.glb"
    return wrote_surface(run) or wrote(path, b'"COLOR_0"')(run)


def features_of_the_table(covered):
    """A feature for each option with a flag that is not covered: with it the option has an effect, and the report has its value."""
    for name, flag, words, value in option_rows.cases_of_flags(PROGRAM):
        if flag not in covered:
            yield Feature(flag.strip("-").replace("-", " "), words, shows("options." + name, value), (name,))


def has_angles(run):
    """Few are left: where triangles are constrained, and where labels or voxels forbid edits."""
    if run.command:
        return ""
    left, triangles = run.report["angles"]["below_minimum"], run.report["output"]["triangles"]
    return "" if left <= 0.2 * triangles else f"{left} of {triangles} triangles have smaller angles"


def has_edges(run):
    """Few are too long: where triangles are constrained, and where labels or voxels forbid edits."""
    longer, triangles = (0, 0) if run.command else (run.report["edges"]["longer"], run.report["output"]["triangles"])
    return "" if longer <= 0.1 * triangles else f"{longer} of the edges of {triangles} triangles are too long"


def switch(name, flag, value, option, problem=None):
    return Feature(name, (flag, value), problem or shows(f"options.{option}", value))


FEATURES = [
    *(Feature(name, ("--mode", name), shows("options.Mode", name)) for name in MODES),
    Feature("triangles", ("--target-triangles", 300), stops_there, goal=True),
    Feature("reduction", ("--target-reduction", 0.7), stops_there, goal=True),
    Feature("largest error", ("--max-error", ERROR), moves_at_most, goal=True),
    switch("voxels may change", "--keep-voxels", "Off", "KeepVoxels"),
    Feature("preset", ("--preset", "HalfVoxel", "--voxel-size", 2 * ERROR), moves_at_most, goal=True),
    Feature("no intersection guard", ("--max-error", ERROR, "--intersection-guard", "off"), shows("options.IntersectionGuard", "off"), goal=True),
    Feature("each edit proved", ("--max-error", ERROR, "--prove-each-edit", "on"), shows("options.ProveEachEdit", "on"), goal=True),
    Feature("less effort", ("--max-error", ERROR, "--refinement-effort", 0.25), shows("options.RefinementEffort", "0.25"), goal=True),
    Feature("least angle", ("--max-error", ERROR, "--min-angle", 20), has_angles, ("MinimumAngle",), goal=True),
    Feature("edge length", ("--max-error", ERROR, "--edge-length", 10), has_edges, ("EdgeLength",), goal=True),
    Feature("local lengths", ("--max-error", ERROR, "--edge-length", 10, "--edge-length-array", "size", "--chordal-error", 1.0),
            has_edges, ("EdgeLength", "size"), goal=True),
    Feature("no proof", ("--max-error", ERROR, "--prove", "off"), shows("options.ProveResult", "off"), goal=True),
    Feature("large error allowed", ("--max-error", LARGE_ERROR, "--allow-large-error", "on"), keeps_to_the_cap, goal=True),
    Feature("region", ("--region", "sphere:{},{},{},{}=0".format(*CONSTRAINED)),
            keeps_points(lambda p: math.dist(p, CONSTRAINED[:3]) <= CONSTRAINED[3] - 1e-3), ("tolerance",)),
    Feature("tolerance array", ("--tolerance-array", "allowed"), keeps_points(lambda p: p[0] < -20.0), ("allowed", "tolerance")),
    Feature("labels", ("--labels", "Bone"), has_labels, ("Bone", "label")),
    Feature("prune", ("--prune-size", 6), without_crumb),
    Feature("prune by area", ("--prune-area", 60), without_crumb),
    Feature("prune by volume", ("--prune-volume", 60), without_crumb),
    Feature("prune by triangles", ("--prune-triangles", 200), without_crumb),
    Feature("close tunnels", ("--close-tunnels", 1), lambda run: "" if run.command or "tunnels" in run.report else "none"),
    Feature("reference", ("--max-error", ERROR, "--reference", "first.vtp"), lambda run: "" if run.command or "reference" in run.report else "none", goal=True),
    switch("no merging of points", "--merge-points", "off", "MergePoints", keeps_duplicates),
    Feature("measured", ("--measure", "on"), lambda run: "" if run.command or "distance" in run.report else "no distance"),
    switch("double precision", "--precision", "Double", "OutputPointsPrecision", is_double),
    switch("no arrays", "--pass-arrays", "off", "PassArrays", lacks_arrays),
    switch("maps", "--maps", "on", "MakeMaps", has_point_array("OriginalPointIds")),
    switch("normals", "--recompute-normals", "on", "RecomputeNormals", has_point_array("Normals")),
    Feature("normal tolerance", ("--mode", "Thesis", "--normal-tolerance", 0.5), shows("normal_tolerance", 0.5)),
    Feature("automatic normal tolerance", ("--mode", "Thesis", "--target-triangles", 300, "--auto-normal-tolerance", "on"),
            shows("options.AutomaticNormalTolerance", "on"), goal=True),
    Feature("smoothing", ("--smooth", 0.2), lambda run: "" if run.command or "smoothing" in run.report else "not smoothed"),
    Feature("kept edges", ("--smooth", 0.2, "--feature-angle", 45), shows("options.FeatureAngle", "45")),
    Feature("label map", ("--label-map", "bone_map.mha", "--keep-voxels", "Off"), has_voxels, ("map", "smoothing can keep voxels")),
    switch("automatic smoothing", "--auto-smooth", "on", "AutomaticSmoothing", lambda run: ""),
    Feature("threads", ("--threads", 2), shows("options.NumberOfThreads", "2")),
    switch("diagnose", "--diagnose", "on", "DiagnoseInput", lambda run: "" if run.command or "diagnostics" in run.report else "none"),
    *(Feature(name, output=name, problem=wrote_surface) for name in (*SURFACES, *OTHER_FORMATS)),
    Feature("colors in glb", ("--vertex-colors", "error", "--position-bits", 15), wrote_colors, output="glb"),
    Feature("heat map", ("--heatmap", "map.vtp"), wrote("map.vtp", b"DistanceToResult")),
    Feature("page and picture", ("--page", "page.html", "--picture", "picture.png"),  # together, as the picture takes most of the time
            lambda run: wrote("page.html", b"</html>")(run) or wrote("picture.png", b"PNG")(run)),
    Feature("CT", ("--iso", 226), input="CT", rejected_by=("volume",)),
    Feature("segments", ("--segments", "all"), has_segments, input="segments", rejected_by=("label map",)),
    Feature("unit", ("--unit", "m"), shows("files.unit", "m"), input="unit"),
    Feature("batch", input="batch", rejected_by=("one bone", "folder", "output")),
    Feature("thesis form", input="thesis form", rejected_by=("unknown option",)),
    Feature("certify", command="certify", rejected_by=("unknown option",)),
    Feature("diagnose command", command="diagnose", rejected_by=("unknown option",)),
    Feature("tolerance", ("--triangles", 300), command="tolerance", rejected_by=("unknown option",)),
    Feature("curve", ("--errors", f"{ERROR}"), command="curve", rejected_by=("unknown option",)),
    Feature("levels", ("--record", "run.levels"), command="levels", rejected_by=("unknown option",)),
]
FEATURES += features_of_the_table({word for feature in FEATURES for word in feature.words})
