# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every option of the table through everything in the wheel that takes options: shown, honored, or rejected with a sentence.

Where VTK or PyVista is not there, the table is walked without them.
"""

import inspect
import logging
import math
import os
import pydoc
import sys
import unittest
from importlib.util import find_spec

import numpy as np

import bonedecimate
from arrays_test import POINTS, TRIANGLES
from bonedecimate import decimate, record_levels
from bonedecimate.options import ROWS, default_of, spelled, unsupported, words

HAS_VTK, HAS_PYVISTA = (find_spec(name) is not None for name in ("vtkmodules", "pyvista"))
if HAS_VTK:
    from vtkmodules.vtkCommonCore import vtkLogger
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # executives say once more what the filter said
TETRAHEDRON = np.array([[0, 0, 0], [40, 0, 0], [0, 40, 0], [0, 0, 40.0]]), np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
NO_NUMBERS = ["0.5", None, 1j, [0.5], (), {}, np.array([0.5, 0.5]), True, b"1", object()]


def hostile(row, by_number):
    """Values that no option of that kind takes."""
    if row.choices:
        numbers = [-1, len(row.choices), 99, 2**31, -2**70, 1.5, math.nan, math.inf]
        return numbers + NO_NUMBERS if by_number else ["Slow", "", "2", 0, 1.0, math.nan, None, b"Fast", ["Fast"], True]
    if row.kind == "bool":
        return [2, -1, 2**70, 0.5, math.nan, "on", "", None, [True], 1j, np.array([True, False])]
    if row.kind == "str":
        return [3, 0.5, None, True, b"Name", ["Name"], np.array(["a", "b"])]
    outside = [math.nan, math.inf, -math.inf, np.float64("nan"), np.float32("inf"), row.minimum - 1, -1e-300,
               2 * row.maximum + 1, -2**70, 2**1100, np.int64(-1)]
    return NO_NUMBERS + outside + ([1.5, 2**31, 2**63, np.float64(0.5)] if row.kind == "int" else [])


def good(row, by_number):
    """Values at both ends of the range and in between, as Python has them and as numpy has them."""
    if row.choices:
        return list(range(len(row.choices))) if by_number else row.choices
    if row.kind == "bool":
        return [True, False, 0, 1, np.bool_(True)]
    if row.kind == "str":
        return ["Name", "", np.str_("Name"), "gr\u00f6\u00dfe"]
    middle = [1, np.int32(1), np.uint8(1), np.array(1)] + ([1.0, 4e2] if row.kind == "int" else [0.5, np.float32(0.5)])
    kind = int if row.kind == "int" else float
    return [kind(row.minimum), kind(row.maximum), *middle]


class Adapter:
    """Something that takes options: which options it takes, and how."""

    by_number = False

    def __init__(self, name, function, without=(), call=None):
        self.name, self.function, self.without, self.call = name, function, without, call or function

    def keys(self):
        return [key for key in ROWS if key not in self.without]

    def give(self, key, value):
        self.call(**{key: value})


class Property(Adapter):
    """Of the VTK filter: by SetName(), by assignment or by the constructor; a value that is rejected must not stay."""

    by_number = True

    def __init__(self, name, put):
        super().__init__(name, None)
        self.put = put

    def give(self, key, value):
        from bonedecimate import vtkBoneDecimate
        row, made = ROWS[key], vtkBoneDecimate()
        before = getattr(made, "Get" + row.name)()
        try:
            found = self.put(made, row, value) or made
        except (ValueError, TypeError):
            assert getattr(made, "Get" + row.name)() == before, key
            raise
        held = getattr(found, "Get" + row.name)()
        assert held == value and type(held).__name__ == type(before).__name__, (key, value, held)


def slicers_engine():
    """That of 3D Slicer's panel, which takes flags and says what is wrong by one kind of error."""
    sys.path.insert(0, os.path.join(os.environ["SOURCE_DIR"], "Applications", "Slicer", "BoneDecimator"))
    from BoneDecimatorLib.engines import Canceled, DecimationError, WheelEngine
    surface = pyvista_tetrahedron()

    def call(**options):
        (key, value), = options.items()
        try:
            engine = WheelEngine()
            engine.table.check({ROWS[key].flag: value}, {ROWS[key].flag: key})  # as a request of the panel does
            engine.decimate(surface, {ROWS[key].flag: value}, progress=run_stops)
        except Canceled:
            pass
        except DecimationError as problem:
            raise ValueError(str(problem)) from problem
    return Adapter("Slicer's engine", None, [key for key, row in ROWS.items() if not row.flag], call)


def pyvista_tetrahedron():
    import pyvista
    return pyvista.PolyData.from_regular_faces(*TETRAHEDRON)


def run_stops(fraction):
    """Ends a run at once: only its options are checked."""
    return False


def adapters():
    points, triangles = TETRAHEDRON
    yield Adapter("decimate", decimate, unsupported("Arrays"),
                  lambda **options: decimate(points, triangles, progress=run_stops, **options))
    yield Adapter("record_levels", record_levels, unsupported("Arrays", "RecordedLevels"),
                  lambda **options: record_levels(points, triangles, progress=run_stops, **options))
    if HAS_VTK:
        from bonedecimate import vtkBoneDecimate
        yield Property("SetName()", lambda made, row, value: getattr(made, "Set" + row.name)(value))
        yield Property("name = value", lambda made, row, value: setattr(made, words(row.name, "_"), value))
        yield Property("vtkBoneDecimate(name=value)",
                       lambda made, row, value: vtkBoneDecimate(**{words(row.name, "_"): value}))
    if HAS_PYVISTA:
        bone = pyvista_tetrahedron().bone
        kind = type(bone)
        yield Adapter("mesh.bone.decimate", kind.decimate, (),
                      lambda **options: bone.decimate(progress_bar=run_stops, **options))
        yield Adapter("mesh.bone.levels", kind.levels, unsupported("Arrays", "RecordedLevels"),
                      lambda **options: bone.levels(progress_bar=run_stops, **options))
        yield slicers_engine()


class Values(unittest.TestCase):
    def test_of_every_option_are_honored_or_rejected_by_everything_that_takes_options(self):
        logging.disable()  # PyVista logs what VTK's executives say once more
        self.addCleanup(logging.disable, logging.NOTSET)
        sentences = {}
        for adapter in adapters():
            counts = {"accepted": 0, "rejected": 0, "silent": 0}
            for key in adapter.keys():
                for value in hostile(ROWS[key], adapter.by_number):
                    if adapter.name == "mesh.bone.decimate" and key == "labels" and not isinstance(value, str):
                        continue  # arrays of labels are taken there: wrongarrays_test.py
                    rejection = self.rejection(adapter, key, value)
                    counts["rejected" if rejection else "silent"] += 1
                    self.assertIsNotNone(rejection, f"{adapter.name}: {key}={value!r} is taken without a word")
                    if type(rejection) is ValueError and rejection.__cause__ is None and not ROWS[key].choices:
                        name = ROWS[key].name if adapter.by_number else key
                        self.assertRegex(str(rejection), f"^{name} takes .*, not ")
                        sentence = str(rejection).removeprefix(name)
                        self.assertEqual(sentence, sentences.setdefault((key, repr(value)), sentence), adapter.name)
                counts["accepted"] += self.accepted(adapter, key)
            print(f"{adapter.name}: {', '.join(f'{count} {what}' for what, count in counts.items())}")

    def rejection(self, adapter, key, value):
        try:
            adapter.give(key, value)
        except (ValueError, TypeError) as rejection:
            return rejection
        return None

    def accepted(self, adapter, key):
        values = good(ROWS[key], adapter.by_number)
        for value in values:
            try:
                adapter.give(key, value)
            except ValueError as rejection:  # of a run that makes no sense, not of the value
                self.assertNotRegex(str(rejection), f"^{ROWS[key].name} takes ", f"{adapter.name}: {key}={value!r}")
        return len(values)

    def test_are_the_options_of_the_run(self):
        given = {"max_error": np.float32(0.25), "threads": np.int64(1), "target_triangles": 4e2, "mode": "fast", "measure": 0,
                 "merge_points": np.bool_(True), "normal_tolerance": 1}
        report = decimate(POINTS, TRIANGLES, **given).report
        for name, text in {"MaximumError": "0.25", "NumberOfThreads": "1", "TargetNumberOfTriangles": "400", "Mode": "Fast",
                           "MeasureDistances": "off", "MergePoints": "on", "NormalTolerance": "1"}.items():
            self.assertEqual(report["options." + name], text)


class Names(unittest.TestCase):
    def test_in_signatures_are_those_of_the_table(self):
        own = {"decimate": ["points", "triangles", "tolerances", "labels", "label_map", "boundary_labels", "reference",
                            "edge_lengths", "prepared", "progress", "profile"],
               "record_levels": ["points", "triangles", "progress"],
               "mesh.bone.decimate": ["self", "tolerances", "labels", "label_map", "boundary_labels", "edge_lengths",
                                      "reference", "with_input", "progress_bar", "profile"],
               "mesh.bone.levels": ["self", "progress_bar"]}
        for adapter in adapters():
            if adapter.function is None:
                continue
            parameters = inspect.signature(adapter.function).parameters
            options = [key for key in adapter.keys() if key not in own[adapter.name]]
            self.assertEqual(list(parameters), own[adapter.name] + options)
            for key in options:
                self.assertEqual(parameters[key].kind, inspect.Parameter.KEYWORD_ONLY)
                self.assertEqual(parameters[key].default, default_of(ROWS[key]), key)

    def test_of_data_are_the_same_for_numpy_and_pyvista(self):
        if not HAS_PYVISTA:
            self.skipTest("no PyVista here")
        numpy, mesh = (set(inspect.signature(adapter.function).parameters) for adapter in adapters()
                       if adapter.name in ("decimate", "mesh.bone.decimate"))
        self.assertEqual(numpy - mesh, {"points", "triangles", "prepared", "progress"})
        self.assertEqual(mesh - numpy - set(unsupported("Arrays")), {"self", "with_input", "progress_bar"})

    def test_are_in_help_with_meaning_default_range_and_unit(self):
        for adapter in adapters():
            if adapter.function is not None:
                text = " ".join(pydoc.plain(pydoc.render_doc(adapter.function)).split())
                for key in adapter.keys():
                    self.assertIn(f"{key} : ", text)
                    if not (adapter.name == "mesh.bone.decimate" and key == "labels"):
                        self.assertIn(" ".join(spelled(ROWS[key].sentence).split()), text)
                self.assertRegex(text, r"Default: 0 mm\. Range: 0 to 1e30 mm\.")

    def test_are_found_by_completion_of_the_package(self):
        self.assertLessEqual(set(bonedecimate.__all__), set(dir(bonedecimate)))

    def test_of_the_package_that_is_built_with_vtk_say_so(self):
        with self.assertRaisesRegex(ImportError, "vtkBoneVoxelCheck is in the package .* built with VTK.*check_voxels does the same"):
            from bonedecimate import vtkBoneVoxelCheck  # noqa: F401
        for name, command in (("smallest_error", "tolerance"), ("error_curve", "curve"), ("vtkBoneErrorSearch", "tolerance")):
            with self.assertRaisesRegex(ImportError, f"{name} is in the package .* built with VTK.* the program's bonedecimate {command} does"):
                getattr(bonedecimate, name)
        with self.assertRaises(AttributeError):
            _ = bonedecimate.vtkBoneNonsense

    def test_that_are_misspelled_name_the_one_that_was_meant(self):
        meant = {"max_eror": "max_error", "maximum_error": "max_error", "maxError": "max_error", "target_face": "target_triangles",
                 "number_of_threads": "threads", "tolerancs": "tolerances", "reduction": "target_reduction"}
        for word, name in meant.items():
            with self.assertRaisesRegex(TypeError, f"no option '{word}' here .did you mean '{name}'"):
                decimate(*TETRAHEDRON, **{word: 1})
        with self.assertRaisesRegex(TypeError, "about the arrays of a data set"):
            decimate(*TETRAHEDRON, pass_arrays=True)
        with self.assertRaisesRegex(TypeError, "levels are of all components"):
            record_levels(*TETRAHEDRON, prune_size=3)


@unittest.skipUnless(HAS_VTK, "no VTK here")
class FilterNames(unittest.TestCase):
    def test_are_methods_and_properties_with_their_meaning(self):
        from bonedecimate import vtkBoneDecimate
        self.assertEqual(list(inspect.signature(vtkBoneDecimate).parameters), [words(row.name, "_") for row in ROWS.values()])
        text = pydoc.plain(pydoc.render_doc(vtkBoneDecimate))
        for row in ROWS.values():
            for name in ("Set" + row.name, "Get" + row.name, words(row.name, "_")):
                self.assertIn(name, dir(vtkBoneDecimate()))
                self.assertIn(row.sentence, inspect.getdoc(getattr(vtkBoneDecimate, name)))
                self.assertIn(name, text)

    def test_that_there_are_not_are_attribute_errors(self):
        from bonedecimate import vtkBoneDecimate
        made = vtkBoneDecimate()
        made.maximum_error = 0.1
        self.assertEqual(made.GetMaximumError(), 0.1)
        for name in ("max_error", "MaximumError", "maximum_eror", "SetMaximumError", "THESIS", "anything"):
            with self.assertRaisesRegex(AttributeError, f"no property '{name}'"):
                setattr(made, name, 0.2)
        with self.assertRaisesRegex(AttributeError, "did you mean 'maximum_error'"):
            made.maximum_eror = 0.2
        with self.assertRaisesRegex(TypeError, "did you mean 'maximum_error'"):
            vtkBoneDecimate(maximum_eror=0.2)
        with self.assertRaises(AttributeError):
            made.SetMaximumEror(0.2)
        self.assertEqual(made.GetMaximumError(), 0.1)

    def test_of_classes_made_of_it_may_be_others(self):
        from bonedecimate import vtkBoneDecimate

        class Mine(vtkBoneDecimate):
            def __init__(self):
                super().__init__()
                self.patient = "phantom"

        self.assertEqual(Mine().patient, "phantom")
        with self.assertRaises(AttributeError):
            Mine().maximum_eror = 0.2


class Sentences(unittest.TestCase):
    """Messages call an option what the user has typed."""

    def test_about_values_have_the_keyword(self):
        for function in (decimate, record_levels):
            for key, value in (("max_error", -1), ("threads", 1e9), ("mode", "Slow"), ("max_error", 10**400)):
                with self.assertRaisesRegex(ValueError, f"^{key} takes "):
                    function(*TETRAHEDRON, **{key: value})
        with self.assertRaisesRegex(ValueError, r"\(allow_large_error runs anyway\)"):
            decimate(*TETRAHEDRON, max_error=500)

    def test_about_options_without_effect_have_keywords(self):
        for function in (decimate, record_levels):
            with self.assertWarnsRegex(UserWarning, "^intersection_guard has no effect; it needs max_error or preset, "):
                function(*TETRAHEDRON, intersection_guard=False)
        with self.assertWarns(UserWarning):
            result = decimate(*TETRAHEDRON, voxel_size=0.5)
        self.assertEqual(result.warnings, ["voxel_size has no effect; it needs preset"])

    def test_about_a_zero_that_would_leave_the_default_target(self):
        for zero in ("max_error", "target_triangles"):
            with self.assertRaisesRegex(ValueError, f"{zero}=0 sets no limit, so that nine tenths of the triangles would go"):
                decimate(*TETRAHEDRON, **{zero: 0})
        decimate(*TETRAHEDRON, max_error=0, target_triangles=4)
        decimate(*TETRAHEDRON, max_error=0, tolerances=np.zeros(4))

    def test_about_words_name_the_option_that_says_it(self):
        for key, value, says in (("max_error", "halfvoxel", "preset='HalfVoxel' says that"),
                                 ("max_error", "One-Voxel", "preset='OneVoxel' says that"),
                                 ("smooth", "auto", "auto_smooth=True says that"),
                                 ("max_error", "0.5", "not '0.5'$")):
            with self.assertRaisesRegex(TypeError, f"^{key} takes a number, .*{says}"):
                decimate(*TETRAHEDRON, **{key: value})

    @unittest.skipUnless(HAS_VTK, "no VTK here")
    def test_of_the_filter_have_its_properties(self):
        made = bonedecimate.vtkBoneDecimate()
        with self.assertRaisesRegex(ValueError, "^MaximumError takes "):
            made.maximum_error = -1
        with self.assertRaisesRegex(TypeError, "^MaximumError takes "):
            made.SetMaximumError("half")

    def test_of_smoothing_reject_what_concerns_edits(self):
        without_effect = {"edge_length": 1.0, "min_angle": 20, "chordal_error": 0.1, "refinement_effort": 2, "mode": "Fast"}
        for key, value in without_effect.items():
            with self.assertRaisesRegex(TypeError, f"no option '{key}' here: smoothing keeps all triangles"):
                bonedecimate.smooth(*TETRAHEDRON, 0.2, **{key: value})

    @unittest.skipUnless(HAS_PYVISTA, "no PyVista here")
    def test_of_smoothing_meshes_are_the_same(self):
        import pyvista
        mesh = pyvista.PolyData.from_regular_faces(*TETRAHEDRON)
        for words in ({"edge_length": 1.0}, {"edge_lengths": [1.0] * 4}, {"smooth": 1.0}, {"profile": "FEM"}):
            with self.assertRaisesRegex(TypeError, f"no option '{next(iter(words))}' here: "):
                mesh.bone.smooth(0.2, **words)
        with self.assertWarnsRegex(UserWarning, "^voxel_size has no effect; it needs preset"):
            mesh.bone.decimate(voxel_size=0.5)

    def test_of_certify_reject_what_has_no_effect(self):
        with self.assertRaisesRegex(ValueError, "tight_bounds=False has no effect; it needs tolerance"):
            bonedecimate.certify(TETRAHEDRON, TETRAHEDRON, tight_bounds=False)
        with self.assertRaisesRegex(ValueError, "mean_precision has no effect with means=False"):
            bonedecimate.certify(TETRAHEDRON, TETRAHEDRON, means=False, mean_precision=0.1)
        bonedecimate.certify(TETRAHEDRON, TETRAHEDRON, tolerance=1, tight_bounds=False, means=False)


class Profiles(unittest.TestCase):
    def test_set_their_options_and_keywords_win(self):
        for profile in bonedecimate._core.profile_table():
            typed = bonedecimate._core.Options()
            keywords = {}
            for flag, value, reason in profile.options:
                key = flag.replace("-", "_")
                self.assertTrue(reason)
                typed.read(ROWS[key].name, value)
                if key not in unsupported("Arrays"):
                    keywords[key] = value if ROWS[key].choices else typed.get(ROWS[key].name)
            expected = decimate(POINTS, TRIANGLES, **keywords)
            np.testing.assert_array_equal(decimate(POINTS, TRIANGLES, profile=profile.name.upper()).points, expected.points)
            keywords["mode"] = "Fast"
            expected = decimate(POINTS, TRIANGLES, **keywords)
            np.testing.assert_array_equal(decimate(POINTS, TRIANGLES, profile=profile.name, mode="Fast").points, expected.points)

    def test_give_way_to_the_same_in_other_words(self):
        result = decimate(POINTS, TRIANGLES, profile="print", preset="HalfVoxel", voxel_size=0.6)
        self.assertEqual(result.report["proof.tolerance"], 0.3)

    def test_that_there_are_not_are_rejected(self):
        with self.assertRaisesRegex(ValueError, "profile 'pront' is none of planning, print, FEM, web; did you mean print"):
            decimate(POINTS, TRIANGLES, profile="pront")
        with self.assertRaisesRegex(TypeError, "profile takes the name of a profile, not 3"):
            decimate(POINTS, TRIANGLES, profile=3)


if __name__ == "__main__":
    unittest.main()
