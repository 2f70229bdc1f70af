// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Geometry/PolygonTriangulation.h"

namespace bonedecimate
{
namespace
{
/// The same as TriangulateCells() of the filter: triangles as they are, even without area.
nb::tuple Triangulate(
  const PointsIn& points, const CellsIn& offsets, const CellsIn& ids, bool areStrips)
{
  std::vector<Vector3> positions;
  for (std::size_t point = 0; point < points.shape(0); ++point)
  {
    const double* const position = points.data() + 3 * point;
    positions.emplace_back(position[0], position[1], position[2]);
  }
  PolygonTriangulation triangulation(positions);
  std::vector<Triangle> triangles;
  std::vector<std::int64_t> cells;
  std::vector<Index> corners;
  for (std::size_t cell = 0; cell + 1 < offsets.shape(0); ++cell)
  {
    corners.assign(ids.data() + offsets.data()[cell], ids.data() + offsets.data()[cell + 1]);
    if (areStrips || corners.size() == 3)
    {
      AppendStrip(corners, triangles);
    }
    else
    {
      triangulation.Append(corners, triangles);
    }
    cells.resize(triangles.size(), static_cast<std::int64_t>(cell));
  }
  return nb::make_tuple(ToRows<Index>(std::move(triangles)), ToArray(std::move(cells)));
}
}

//------------------------------------------------------------------------------
void BindPolygons(nb::module_& module)
{
  module.def("triangulate", &Triangulate, nb::arg("points"), nb::arg("offsets"), nb::arg("ids"),
    nb::arg("strips"),
    "Triangles of polygons or strips, and for each the number of the cell it came from; ids are "
    "valid.");
}
}
