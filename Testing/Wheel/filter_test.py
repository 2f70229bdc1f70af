# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel's filter in a pipeline: events, abort, errors, what is computed again. Its outputs: sameness_test.py."""

import gc
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkLogger, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter

import specimens
from bonedecimate import PreparedSurface, check_voxels, extract_surfaces, vtkBoneDecimate
from bonedecimate import decimate as decimate_arrays
from bonedecimate.options import ROWS
from bonedecimate.polydata import new_array, numbers, surface_of

vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)


def decimating(surface=None, **properties):
    decimate = vtkBoneDecimate()
    decimate.SetInputData(surface or specimens.torus(60, 40))
    for name, value in properties.items():
        getattr(decimate, "Set" + name)(value)
    return decimate


class Properties(unittest.TestCase):
    def test_out_of_their_range_are_value_errors_and_change_nothing(self):
        decimate = decimating(MaximumError=0.3, TargetReduction=0.4, Mode=1)
        before = decimate.GetMTime()
        for name, given, held in (("MaximumError", -1, 0.3), ("TargetReduction", 1.5, 0.4), ("Mode", 99, 1),
                                  ("MaximumError", float("nan"), 0.3), ("NumberOfThreads", 1.5, 0)):
            with self.assertRaisesRegex(ValueError, f"^{name} takes .*, not {given}".replace("nan", "NaN")):
                getattr(decimate, "Set" + name)(given)
            self.assertEqual(getattr(decimate, "Get" + name)(), held)
        self.assertEqual(decimate.GetMTime(), before)
        decimate.Update()
        self.assertEqual(decimate.GetStopReason(), vtkBoneDecimate.TARGET_REACHED)

    def test_getters_are_read_only_properties(self):
        decimate = decimating(MaximumError=0.3)
        self.assertTrue(np.isnan(decimate.proved_error))
        self.assertEqual((decimate.number_of_output_triangles, decimate.proof_status), (0, vtkBoneDecimate.NO_PROOF))
        decimate.Update()
        self.assertLessEqual(decimate.measured_error, decimate.proved_error)
        self.assertEqual((decimate.proof_status, decimate.proof_status_as_string), (vtkBoneDecimate.PROVED, "proved"))
        self.assertEqual(decimate.number_of_output_triangles, decimate.GetOutput().GetNumberOfPolys())
        with self.assertRaises(AttributeError):
            decimate.proved_error = 1

    def test_array_to_process_counts_unless_there_is_a_name(self):
        from vtkmodules.util.numpy_support import numpy_to_vtk
        surface = specimens.torus(30, 20)
        for name, value in (("Narrow", 0.01), ("Wide", 1.0)):
            array = numpy_to_vtk(np.full(surface.GetNumberOfPoints(), value), deep=True)
            array.SetName(name)
            surface.GetPointData().AddArray(array)

        def triangles(name, processed):
            decimate = decimating(surface, ToleranceArrayName=name)
            if processed:
                decimate.SetInputArrayToProcess(vtkBoneDecimate.TOLERANCE_ARRAY, 0, 0, 0, processed)
            decimate.Update()
            return decimate.number_of_output_triangles

        self.assertLess(triangles("Wide", None), triangles("Narrow", None))
        self.assertEqual(triangles("", "Narrow"), triangles("Narrow", None))
        self.assertEqual(triangles("Wide", "Narrow"), triangles("Wide", None))

    def test_switches_have_on_and_off(self):
        decimate = vtkBoneDecimate()
        for row in ROWS.values():
            if row.kind == "bool":
                getattr(decimate, row.name + "On")()
                self.assertIs(getattr(decimate, "Get" + row.name)(), True)
                getattr(decimate, row.name + "Off")()
                self.assertIs(getattr(decimate, "Get" + row.name)(), False)

    def test_reject_what_is_of_another_type(self):
        for value in ("much", None, [1]):
            with self.assertRaises(TypeError):
                vtkBoneDecimate().SetTargetReduction(value)

    def test_tell_their_meaning_and_stand_in_the_printed_text(self):
        for row in ROWS.values():
            self.assertIn(row.sentence, getattr(vtkBoneDecimate, "Set" + row.name).__doc__)
            self.assertIn(f"{row.name}: ", str(vtkBoneDecimate()))

    def test_modify_the_filter_only_if_they_change(self):
        decimate = decimating(MaximumError=0.3)
        before = decimate.GetMTime()
        decimate.SetMaximumError(0.3)
        self.assertEqual(decimate.GetMTime(), before)
        decimate.SetMaximumError(0.4)
        self.assertGreater(decimate.GetMTime(), before)


class Pipeline(unittest.TestCase):
    def test_has_input_and_output_connections(self):
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(40)
        sphere.SetPhiResolution(40)
        decimate = vtkBoneDecimate()
        decimate.SetInputConnection(sphere.GetOutputPort())
        decimate.SetTargetNumberOfTriangles(500)
        clean = vtkCleanPolyData()
        clean.SetInputConnection(decimate.GetOutputPort())
        clean.Update()
        self.assertEqual(clean.GetOutput().GetNumberOfPolys(), 500)
        self.assertIsNotNone(clean.GetOutput().GetPointData().GetArray("Distance"))

    def test_runs_again_only_when_something_changed(self):
        decimate = decimating()
        starts = []
        decimate.AddObserver("StartEvent", lambda *_: starts.append(1))
        decimate.Update()
        decimate.Update()
        self.assertEqual(len(starts), 1)
        decimate.SetTargetReduction(0.3)
        decimate.Update()
        self.assertEqual(len(starts), 2)

    def test_forgets_the_report_of_a_run_before_one_that_fails(self):
        decimate = decimating(MaximumError=0.3)
        decimate.Update()
        self.assertEqual(decimate.GetProofStatus(), vtkBoneDecimate.PROVED)
        decimate.AddObserver("ErrorEvent", lambda *_: None)
        decimate.SetToleranceArrayName("Nothing")
        decimate.Update()
        self.assertEqual((decimate.GetErrorCode(), decimate.GetOutput().GetNumberOfPoints()), (vtkBoneDecimate.REJECTED_RUN, 0))
        self.assertEqual((decimate.GetProofStatus(), decimate.GetStopReason()), (vtkBoneDecimate.NO_PROOF, vtkBoneDecimate.NOT_RUN))
        self.assertTrue(np.isnan(decimate.GetProvedError()))

    def test_forgets_the_report_if_an_algorithm_before_it_fails(self):
        reader = vtkSTLReader()
        reader.AddObserver("ErrorEvent", lambda *_: None)
        decimate = vtkBoneDecimate()
        decimate.SetMaximumError(0.3)
        decimate.SetInputConnection(reader.GetOutputPort())
        with tempfile.TemporaryDirectory() as folder:
            writer = vtkSTLWriter()
            writer.SetFileName(folder + "/torus.stl")
            writer.SetInputData(specimens.torus(30, 20))
            writer.Write()
            for name, code, status in (("torus", 0, "proved"), ("missing", vtkBoneDecimate.INPUT_FAILED, "no_proof"), ("torus", 0, "proved")):
                reader.SetFileName(f"{folder}/{name}.stl")
                decimate.Update()
                self.assertEqual((decimate.GetErrorCode(), decimate.GetProofStatusAsString()), (code, status))

    def test_passes_arrays_without_a_name(self):
        surface = specimens.torus(30, 20)
        unnamed = vtkDoubleArray()
        unnamed.SetNumberOfTuples(surface.GetNumberOfPoints())
        unnamed.Fill(7.0)
        surface.GetPointData().AddArray(unnamed)
        decimate = decimating(surface, MaximumError=0.3)
        decimate.Update()
        passed = decimate.GetOutput().GetPointData().GetAbstractArray(0)
        self.assertEqual((passed.GetName(), passed.GetNumberOfTuples()), (None, decimate.GetOutput().GetNumberOfPoints()))

    def test_gives_what_numpy_gets(self):
        surface = specimens.torus(30, 20)
        decimate = decimating(surface, MaximumError=0.1)
        decimate.Update()
        arrays = surface_of(surface)
        result = decimate_arrays(arrays.points, arrays.triangles, max_error=0.1)
        output = surface_of(decimate.GetOutput())
        np.testing.assert_array_equal(output.points, result.points)
        np.testing.assert_array_equal(output.triangles, result.triangles)
        self.assertEqual(decimate.GetReportValue("proof.upper"), result.report["proof.upper"])

    def test_output_outlives_filter_and_arrays(self):
        decimate = decimating()
        decimate.Update()
        output = decimate.GetOutput()
        before = specimens.portrait(output)
        del decimate
        gc.collect()
        np.ones(1000000)
        self.assertEqual(specimens.portrait(output), before)

    def test_does_not_change_its_input(self):
        surface = specimens.with_arrays(specimens.torus())
        before = specimens.portrait(surface)
        decimating(surface, MakeMaps=True, MeasureInputDistances=True).Update()
        self.assertEqual(specimens.portrait(surface), before)

    def test_carries_over_every_array_but_those_it_writes_itself(self):
        surface = specimens.with_arrays(specimens.torus())
        decimate = decimating(surface)
        decimate.Update()
        data = decimate.GetOutput().GetPointData()
        for i in range(surface.GetPointData().GetNumberOfArrays()):
            name = surface.GetPointData().GetAbstractArray(i).GetName()
            self.assertIsNotNone(data.GetAbstractArray(name), name)
        self.assertLess(numbers(data.GetArray("Distance")).max(), 1.0)


class Events(unittest.TestCase):
    def test_progress_rises_to_one(self):
        decimate, heard = decimating(), []
        decimate.AddObserver("ProgressEvent", lambda speaker, _: heard.append(speaker.GetProgress()))
        decimate.Update()
        self.assertEqual((heard, heard[-1]), (sorted(heard), 1.0))
        self.assertTrue(100 <= len(heard) <= 103)  # with those of VTK at the start and at the end
        self.assertEqual((decimate.GetProgressText(), decimate.GetErrorCode()), ("Simplifying the surface", 0))

    def test_an_observer_can_abort_and_the_output_is_valid(self):
        decimate = decimating()
        decimate.AddObserver("ProgressEvent", lambda speaker, _: speaker.SetAbortExecute(speaker.GetProgress() > 0.3))
        decimate.Update()
        self.assert_aborted(decimate)
        decimate.RemoveAllObservers()
        decimate.SetAbortExecute(0)
        decimate.Modified()
        decimate.Update()
        self.assertEqual(decimate.GetStopReason(), vtkBoneDecimate.TARGET_REACHED)

    def test_another_thread_can_abort(self):
        decimate = decimating(specimens.torus(300, 150), NumberOfThreads=1)
        heard = threading.Event()
        decimate.AddObserver("ProgressEvent", lambda speaker, _: speaker.GetProgress() > 0.1 and heard.set())

        def abort():
            heard.wait(60)
            decimate.SetAbortExecute(1)
        thread = threading.Thread(target=abort)
        thread.start()
        decimate.Update()
        thread.join()
        self.assert_aborted(decimate)

    def assert_aborted(self, decimate):
        self.assertEqual(decimate.GetStopReason(), vtkBoneDecimate.ABORTED)
        self.assertEqual(decimate.GetReportText("stop_reason"), "aborted")
        output = surface_of(decimate.GetOutput())
        self.assertGreater(len(output.triangles), 0)
        self.assertTrue(0 <= output.triangles.min() <= output.triangles.max() < len(output.points))

    def test_errors_empty_the_output_and_say_why(self):
        decimate = decimating(specimens.wrong_index())
        ear = specimens.Ear(decimate)
        decimate.Update()
        self.assertRegex(ear.texts[0], "^ErrorEvent: 1 triangle has point indices out of range, the first is triangle 96")
        self.assertEqual(decimate.GetOutput().GetNumberOfPoints(), 0)

    def test_ctrl_c_ends_update_with_keyboard_interrupt(self):
        program = """
import signal, threading, time
import filter_test, specimens
signal.signal(signal.SIGINT, signal.default_int_handler)
decimate = filter_test.decimating(specimens.torus(200, 100), Mode=3, MaximumError=0.01)
def interrupt():
    while decimate.GetProgress() < 0.1:
        time.sleep(0.001)
    signal.raise_signal(signal.SIGINT)
threading.Thread(target=interrupt).start()
try:
    decimate.Update()
except KeyboardInterrupt:
    print(decimate.GetStopReason() == decimate.NOT_RUN and "interrupted")
"""
        here = os.path.dirname(os.path.abspath(__file__))
        done = subprocess.run([sys.executable, "-B", "-c", program], cwd=here, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stdout, "interrupted\n", done.stderr)


def ball_and_cube():
    """A label map: a ball of label 3 and a cube of label 5."""
    z, y, x = np.indices((22, 20, 36))
    labels = np.where((x - 9.6) ** 2 + (y - 9.3) ** 2 + (z - 10.4) ** 2 < 60, 3, 0)
    labels[6:14, 6:14, 24:32] = 5
    return labels.astype(np.int16)


class LabelMaps(unittest.TestCase):
    """A surface that does not show its grid, because its points were moved a little."""

    def setUp(self):
        from vtkmodules.util.numpy_support import numpy_to_vtk
        labels = ball_and_cube()
        self.image = vtkImageData()
        self.image.SetDimensions(labels.shape[::-1])
        self.image.SetSpacing(0.5, 0.5, 0.5)
        self.image.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(), deep=True))
        found = extract_surfaces(labels == 3, spacing=(0.5, 0.5, 0.5))
        moved = found.points + np.random.default_rng(1).uniform(-0.01, 0.01, found.points.shape)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(moved, deep=True))
        triangles = vtkCellArray()
        for corners in found.triangles.tolist():
            triangles.InsertNextCell(3, corners)
        self.surface = specimens.polydata(points, triangles)

    def decimated(self, **properties):
        decimate = decimating(self.surface, TargetReduction=0.95, **properties)
        decimate.SetLabelMapData(self.image)
        decimate.Update()
        return decimate

    def test_tell_which_voxels_to_keep(self):
        kept = self.decimated(Label=3, KeepVoxels=1)
        self.assertEqual(kept.GetReportText("voxels.guard"), "on")
        self.assertEqual(kept.GetReportValue("voxels.changed"), 0)
        changes = check_voxels(kept.GetOutput(), self.image, label=3)
        self.assertEqual(changes.changed, 0)
        self.assertEqual(changes.of_label[3].voxels, np.count_nonzero(ball_and_cube() == 3))
        self.assertLess(kept.GetNumberOfOutputTriangles(), self.surface.GetNumberOfPolys() / 2)

    def test_count_changed_voxels_where_none_is_kept(self):
        free = self.decimated(Label=3, KeepVoxels=0)
        self.assertEqual(free.GetReportText("voxels.guard"), "off")
        changes = check_voxels(free.GetOutput(), self.image, label=3)
        self.assertGreater(changes.changed, 0)
        self.assertEqual(free.GetReportValue("voxels.changed"), changes.changed)

    def test_are_needed_to_keep_voxels(self):
        decimate = decimating(self.surface, KeepVoxels=1)
        ear = specimens.Ear(decimate)
        decimate.Update()
        self.assertRegex(ear.texts[0], "^ErrorEvent: KeepVoxels is on, but the surface has no voxel grid")

    def test_need_the_label_of_the_surface(self):
        decimate = decimating(self.surface)
        decimate.SetLabelMapData(self.image)
        ear = specimens.Ear(decimate)
        decimate.Update()
        self.assertRegex(ear.texts[0], "^ErrorEvent: .*labels 3, 5")
        decimate.SetLabel(5)  # another one than that of the surface
        decimate.Update()
        self.assertRegex(ear.texts[1], "^WarningEvent: label_map and the surface differ in")


class Strokes(unittest.TestCase):
    """Of a brush: what is kept between runs changes nothing."""

    def setUp(self):
        self.surface = specimens.torus(120, 60)
        points = numbers(self.surface.GetPoints().GetData())
        self.maps = [np.where(np.linalg.norm(points - center, axis=1) < 3, 0.05, 0.0) for center in ((13, 0, 0), (-13, 0, 0))]
        self.maps = [self.maps[0], np.maximum(*self.maps), self.maps[0]]
        self.options = {"Mode": vtkBoneDecimate.FAST, "MaximumError": 0.05, "ToleranceArrayName": "Tolerance", "MeasureDistances": False}

    def stroke(self, decimate, tolerances):
        surface = vtkPolyData()
        surface.ShallowCopy(self.surface)
        array = new_array(vtkDoubleArray, tolerances)
        array.SetName("Tolerance")
        surface.GetPointData().AddArray(array)
        decimate.SetInputData(surface)
        decimate.Update()
        return surface_of(decimate.GetOutput())

    def test_after_the_first_one_run_only_what_is_new(self):
        decimate = decimating(self.surface, **self.options)
        for tolerances, kept, count in zip(self.maps, (0, 1, 1), (1, 2, 1)):
            found = self.stroke(decimate, tolerances)
            fresh = self.stroke(decimating(self.surface, **self.options), tolerances)
            self.assertTrue(np.array_equal(found.points, fresh.points) and np.array_equal(found.triangles, fresh.triangles))
            self.assertEqual([decimate.GetReportValue(f"regions.{name}") for name in ("kept", "count")], [kept, count])
            self.assertLess(len(found.triangles), self.surface.GetNumberOfPolys())

    def test_are_released_on_request(self):
        decimate = decimating(self.surface, **self.options)
        self.stroke(decimate, self.maps[0])
        self.assertGreater(decimate.GetPreparedMemory(), 10 * self.surface.GetNumberOfPolys())
        decimate.ReleasePrepared()
        self.assertEqual(decimate.GetPreparedMemory(), 0)
        decimate.keep_prepared = False
        self.stroke(decimate, self.maps[1])
        self.assertEqual((decimate.GetPreparedMemory(), decimate.GetReportValue("regions.kept")), (0, 0))

    def test_of_arrays_use_a_prepared_surface(self):
        kept, whole = PreparedSurface(), surface_of(self.surface)
        for tolerances, count in zip(self.maps, (0, 1, 1)):
            found, fresh = (decimate_arrays(whole.points, whole.triangles, mode="Fast", max_error=0.05, tolerances=tolerances, measure=False,
                                            prepared=prepared) for prepared in (kept, None))
            self.assertTrue(np.array_equal(found.points, fresh.points) and np.array_equal(found.triangles, fresh.triangles))
            self.assertEqual(found.report["regions.kept"], count)
        self.assertGreater(kept.memory, 0)
        kept.release()
        self.assertEqual(kept.memory, 0)
        with self.assertRaisesRegex(TypeError, "prepared takes a PreparedSurface, not int"):
            decimate_arrays(whole.points, whole.triangles, prepared=1)


if __name__ == "__main__":
    unittest.main()
