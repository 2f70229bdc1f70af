# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of arrays in Documentation/results/formats.md: the same file through the program and through two of VTK's filters.

The expected value comes from VTK's locators: interpolated at the closest position on the input, or that of the closest
input point, or that of the cell closest to the centroid of the triangle. `arrays_table_test.py --print` prints the table. The
columns of VTK's filters are compared with the page only by the version of VTK that the page names.
"""

import math
import pathlib
import sys

import vtk

from application import ApplicationTest, main, read, torus, write

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "results" / "formats.md"
PRINTS = False
TRIANGLES = 480
WHOLE_TYPES = (
    vtk.VTK_SIGNED_CHAR, vtk.VTK_UNSIGNED_CHAR, vtk.VTK_SHORT, vtk.VTK_UNSIGNED_SHORT, vtk.VTK_INT,
    vtk.VTK_UNSIGNED_INT, vtk.VTK_LONG_LONG, vtk.VTK_UNSIGNED_LONG_LONG, vtk.VTK_ID_TYPE,
)
NEAR = 1e-4  # mm, and in the units of the values, which change by a few in a millimeter


def field(point, component):
    """A value that is linear in space, so that its interpolation in a triangle is known."""
    return (component + 1) * point[0] + 0.5 * point[1] - component * point[2]


def label(number):
    """Whole numbers of which no two have their mean between them in the array: a blend is found."""
    return (number * 37) % 50 * 2 + number % 2


def blended(name, kind, components, points):
    array = vtk.vtkDataArray.CreateDataArray(kind)
    array.SetName(name)
    array.SetNumberOfComponents(components)
    for point in points:
        array.InsertNextTuple([field(point, component) for component in range(components)])
    return array


def whole(name, kind, count):
    array = vtk.vtkBitArray() if kind == vtk.VTK_BIT else vtk.vtkDataArray.CreateDataArray(kind)
    array.SetName(name)
    for number in range(count):
        array.InsertNextTuple([label(number) % (2 if kind == vtk.VTK_BIT else 100)])
    return array


def texts(name, count):
    array = vtk.vtkStringArray()
    array.SetName(name)
    for number in range(count):
        array.InsertNextValue(f"piece {label(number)}")
    return array


def normals(surface):
    compute = vtk.vtkPolyDataNormals()
    compute.SetInputData(surface)
    compute.SplittingOff()
    compute.Update()
    return compute.GetOutput().GetPointData().GetNormals()


def bone():
    """A surface with every kind of array that a file can hold."""
    surface = torus()
    points = points_of(surface)
    data = surface.GetPointData()
    density = blended("density", vtk.VTK_DOUBLE, 1, points)
    density.SetComponentName(0, "g/cm3")
    data.SetScalars(density)
    data.SetVectors(blended("drift", vtk.VTK_FLOAT, 3, points))
    data.SetTensors(blended("stress", vtk.VTK_FLOAT, 9, points))
    data.SetTCoords(blended("texture", vtk.VTK_FLOAT, 2, points))
    data.SetNormals(normals(surface))
    ids = whole("global", vtk.VTK_ID_TYPE, 0)
    for number in range(len(points)):
        ids.InsertNextTuple([7 * number])
    data.SetGlobalIds(ids)
    for number, kind in enumerate((*WHOLE_TYPES, vtk.VTK_BIT)):
        data.AddArray(whole(f"label{number}", kind, len(points)))
    data.AddArray(texts("name", len(points)))
    cells = surface.GetNumberOfPolys()
    for number, kind in enumerate((vtk.VTK_INT, vtk.VTK_BIT)):
        surface.GetCellData().AddArray(whole(f"piece{number}", kind, cells))
    surface.GetCellData().SetScalars(blended("thickness", vtk.VTK_DOUBLE, 1, middles(surface)))
    surface.GetCellData().AddArray(texts("region", cells))
    surface.GetFieldData().AddArray(texts("patient", 1))
    return surface


def points_of(surface):
    return [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]


def value(array, number):
    return array.GetValue(number) if isinstance(array, vtk.vtkStringArray) else array.GetTuple1(number)


def middles(surface):
    corners = (surface.GetCell(cell).GetPoints() for cell in range(surface.GetNumberOfCells()))
    return [tuple(sum(c.GetPoint(k)[axis] for k in range(3)) / 3 for axis in range(3)) for c in corners]


def with_filter(filter_, surface):
    filter_.SetInputData(surface)
    filter_.SetTargetReduction(1 - TRIANGLES / surface.GetNumberOfPolys())
    filter_.Update()
    return filter_.GetOutput()


class Comparison:
    """The arrays of a surface beside those of a surface made from it."""

    def __init__(self, before, after):
        self.before, self.after = before, after
        self.cells = vtk.vtkStaticCellLocator()
        self.cells.SetDataSet(before)
        self.cells.BuildLocator()
        self.points = vtk.vtkStaticPointLocator()
        self.points.SetDataSet(before)
        self.points.BuildLocator()

    def closest_position(self, point):
        position, cell, sub, distance = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
        self.cells.FindClosestPoint(point, position, cell, sub, distance)
        return position

    def closest_points(self, point):
        """All that are as near as the nearest."""
        nearest = self.before.GetPoint(self.points.FindClosestPoint(point))
        found = vtk.vtkIdList()
        self.points.FindPointsWithinRadius(math.dist(point, nearest) + NEAR, point, found)
        return [found.GetId(i) for i in range(found.GetNumberOfIds())]

    def closest_cells(self, point):
        position = self.closest_position(point)
        found = vtk.vtkIdList()
        self.cells.FindCellsWithinBounds([c + s * NEAR for c in position for s in (-1, 1)], found)
        return [found.GetId(i) for i in range(found.GetNumberOfIds())]

    def arrays(self, name, cells=False):
        side = vtk.vtkPolyData.GetCellData if cells else vtk.vtkPolyData.GetPointData
        return tuple(side(surface).GetAbstractArray(name) for surface in (self.before, self.after))

    def blended(self, name):
        before, after = self.arrays(name)
        if not after:
            return "gone"
        worst = 0.0
        for number in range(self.after.GetNumberOfPoints()):
            position = self.closest_position(self.after.GetPoint(number))
            for component in range(before.GetNumberOfComponents()):
                worst = max(worst, abs(after.GetComponent(number, component) - field(position, component)))
        return self.kind(before, after) + ("interpolated at the closest position" if worst < NEAR else f"off by up to {worst:.2g}")

    def chosen(self, name, cells=False):
        before, after = self.arrays(name, cells)
        if not after:
            return "gone"
        positions = middles(self.after) if cells else points_of(self.after)
        candidates = self.closest_cells if cells else self.closest_points
        right = sum(
            any(value(before, i) == value(after, number) for i in candidates(position))
            for number, position in enumerate(positions)
        )
        whose = "cell" if cells else "point"
        return self.kind(before, after) + (
            f"that of the closest {whose}" if right == len(positions) else f"right for {right} of {len(positions)}"
        )

    def normals(self):
        after = self.after.GetPointData().GetNormals()
        if not after:
            return "gone"
        lengths = [math.hypot(*after.GetTuple3(i)) for i in range(after.GetNumberOfTuples())]
        least, most = min(lengths), max(lengths)
        return "of length 1" if abs(least - 1) + abs(most - 1) < NEAR else f"of length {least:.2f} to {most:.2f}"

    def attributes(self):
        names = ("Scalars", "Vectors", "Normals", "TCoords", "Tensors", "GlobalIds")
        data = self.after.GetPointData()
        kept = [name for name in names if getattr(data, "Get" + name)()]
        return "all" if len(kept) == len(names) else ", ".join(kept) if kept else "none"

    def component_name(self):
        after = self.arrays("density")[1]
        return "gone" if not after else "kept" if after.GetComponentName(0) == "g/cm3" else "lost"

    def field_data(self):
        return "kept" if self.after.GetFieldData().GetAbstractArray("patient") else "gone"

    @staticmethod
    def kind(before, after):
        same = before.GetDataType() == after.GetDataType()
        return "" if same else f"as {after.GetDataTypeAsString()}: "

    def all_of(self, names, what):
        """One outcome, or each with how many arrays it is of."""
        outcomes = [what(name) for name in names]
        return "; ".join(
            outcome if len(set(outcomes)) == 1 else f"{outcomes.count(outcome)} {outcome}"
            for outcome in dict.fromkeys(outcomes)
        )

    def rows(self):
        labels = [f"label{number}" for number in range(len(WHOLE_TYPES))]
        yield "double scalars", self.blended("density")
        yield "component name of the scalars", self.component_name()
        yield "float vectors", self.blended("drift")
        yield "tensors", self.blended("stress")
        yield "texture coordinates", self.blended("texture")
        yield "normals", self.normals()
        yield f"integers of {len(labels)} types", self.all_of(labels, self.chosen)
        yield "bits", self.chosen(f"label{len(labels)}")
        yield "text", self.chosen("name")
        yield "global ids", self.chosen("global")
        yield "active attributes", self.attributes()
        yield "cell arrays: integers, bits, doubles, text", self.all_of(
            ("piece0", "piece1", "thickness", "region"), lambda name: self.chosen(name, cells=True)
        )
        yield "field data", self.field_data()


class ArraysTable(ApplicationTest):
    def columns(self):
        write(bone(), self.path("in.vtp"))
        before = read(self.path("in.vtp"))
        self.succeed("in.vtp", "out.vtp", "--target-triangles", TRIANGLES, "--quiet")
        yield "vtkBoneDecimate", Comparison(before, read(self.path("out.vtp")))
        quadric = vtk.vtkQuadricDecimation()
        quadric.AttributeErrorMetricOn()
        yield "vtkQuadricDecimation", Comparison(before, with_filter(quadric, before))
        pro = vtk.vtkDecimatePro()
        pro.PreserveTopologyOn()
        yield "vtkDecimatePro", Comparison(before, with_filter(pro, before))

    def table(self):
        columns = {name: list(comparison.rows()) for name, comparison in self.columns()}
        lines = ["| array | " + " | ".join(f"`{name}`" for name in columns) + " |", "|---|---|---|---|"]
        for row in zip(*columns.values()):
            lines.append(f"| {row[0][0]} | " + " | ".join(outcome for _, outcome in row) + " |")
        return lines

    def test_says_what_the_documentation_says(self):
        lines = self.table()
        if PRINTS:
            print("\n" + "\n".join(lines))
        page = PAGE.read_text(encoding="utf-8")
        if f"made with VTK {vtk.VTK_VERSION}" in page:
            self.assertIn("\n".join(lines), page)
        for line in lines[2:]:
            self.assertIn(" | ".join(line.split(" | ")[:2]), page)


if __name__ == "__main__":
    PRINTS = "--print" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--print"]
    main()
