# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of other people. Each returns a Reading in LPS, mm as the file's unit says, or raises."""

import numpy as np

from truth import Reading, NotRead

LPS = np.array([-1, -1, 1])


def optional(name):
    """A module, or None where it is not installed."""
    try:
        return __import__(name, fromlist=["_"])
    except ImportError:
        return None


nibabel = optional("nibabel")
nrrd = optional("nrrd")
SimpleITK = optional("SimpleITK")
vtk = optional("vtk")
if vtk:
    vtk.vtkObject.GlobalWarningDisplayOff()
if SimpleITK:
    SimpleITK.ProcessObject.SetGlobalWarningDisplay(False)


def simpleitk(path, choice):
    """Spacing and origin as they are in the file."""
    reading = simpleitk_in_mm(path, choice)
    reading.is_in_units = True
    return reading


def simpleitk_in_mm(path, choice):
    image = SimpleITK.ReadImage(str(path))
    voxels = SimpleITK.GetArrayFromImage(image)
    if image.GetDimension() == 4 and image.GetSize()[3] == 1:
        raise NotRead("four dimensions")
    if image.GetDimension() != 3 or image.GetNumberOfComponentsPerPixel() != 1:
        raise NotRead("no volume of one value a voxel")
    direction = np.array(image.GetDirection()).reshape(3, 3)
    steps = (direction * np.array(image.GetSpacing())).T
    return Reading(voxels.transpose(), np.array(image.GetOrigin()), steps)


def nibabel_image(path, choice):
    image = nibabel.load(str(path))
    shape = image.shape + (1,) * (3 - len(image.shape))
    if np.prod(shape[3:], dtype=int) != 1:
        raise NotRead("several volumes")
    array = np.asanyarray(image.dataobj).reshape(shape[:3], order="F")
    if array.dtype.names or array.dtype.kind not in "iuf":
        raise NotRead("no numbers")
    affine = image.affine
    return Reading(array, affine[:3, 3] * LPS, affine[:3, :3].T * LPS, is_in_units=True)


PYNRRD_SIGNS = {"left-posterior-superior": LPS * LPS, "lps": LPS * LPS, "right-anterior-superior": LPS, "ras": LPS,
                "left-anterior-superior": np.array([1, -1, 1]), "las": np.array([1, -1, 1])}


def pynrrd(path, choice):
    data, header = nrrd.read(str(path))
    if header["dimension"] != 3:
        kept = [axis for axis, size in enumerate(data.shape) if size != 1]
        if len(kept) != 3:
            raise NotRead("several values a voxel")
        data = data.reshape([data.shape[axis] for axis in kept])
    directions = header.get("space directions")
    if directions is not None:
        steps = np.array([row for row in directions if np.isfinite(row).all()], float)
        sign = PYNRRD_SIGNS.get(str(header.get("space", "")).lower(), np.ones(3))
        origin = np.array(header.get("space origin", np.zeros(3)))
        return Reading(data, origin * sign, steps * sign, is_in_units=True)
    if "spacings" in header:
        spacings = np.array([value for value in header["spacings"] if np.isfinite(value)])
        return Reading(data, None, np.diag(spacings))
    return Reading(data)


def array_of(image):
    from vtk.util.numpy_support import vtk_to_numpy
    data = image.GetPointData()
    scalars = data.GetScalars() or (data.GetArray(0) if data.GetNumberOfArrays() == 1 else None)
    if scalars is None or scalars.GetNumberOfComponents() != 1:
        raise NotRead("no array of one value a voxel")
    return vtk_to_numpy(scalars).reshape(image.GetDimensions(), order="F").copy()


def update(reader, path):
    """Runs a reader of VTK; errors are exceptions."""
    errors = []
    for name in ("ErrorEvent",):
        reader.AddObserver(name, lambda *_: errors.append(1))
    reader.SetFileName(str(path))
    if hasattr(reader, "CanReadFile") and not reader.CanReadFile(str(path)):
        raise NotRead("it cannot read the file")
    reader.Update()
    if errors:
        raise NotRead("it has an error")
    return reader.GetOutput()


def matrix_of(matrix):
    return np.array([[matrix.GetElement(row, column) for column in range(4)] for row in range(4)])


def vtk_nifti(path, choice):
    reader = vtk.vtkNIFTIImageReader()
    image = update(reader, path)
    voxels = array_of(image)
    if reader.GetQFac() < 0:  # turned to be right-handed
        voxels = voxels[:, :, ::-1]
    slope, intercept = reader.GetRescaleSlope(), reader.GetRescaleIntercept()
    if (slope, intercept) != (1, 0) and slope != 0 and np.isfinite(slope):
        voxels = voxels * slope + intercept
    return Reading(voxels)


def vtk_image(reader):
    """@param reader The name of a class, whose images have directions from VTK 9 on, or not."""
    def read(path, choice):
        image = update(getattr(vtk, reader)(), path)
        return Reading(array_of(image))
    return read


def vti(path, choice):
    image = update(vtk.vtkXMLImageDataReader(), path)
    direction = image.GetDirectionMatrix()
    matrix = np.array([[direction.GetElement(row, column) for column in range(3)] for row in range(3)])
    steps = (matrix * np.array(image.GetSpacing())).T
    origin = np.array(image.GetOrigin()) + np.array(image.GetExtent()[::2]) @ steps
    return Reading(array_of(image), origin, steps)


tifffile = optional("tifffile")


def pages_of(path, read):
    """[x, y, z] of a file of several pages, or of the slices of a folder. @param read [z, y, x] or [y, x]"""
    if path.is_dir():
        number = lambda name: int("".join(c for c in name.stem if c.isdigit()))
        return np.stack([read(file).squeeze() for file in sorted(path.iterdir(), key=number)]).transpose()
    return read(path).transpose()


def simpleitk_tiff(path, choice):
    return Reading(pages_of(path, lambda file: SimpleITK.GetArrayFromImage(SimpleITK.ReadImage(str(file)))))


def tifffile_pages(path, choice):
    return Reading(pages_of(path, lambda file: np.stack([page.asarray() for page in tifffile.TiffFile(file).pages])))


def vtk_tiff(path, choice):
    def read(file):
        reader = vtk.vtkTIFFReader()
        reader.SetOrientationType(1)
        return array_of(update(reader, file)).transpose()
    return Reading(pages_of(path, read))
