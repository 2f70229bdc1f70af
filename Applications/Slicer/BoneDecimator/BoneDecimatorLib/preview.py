# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The live preview: when it runs, and the part of a large bone that it shows. Needs no window."""

import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy

from .checks import DecimationError
from .engines import Canceled

MOST_TRIANGLES = 10_000  # of the input of a preview: two seconds or so
QUIET = 0.4  # s without a change before a run
PAUSE = 0.05  # s between two looks for changes during a run


class Preview:
    """Runs again after each change. A change during a run cancels it; changes in short order make one run.

    The caller calls tick() every tenth of a second or so, and changed() for each change. Both may be called during a run,
    from `listen`.
    """

    def __init__(self, run, tell, listen=None, clock=time.monotonic):
        """@param run Called with a progress function, which it passes on; may raise Canceled and DecimationError.
        @param tell Called with the sentence of a DecimationError.
        @param listen Called during a run, so that changes can be heard: Qt's processEvents().
        """
        self._run, self._tell, self._listen, self._clock = run, tell, listen, clock
        self._due = None  # when the next run starts; None: nothing has changed
        self._next_look = 0.0  # by the clock
        self._is_running = self._is_on = False

    def start(self):
        self._is_on = True
        self.changed()

    def stop(self):
        """Cancels a run and forgets changes."""
        self._is_on, self._due = False, None

    def changed(self):
        if self._is_on:
            self._due = self._clock() + QUIET

    def tick(self):
        """Runs if there was a change and quiet since. Returns whether a run was completed."""
        if self._is_running or self._due is None or self._clock() < self._due:
            return False
        self._due, self._is_running = None, True
        try:
            self._run(self._goes_on)
        except Canceled:
            return False
        except DecimationError as problem:
            self._tell(str(problem))
        finally:
            self._is_running = False
        return True

    def _goes_on(self, _fraction):
        if self._listen and self._clock() >= self._next_look:
            self._listen()
            self._next_look = self._clock() + PAUSE
        return self._is_on and self._due is None


def part_of_label_map(label_map, most=MOST_TRIANGLES, center=None):
    """A box of the label map whose surfaces have about `most` triangles, or all of it. Surfaces are closed where it was cut.

    @param center mm in the coordinates of the map; None: where the surface is nearest to its center.
    @return The part, and its ratio of all triangles.
    """
    faces = _boundary_faces(label_map.voxels)
    if 2 * len(faces) <= most:
        return label_map, 1.0
    spacing = label_map.spacing
    if center is None:
        middle = faces[np.argmin(np.linalg.norm((faces - faces.mean(axis=0)) * spacing, axis=1))]
    else:
        middle = np.linalg.inv(label_map.to_node)[:3] @ np.append(center, 1.0)
    reach = np.sort((np.abs(faces - middle) * spacing).max(axis=1))[most // 2]
    size = np.array(label_map.voxels.shape[::-1])
    first = np.clip(np.floor(middle - reach / spacing).astype(int), 0, size - 1)
    last = np.clip(np.ceil(middle + reach / spacing).astype(int) + 1, first + 1, size)
    return label_map.part(first, last), most / (2 * len(faces))


def _boundary_faces(voxels):
    """(n, 3), x, y, z in voxels: the lower voxel of each pair of neighbors with different labels; outside is background."""
    found = [np.argwhere(np.diff(np.pad(voxels, 1).astype(np.int32), axis=axis)) for axis in range(3)]
    return np.concatenate(found)[:, ::-1] - 1


def part_of_surface(surface, most=MOST_TRIANGLES, center=None):
    """The same of a surface of one or several bones: the cells within a box."""
    total = surface.GetNumberOfCells()
    if total <= most:
        return surface, 1.0
    centers = vtk.vtkCellCenters()
    centers.SetInputData(surface)
    centers.Update()
    positions = vtk_to_numpy(centers.GetOutput().GetPoints().GetData())
    mean = positions.mean(axis=0) if center is None else np.asarray(center)
    middle = positions[np.argmin(np.linalg.norm(positions - mean, axis=1))]
    nearest = np.argsort(np.abs(positions - middle).max(axis=1))[:most]
    node = vtk.vtkSelectionNode()
    node.SetFieldType(vtk.vtkSelectionNode.CELL)
    node.SetContentType(vtk.vtkSelectionNode.INDICES)
    node.SetSelectionList(numpy_to_vtkIdTypeArray(np.sort(nearest), deep=True))
    selection = vtk.vtkSelection()
    selection.AddNode(node)
    extract = vtk.vtkExtractSelection()
    extract.SetInputData(0, surface)
    extract.SetInputData(1, selection)
    to_surface = vtk.vtkGeometryFilter()
    to_surface.SetInputConnection(extract.GetOutputPort())
    to_surface.Update()
    return to_surface.GetOutput(), most / total
