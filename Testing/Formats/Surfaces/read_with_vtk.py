# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's readers: those of the Python that runs this, Debian's or PyPI's."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkOutputWindow, vtkStringArray
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

CLASSES = {"obj": vtkOBJReader, "ply": vtkPLYReader, "stl": vtkSTLReader, "vtk": vtkPolyDataReader, "vtp": vtkXMLPolyDataReader}


def cells(array):
    ids, found = vtkIdList(), []
    for i in range(array.GetNumberOfCells()):
        array.GetCellAtId(i, ids)
        found.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
    return found


def arrays(data):
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        if isinstance(array, vtkStringArray):
            values = [str(array.GetValue(k)) for k in range(array.GetNumberOfValues())]
        elif array.IsNumeric():
            values = vtk_to_numpy(array).ravel().tolist() if array.GetNumberOfValues() else []
        else:
            values = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
        found[array.GetName() or ""] = {
            "type": array.GetDataTypeAsString(),
            "components": array.GetNumberOfComponents(),
            "values": values,
        }
    return found


def as_dict(surface):
    points = surface.GetPoints()
    data = surface.GetPointData()

    def name(array):
        return None if array is None else array.GetName()

    return {
        "points": vtk_to_numpy(points.GetData()).astype(float).tolist() if points and points.GetNumberOfPoints() else [],
        "verts": cells(surface.GetVerts()),
        "lines": cells(surface.GetLines()),
        "polys": cells(surface.GetPolys()),
        "strips": cells(surface.GetStrips()),
        "point_data": arrays(data),
        "cell_data": arrays(surface.GetCellData()),
        "field_data": arrays(surface.GetFieldData()),
        "normals": name(data.GetNormals()),
        "uv": name(data.GetTCoords()),
    }


def read_gltf(path):
    """All blocks, moved by the transforms of their nodes."""
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData
    from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter

    reader = vtkGLTFReader()
    reader.SetFileName(str(path))
    reader.ApplyDeformationsToGeometryOn()
    reader.Update()
    output = reader.GetOutput()
    if output is None or output.GetNumberOfBlocks() == 0:
        raise ValueError("nothing")
    blocks, append = output.NewTreeIterator() if hasattr(output, "NewTreeIterator") else output.NewIterator(), vtkAppendPolyData()
    blocks.InitTraversal()
    while not blocks.IsDoneWithTraversal():
        append.AddInputData(blocks.GetCurrentDataObject())
        blocks.GoToNextItem()
    append.Update()
    return as_dict(append.GetOutput())


def read(path):
    vtkOutputWindow.GetInstance().SetDisplayModeToNever()
    extension = path.suffix[1:]
    if extension == "glb":
        return read_gltf(path)
    reader = CLASSES[extension]()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    if extension == "vtk":
        for kind in ("Scalars", "Vectors", "Normals", "Tensors", "ColorScalars", "TCoords", "Fields"):
            getattr(reader, "ReadAll" + kind + "On")()
    if extension == "stl":
        reader.MergingOff()
    reader.Update()
    surface = as_dict(reader.GetOutput())
    if extension == "vtk":
        surface["title"] = reader.GetHeader()
    if not surface["polys"] and not surface["strips"]:
        raise ValueError("no polygon")
    return surface
