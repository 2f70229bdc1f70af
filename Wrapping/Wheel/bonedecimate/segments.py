# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces by name from what a segmentation network gives: a folder of masks, a file, an image or an array. Needs no VTK."""

from __future__ import annotations

import importlib
import numbers
import operator
import os
import pathlib
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from .arrays import Result, decimate
from .label_maps import extract_surfaces
from .report import rounded_text
from .voxels import LabelMap, LabelMapLike, has_grid, label_map_from

if TYPE_CHECKING:
    import meshio
    import pyvista
    import trimesh

HALF_A_VOXEL = {"preset": "HalfVoxel", "auto_smooth": True}
# With one of these a run has a goal of its own.
_GOALS = {"max_error", "preset", "profile", "target_reduction", "target_triangles", "tolerances", "smooth", "auto_smooth", "mode"}


class Segment(NamedTuple):
    """The closed surface of one structure."""

    name: str
    label: int
    points: NDArray[np.float64]  #: (n, 3), mm, LPS
    triangles: NDArray[np.int32]  #: (m, 3), outward

    def to_pyvista(self) -> pyvista.PolyData:
        import pyvista
        return pyvista.PolyData.from_regular_faces(self.points, self.triangles)

    def to_trimesh(self) -> trimesh.Trimesh:
        import trimesh
        return trimesh.Trimesh(self.points, self.triangles, process=False)

    def to_meshio(self) -> meshio.Mesh:
        import meshio
        return meshio.Mesh(self.points, [("triangle", self.triangles)])


class Segments(Mapping[str, Segment]):
    """Structures by name, in the order of their labels. A name that was there before has the label behind it."""

    result: Result  #: the surfaces of all structures together, with walls once, and what is proved of them
    empty: list[str]  #: structures of which there is no triangle

    def __init__(self, result: Result, names: Mapping[int, str], labels: Iterable[int]) -> None:
        self.result, self.empty, self._segments = result, [], {}
        named = {label: names.get(label, f"label_{label}") for label in labels}
        firsts: dict[str, int] = {}
        for label, name in named.items():
            if name in firsts:
                both = f"labels {firsts[name]} and {label} have the same name, '{name}'"
                while name in firsts or name in named.values():
                    name += f"_{label}"
                warnings.warn(f"{both}; that of {label} is '{name}' here", stacklevel=3)
            firsts[name] = label
            if (result.boundary_labels == label).any():
                self._segments[name] = Segment(name, label, *result.label(label))
            else:
                self.empty.append(name)

    def __getitem__(self, name: str) -> Segment:
        if name not in self._segments:
            raise KeyError(f"no structure with triangles is called {name!r}; there are {', '.join(self)}")
        return self._segments[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._segments)

    def __len__(self) -> int:
        return len(self._segments)

    def to_pyvista(self) -> pyvista.MultiBlock:
        """A block for each structure, by name."""
        import pyvista
        return pyvista.MultiBlock({name: segment.to_pyvista() for name, segment in self.items()})

    def __repr__(self) -> str:
        return f"<bonedecimate.Segments: {', '.join(self)}; {rounded_text(self.result.proved_error, 'upper')} mm proved>"


def segments(source: Union[str, os.PathLike, LabelMapLike], *, names: Mapping[int, str] | Mapping[str, int] | None = None,
             choose: int | str | Iterable[int | str] | None = None, model_grid: str | float | Sequence[float] = "auto", progress: Any = None,
             **options: Any) -> Segments:
    """The simplified surfaces of the structures of a segmentation, by name, with walls between neighbors in common.

    Parameters
    ----------
    source : path, `LabelMap`, image of nibabel or SimpleITK, MetaTensor of MONAI, or (nz, ny, nx) array of whole numbers
        The path of a label map, or of a folder with a mask for each structure, as TotalSegmentator writes it: masks get the labels
        1, 2, ... in the order of their names, and of masks that overlap the last one counts, with a warning. NIfTI files need
        nibabel, all others SimpleITK. A MetaTensor has one channel and says in ``meta["space"]`` whether its affine is RAS or LPS.
    names : dict from labels to names, or from names to labels, optional
        Default: the names of masks, otherwise "label_3". A name of the background, 0, does not count.
    choose : label, name, or several of them, optional
        All others count as background. Default: all.
    model_grid
        Take the coarser map of a network from which the labels were copied, and its voxels: see `LabelMap.on_model_grid`.
    progress, options
        As `decimate` takes them. Without a goal (an error, a target, a profile, smoothing, a mode): half a voxel as the largest error, with smoothing within it.

    Raises
    ------
    TypeError, ValueError
        As of `LabelMap`, `extract_surfaces` and `decimate`; masks on different grids, or with several values; a structure that is not there.
    ImportError
        The package that reads the file is missing.
    """
    where = sorted({*LabelMap.__init__.__kwdefaults__} & {*options})
    if where:
        raise TypeError(f"segments takes no {', '.join(where)}: LabelMap(array, {where[0]}=...) says where the voxels of an array are")
    given = {} if names is None else _names_from(names)
    label_map, found = _read(source)
    label_map = label_map.on_model_grid(model_grid)
    present = [int(label) for label in np.unique(label_map.labels) if label != 0]
    if not present:
        raise ValueError("the label map has no label: every voxel is background")
    unknown = sorted({*given} - {*present, *found})
    if unknown:
        warnings.warn(f"names has labels that no voxel has: {', '.join(map(str, unknown))}", stacklevel=2)
    names = {**found, **given}
    wanted = {*present, *names}
    if choose is not None:
        wanted = _chosen([choose] if isinstance(choose, (str, numbers.Integral)) else choose, names, present)
    chosen = [label for label in present if label in wanted]
    if not chosen:
        raise ValueError(f"no voxel belongs to {', '.join(names.get(label, str(label)) for label in sorted(wanted))}")
    surfaces = extract_surfaces(label_map, labels=None if choose is None else chosen, model_grid="off")
    default = {} if _GOALS & {*options} else HALF_A_VOXEL
    result = decimate(surfaces, label_map=label_map if chosen == present else None, progress=progress, **default, **options)
    return Segments(result, names, sorted(wanted))


def _chosen(choose: Iterable[int | str], names: Mapping[int, str], present: list[int]) -> set[int]:
    chosen = set()
    for word in choose:
        labels = [label for label, name in names.items() if name.lower() == word.lower()] if isinstance(word, str) else [operator.index(word)]
        if not labels or labels[0] not in {*present, *names}:
            raise ValueError(f"there is no structure {word!r}; there are {', '.join(names.values()) or present}")
        chosen.update(labels)
    return chosen


def _names_from(names: Mapping[int, str] | Mapping[str, int]) -> dict[int, str]:
    """From labels to names, without that of the background."""
    pairs = list(names.items()) if isinstance(names, Mapping) else [(None, None)]
    if all(isinstance(name, str) and isinstance(label, numbers.Integral) for name, label in pairs):  # as in nnU-Net's dataset.json
        pairs = [(label, name) for name, label in pairs]
    if not all(isinstance(label, numbers.Integral) and isinstance(name, str) for label, name in pairs):
        raise TypeError(f"names is a dict from labels to names, {{2: 'femur'}}, or from names to labels, not {names!r:.60}")
    if len({label for label, _ in pairs}) < len(pairs):
        raise ValueError("names has two names for one label")
    return {int(label): name for label, name in pairs if label != 0}


def _read(source: object) -> tuple[LabelMap, dict[int, str]]:
    if isinstance(source, (str, os.PathLike)):
        path = pathlib.Path(source)
        return _masks(path) if path.is_dir() else (label_map_from(_image(path), None), {})
    return (label_map_from(source, None) if has_grid(source) else LabelMap(source)), {}


def _image(path: pathlib.Path) -> Any:
    if path.name.endswith((".nii", ".nii.gz")):
        return _package("nibabel", path).load(path)
    return _package("SimpleITK", path).ReadImage(os.fspath(path))


def _package(name: str, path: pathlib.Path) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise ImportError(f"'{path}' is read by {name}, which is not installed: pip install {name}") from None


def _masks(folder: pathlib.Path) -> tuple[LabelMap, dict[int, str]]:
    """Of a folder: the masks in the order of the names of their files."""
    files = sorted(path for path in folder.iterdir() if not path.name.startswith("."))
    if not files:
        raise ValueError(f"'{folder}' has no masks")
    names = {label: path.name.split(".")[0] for label, path in enumerate(files, 1)}
    whole = covered = None
    for label, path in enumerate(files, 1):
        mask = label_map_from(_image(path), None)
        values = np.unique(mask.labels)
        if len(values[values != 0]) > 1:
            raise ValueError(f"'{path}' has more than one value besides 0, so it is no mask of one structure")
        if whole is None:
            whole = LabelMap(np.zeros(mask.labels.shape, np.uint16), axes="zyx")
            whole.grid = mask.grid
            covered = np.zeros(mask.labels.shape, bool)
        elif not mask.grid.is_same_as(whole.grid):
            raise ValueError(f"'{path}' has another grid than the masks before it")
        inside = mask.labels != 0
        covered |= inside & (whole.labels != 0)
        whole.labels[inside] = label
    if covered.any():
        warnings.warn(f"{int(covered.sum())} voxels are in more than one mask and count as those of the last one", stacklevel=4)
    return whole, names
