// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Repair/Caps/CloseBoundaries.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

namespace bonedecimate
{
namespace
{
/// @param triangulate Function of points, starts and normal to rows of three ids.
std::vector<Triangle> CallTriangulate(const nb::callable& triangulate, const Contours& contours)
{
  std::vector<Vector3> points = contours.Points;
  std::vector<Index> starts = contours.Starts;
  const Vector3& normal = contours.Normal;
  const nb::object found = triangulate(ToRows<double>(std::move(points)),
    ToArray<Index>(std::move(starts)), nb::make_tuple(normal[0], normal[1], normal[2]));
  const auto rows = nb::cast<TrianglesIn>(found);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < rows.shape(0); ++i)
  {
    const Index* corners = rows.data() + 3 * i;
    triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  return triangles;
}

nb::dict Close(const PointsIn& points, const TrianglesIn& triangles, bool closesAll,
  double planeTolerance, const nb::callable& triangulate)
{
  CapsOfSurface caps = CloseBoundaries(ToSurface(points, triangles), { closesAll, planeTolerance },
    [&](const Contours& contours) { return CallTriangulate(triangulate, contours); });
  nb::dict fields;
  fields["caps"] = caps.NumberOfCaps;
  fields["area"] = caps.Area;
  fields["closed_loops"] = caps.ClosedLoops;
  fields["open_loops"] = caps.OpenLoops;
  std::vector<Index> ends;
  for (const PointPair& pair : caps.Ends)
  {
    ends.push_back(pair.first);
  }
  fields["triangles"] = ToRows<Index>(std::move(caps.Triangles));
  fields["neighbors"] = ToArray<Index>(std::move(caps.Neighbors));
  fields["points"] = ToRows<double>(std::move(caps.Points));
  fields["ends"] = ToArray<Index>(std::move(ends));
  return fields;
}
}

//------------------------------------------------------------------------------
void BindCaps(nb::module_& module)
{
  module.def("close_boundaries", &Close, nb::arg("points"), nb::arg("triangles"),
    nb::arg("closes_all"), nb::arg("plane_tolerance"), nb::arg("triangulate"),
    "What is added to a surface to close its boundaries; the keys are those of CloseBoundaries.h.");
}
}
