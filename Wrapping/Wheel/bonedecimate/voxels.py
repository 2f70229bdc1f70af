# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Label maps, their voxel grids, and what a surface knows of the label map it was extracted from. Needs no VTK."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .checks import numbers_of, numeric_array
from .scans import MetaTensor, NibabelImage, SimpleItkImage, is_metatensor, is_nibabel, is_simpleitk, scan_of

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkImageData

IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
ORTHOGONAL, ORTHOGONAL_BUT_FOR_ROUNDING = 1e-14, 1e-3
LEAST_DETERMINANT = 1e-3  # of unit vectors that are not in one plane
LARGEST_FRACTION = 0.01  # of labels that were stored with a slope
LARGEST_COORDINATE = 1e30  # mm, of the core
LARGEST_DIMENSION = 2**30 - 2  # voxels


class VoxelGrid:
    """Where the voxels of a label map are. Everything is in the order x, y, z."""

    dimensions: tuple[int, int, int]  #: number of voxels
    spacing: NDArray[np.float64]  #: (3,), mm
    origin: NDArray[np.float64]  #: (3,), mm, the center of the first voxel
    direction: NDArray[np.float64]  #: (3, 3), the columns are the axes; not perpendicular if the gantry was tilted
    #: (nz,), mm along the third axis, of each layer from the first one, or None; then the third of `spacing` is the least distance
    layers: NDArray[np.float64] | None

    def __init__(self, dimensions: Sequence[int], *, spacing: Sequence[float] = (1, 1, 1), origin: Sequence[float] = (0, 0, 0),
                 direction: ArrayLike = IDENTITY, affine: ArrayLike | None = None, layers: Sequence[float] | None = None) -> None:
        """
        Parameters
        ----------
        dimensions : three whole numbers
            Number of voxels along x, y, z.
        spacing, origin, direction, affine, layers
            As `LabelMap` takes them.

        Raises
        ------
        TypeError, ValueError
            As of `LabelMap`.
        """
        if affine is not None:
            if not is_default(spacing, origin, direction):
                raise ValueError("affine replaces spacing, origin and direction: not both")
            spacing, origin, direction = _decomposed(affine)
        sizes = numbers_of("dimensions", dimensions, 3)
        if not ((sizes == np.floor(sizes)) & (sizes >= 1) & (sizes <= LARGEST_DIMENSION)).all():
            raise ValueError(f"dimensions are whole numbers of voxels from 1 to 2^30 - 2, not {tuple(sizes.tolist())}")
        self.dimensions = tuple(int(size) for size in sizes)
        self.spacing, self.origin = numbers_of("spacing", spacing, 3), numbers_of("origin", origin, 3)
        if not ((self.spacing > 0) & (self.spacing <= LARGEST_COORDINATE)).all():
            raise ValueError("spacing has a number that is not positive, not finite or beyond 1e30 mm")
        if not (np.abs(self.origin) <= LARGEST_COORDINATE).all():
            raise ValueError("origin has a number that is not finite or beyond 1e30 mm")
        self.direction = _axes(numbers_of("direction", direction, 9).reshape(3, 3))
        self.layers = None if layers is None else _ascending(layers, self.dimensions[2])
        if self.layers is not None and len(self.layers) > 1:
            self.spacing = np.append(self.spacing[:2], np.diff(self.layers).min())

    def is_same_as(self, other: VoxelGrid) -> bool:
        """But for rounding."""
        return self.dimensions == other.dimensions and all(
            np.allclose(one, two, rtol=1e-6, atol=1e-6 * self.spacing.min()) for one, two in
            ((self.spacing, other.spacing), (self.origin, other.origin), (self.direction, other.direction),
             (self._positions(), other._positions())))

    def to_voxels(self, points: NDArray) -> NDArray[np.float64]:
        """Voxel coordinates of positions in mm."""
        is_orthogonal = np.abs(self.direction.T @ self.direction - np.eye(3)).max() <= 1e-6
        inverse = self.direction.T if is_orthogonal else np.linalg.inv(self.direction)
        voxels = (points - self.origin) @ inverse.T / self.spacing
        if self.layers is not None and len(self.layers) > 1:
            heights = voxels[..., 2] * self.spacing[2]
            below = np.clip(np.searchsorted(self.layers, heights, "right") - 1, 0, len(self.layers) - 2)
            voxels[..., 2] = below + (heights - self.layers[below]) / np.diff(self.layers)[below]
        return voxels

    def to_core(self) -> tuple[list[float], list[float], list[float], list[float]]:
        """Origin, spacing, direction row by row and layers, as the core takes them."""
        return (self.origin.tolist(), self.spacing.tolist(), self.direction.reshape(-1).tolist(),
                [] if self.layers is None else self.layers.tolist())

    def _positions(self) -> NDArray[np.float64]:
        """mm, of all layers along the third axis."""
        return self.layers if self.layers is not None else self.spacing[2] * np.arange(self.dimensions[2])

    def __repr__(self) -> str:
        size, spacing = (" x ".join(f"{value:g}" for value in values) for values in (self.dimensions, self.spacing))
        return f"<bonedecimate.VoxelGrid: {size} voxels of {spacing} mm>"


class LabelMap:
    """A segmentation: a label for each voxel, and where the voxels are."""

    labels: NDArray[np.integer]  #: (nz, ny, nx)
    grid: VoxelGrid
    model_grid_found: str = ""  #: of `on_model_grid`: what was found, in one sentence
    array_name: str = ""  #: of the point array of an image of VTK; empty: no name

    def __init__(self, labels: ArrayLike, *, axes: Literal["zyx", "xyz"] | None = None, spacing: Sequence[float] = (1, 1, 1),
                 origin: Sequence[float] = (0, 0, 0), direction: ArrayLike = IDENTITY, affine: ArrayLike | None = None,
                 layers: Sequence[float] | None = None) -> None:
        """
        Parameters
        ----------
        labels : (nz, ny, nx) array of whole numbers
            Of any type; bool is one label. Floating-point numbers less than 0.01 from whole ones, as a slope in a header gives
            them, are rounded with a warning. Not copied if that is not necessary.
        axes : "zyx" or "xyz", optional
            The order of the indices: ``labels[z, y, x]`` as of ``SimpleITK.GetArrayFromImage``, or ``labels[x, y, z]`` as of
            nibabel's ``image.dataobj``. All other parameters are in the order x, y, z in both cases. Default: "zyx", with affine
            "xyz", and a warning, because nothing else says it.
        spacing : three numbers, mm
            Of the voxels along x, y, z: ``GetSpacing()`` of SimpleITK.
        origin, direction : three numbers, mm; (3, 3) array, or nine numbers row by row
            Center of the first voxel, and the axes as columns: ``GetOrigin()`` and ``GetDirection()``. Axes that are perpendicular but
            for a cosine up to 0.001 are made perpendicular; others are those of a sheared grid, as of a tilted gantry, and stay.
        affine : (4, 4) array, optional
            From voxels x, y, z to mm instead of these three: nibabel's ``image.affine``.
        layers : nz numbers, mm, optional
            Where layers are along the third axis, from the first one, if their distance changes: 0, 4, 8, 15, 22. Then the third
            number of spacing (or the length of the third axis of affine) does not count.

        Raises
        ------
        TypeError
            Labels that are no numbers.
        ValueError
            Shapes, labels with a fraction, spacings that are not positive, axes in one plane, layers that do not ascend from 0.
        """
        if axes is None and affine is None:
            size = " with voxels of 1 mm" if layers is None and is_default(spacing, origin, direction) else ""
            warnings.warn(f"the array is taken as labels[z, y, x]{size}; arrays of nibabel are labels[x, y, z], and in the wrong order bones "
                          "are mirrored: pass the image itself, or axes", stacklevel=3)
        self.labels = volume_from(labels, _axes_of(axes, affine))
        self.grid = VoxelGrid(self.labels.shape[::-1], spacing=spacing, origin=origin, direction=direction, affine=affine,
                              layers=layers)

    @classmethod
    def from_image(cls, image: vtkImageData | SimpleItkImage | NibabelImage | MetaTensor) -> LabelMap:
        """Of an image of VTK, SimpleITK, nibabel or MONAI, where it says that its voxels are, mm.

        Coordinates are LPS, as of DICOM, ITK and 3D Slicer's files: those of nibabel, and of a MetaTensor of one channel whose
        ``meta["space"]`` is RAS, are turned into LPS.

        Raises
        ------
        TypeError, ValueError
            As of `LabelMap`; several values a voxel.

        Warns
        -----
        UserWarning
            The header has two positions (sform, qform) or none, or another unit than mm, which is converted.
        """
        if hasattr(image, "GetDirectionMatrix"):
            from .images import label_map_of  # imports VTK, which is there
            return label_map_of(image)
        if not (is_simpleitk(image) or is_nibabel(image) or is_metatensor(image)):
            raise TypeError(f"an image is one of VTK, SimpleITK, nibabel or MONAI, not {type(image).__name__}")
        labels, axes, where = scan_of(image)
        return cls(labels, axes=axes, **where)

    def on_model_grid(self, model_grid: str | float | Sequence[float] = "auto") -> LabelMap:
        """The coarser map of a network, from whose grid the labels were copied to these voxels; this one if there is none.

        Parameters
        ----------
        model_grid : "auto", "off", number or three numbers, mm
            "auto": if it is certain that the labels were copied. Numbers: the spacing of the network, along x, y, z.

        Raises
        ------
        ValueError
            Another text or number; the labels are no copy from a grid of this spacing.
        """
        choice = model_grid if isinstance(model_grid, str) else ",".join(map(str, np.ravel(model_grid).tolist()))
        found = _core.model_map(self.labels, *self.grid.to_core(), choice)
        if found is None:
            return self
        labels, dimensions, origin, spacing, sentence = found
        made = LabelMap(np.frombuffer(labels, self.labels.dtype).reshape(dimensions[::-1]), axes="zyx", spacing=spacing, origin=origin,
                        direction=self.grid.direction, layers=self.grid.layers)
        made.model_grid_found, made.array_name = sentence, self.array_name
        return made

    @classmethod
    def on(cls, grid: VoxelGrid, labels: ArrayLike) -> LabelMap:
        """Labels with the indices z, y, x on a grid of the same dimensions."""
        made = cls(labels, axes="zyx")
        if made.grid.dimensions != grid.dimensions:
            raise ValueError(f"label_map has the shape {made.labels.shape}, and the voxel grid of the surface has "
                             f"{grid.dimensions[::-1]} voxels (z, y, x); give bonedecimate.LabelMap(label_map, ...)")
        made.grid = grid
        return made

    def __repr__(self) -> str:
        return f"<bonedecimate.LabelMap: {self.labels.dtype} on {self.grid!r}>"


def is_default(spacing: Sequence[float], origin: Sequence[float], direction: ArrayLike) -> bool:
    """Whether nothing says where the voxels are."""
    return np.array_equal(spacing, (1, 1, 1)) and np.array_equal(origin, (0, 0, 0)) and direction is IDENTITY


# Types that a function takes as a label map.
LabelMapLike = Union["LabelMap", "vtkImageData", SimpleItkImage, NibabelImage, MetaTensor, ArrayLike]


def has_grid(label_map: LabelMapLike) -> bool:
    """Whether it is more than an array."""
    return (isinstance(label_map, LabelMap) or hasattr(label_map, "GetDirectionMatrix")
            or is_simpleitk(label_map) or is_nibabel(label_map) or is_metatensor(label_map))


def label_map_from(label_map: LabelMapLike, grid: VoxelGrid | None) -> LabelMap:
    """Of a LabelMap, an image, or an array on the grid of the surface; on that of a network if the surface is (`on_model_grid`)."""
    if has_grid(label_map):
        labels = label_map if isinstance(label_map, LabelMap) else LabelMap.from_image(label_map)
        if grid is None or labels.grid.is_same_as(grid):
            return labels
        model = labels.on_model_grid()
        return model if model.grid.is_same_as(grid) else labels
    if grid is None:
        raise ValueError("label_map is bonedecimate.LabelMap(array, spacing=...) or an image; an array alone is enough "
                         "only with a surface of extract_surfaces, or a result that was made of one")
    return LabelMap.on(grid, label_map)


class SurfaceSource(NamedTuple):
    """What is known of the label map of a surface, as the core takes it."""

    grid: VoxelGrid | None  # None: only the boundary labels are known
    label_values: NDArray[np.int64]  # ascending, and at the end the background; empty: one label
    boundary_labels: NDArray[np.int64] | None = None  # of each triangle, indices into the values
    grid_points: NDArray[np.int32] | None = None  # of each point

    def to_core(self) -> _core.LabelMapSource:
        return _core.LabelMapSource(*self.grid.to_core(), self.grid.dimensions, self.label_values.tolist(),
                                    self.boundary_labels, self.grid_points)

    def values_of(self, indices: NDArray) -> NDArray[np.int64]:
        """Labels, (m, 2), of what the core returns."""
        return self.label_values[indices] if len(indices) else np.empty((0, 2), np.int64)


def source_of(surface: object, points: int, triangles: int) -> SurfaceSource | None:
    """Of what extract_surfaces, decimate or smooth returned; None without a grid."""
    grid = getattr(surface, "grid", None)
    if not isinstance(grid, VoxelGrid):
        return None
    source = SurfaceSource(grid, np.asarray(surface.label_values, dtype=np.int64))
    if len(surface.boundary_labels):
        source = with_boundary_labels(source, surface.boundary_labels, triangles, source.label_values)
    centers = getattr(surface, "grid_points", None)
    if centers is not None:
        if np.shape(centers) != (points, 3):
            raise ValueError(f"grid_points are of shape ({points}, 3), not {np.shape(centers)}")
        source = source._replace(grid_points=np.ascontiguousarray(centers, dtype=np.int32))
    return source


def with_boundary_labels(source: SurfaceSource, boundary_labels: ArrayLike, triangles: int,
                         values: NDArray[np.int64] | None = None) -> SurfaceSource:
    """@param values Of the labels, the background last; None: those that there are, and 0 as background."""
    pairs = pairs_from(boundary_labels, triangles)
    if values is None or not len(values):
        values = values_in(pairs, 0)
    return source._replace(label_values=values, boundary_labels=indices_of(pairs, values))


def indices_of(pairs: NDArray[np.int64], values: NDArray[np.int64], names: tuple[str, str] = ("boundary_labels", "label_values"),
               kind: str = "") -> NDArray[np.int64]:
    """Of labels their indices into the values, of which the background is the last.

    @param names Of both, for messages.
    """
    if (np.diff(values[:-1]) < 0).any():
        raise ValueError(f"{kind}{names[1]} is not in ascending order")
    found = np.searchsorted(values[:-1], pairs)
    found[pairs == values[-1]] = len(values) - 1
    if not np.array_equal(values[found], pairs):
        raise ValueError(f"{kind}{names[0]} has a label that is not one of {names[1]}")
    return np.ascontiguousarray(found, dtype=np.int64)


def values_in(pairs: NDArray[np.int64], background: int) -> NDArray[np.int64]:
    """Ascending, and at the end the background."""
    values = np.unique(pairs)
    return np.append(values[values != background], background).astype(np.int64)


def pairs_from(boundary_labels: ArrayLike, triangles: int) -> NDArray[np.int64]:
    """The labels on both sides of each of the triangles (or cells)."""
    pairs = numeric_array(boundary_labels, "boundary_labels", "iu")
    if pairs.shape != (triangles, 2):
        raise ValueError(f"boundary_labels are of shape ({triangles}, 2), not {pairs.shape}")
    return np.ascontiguousarray(pairs, dtype=np.int64)


def volume_from(labels: ArrayLike, axes: str) -> NDArray[np.integer]:
    """Integers with indices z, y, x, one after the other."""
    if axes not in ("zyx", "xyz"):
        raise ValueError(f"axes are 'zyx' or 'xyz', not {axes!r}")
    volume = numeric_array(labels, "labels of voxels", "biuf")
    if volume.ndim != 3:
        raise ValueError(f"a label map has three dimensions, not {volume.ndim}")
    if axes == "xyz":
        volume = volume.transpose()
    if volume.dtype.kind == "f":
        volume = _rounded(volume)
    kind = np.uint8 if volume.dtype.kind == "b" else volume.dtype.newbyteorder("=")
    return np.ascontiguousarray(volume, dtype=kind)


def _axes_of(axes: str | None, affine: ArrayLike | None) -> str:
    if axes is None and affine is not None:
        warnings.warn("axes is not given: with affine the indices of labels are taken as x, y, z, as of nibabel; "
                      "axes='xyz' or axes='zyx' says so", stacklevel=4)
    return axes if axes is not None else "zyx" if affine is None else "xyz"


def _rounded(volume: NDArray[np.floating]) -> NDArray[np.int64]:
    """Whole numbers, or those that a header's slope left a fraction."""
    whole = np.round(volume)
    with np.errstate(invalid="ignore"):
        distance = np.abs(volume - whole)
        is_label = (distance <= LARGEST_FRACTION) & (np.abs(volume) <= 2**53)
    if not is_label.all():
        raise ValueError("a label map has whole numbers; some have a fraction, or are not finite")
    if distance.any():
        first = np.unravel_index(int(distance.argmax()), volume.shape)
        warnings.warn(f"the values of voxels are whole numbers but for rounding: {volume[first]:.7g} counts as {whole[first]:g}", stacklevel=5)
    return whole.astype(np.int64)


def _axes(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    """The nearest orthogonal matrix of one that is orthogonal but for rounding; itself if it is orthogonal or sheared."""
    deviation = np.abs(direction.T @ direction - np.eye(3)).max()
    if deviation <= ORTHOGONAL:
        return direction
    if deviation <= ORTHOGONAL_BUT_FOR_ROUNDING:
        left, _stretch, right = np.linalg.svd(direction)
        return left @ right
    lengths = np.sqrt((direction**2).sum(axis=0))
    if not (np.abs(lengths - 1) <= ORTHOGONAL_BUT_FOR_ROUNDING).all() or not abs(np.linalg.det(direction)) >= LEAST_DETERMINANT:
        raise ValueError("direction has no unit vectors that are not in one plane as columns")
    return direction / lengths


def _ascending(layers: Sequence[float], count: int) -> NDArray[np.float64]:
    positions = numbers_of("layers", layers, count)
    if positions[0] != 0 or not (np.diff(positions) > 0).all() or not positions[-1] <= LARGEST_COORDINATE:
        raise ValueError("layers do not ascend from 0, in mm")
    return positions


def _decomposed(affine: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Spacing, origin and direction."""
    matrix = np.asarray(affine, dtype=np.float64)
    if matrix.shape != (4, 4):
        raise ValueError(f"affine has the shape (4, 4), not {matrix.shape}")
    if (matrix[3] != (0, 0, 0, 1)).any():
        raise ValueError(f"the last row of affine is 0 0 0 1, not {matrix[3]}")
    spacing = np.sqrt((matrix[:3, :3] ** 2).sum(axis=0))
    if not (np.isfinite(spacing).all() and (spacing > 0).all()):
        raise ValueError("affine has an axis without length")
    return spacing, matrix[:3, 3], matrix[:3, :3] / spacing
