// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ListLeftOut.h"

#include "Geometry/TriangleGeometry.h"
#include "Proof/Certificate/Certificate.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace bonedecimate
{
namespace
{
using Shapes = std::vector<std::array<Vector3, 3>>;

/// Relative gap between the bounds of the distance of what was left out.
constexpr double DistanceGap = 1e-3;

LeftOutShape PrunedComponents(const PruneFigures& pruned, Shapes shapes)
{
  const std::size_t count = pruned.Components.size();
  LeftOutShape found;
  found.Entry = { "components", static_cast<std::int64_t>(count),
    count == 1 ? "pruned component" : "pruned components", {} };
  found.Triangles = std::move(shapes);
  return found;
}

/// What the run itself left out of its input.
std::vector<LeftOutShape> LeftOutOfInput(
  const Surface& input, const CleanSurface& cleaned, const Report& report)
{
  std::vector<LeftOutShape> found;
  const std::int64_t dropped = report.Cleaning.DroppedTriangles;
  const bool isPruned = report.Pruned.IsRequested && !report.Pruned.Components.empty();
  if (dropped > 0 || isPruned)
  {
    const std::vector<Triangle> missing = KeptPart(input, cleaned).LeftOut;
    if (dropped > 0)
    {
      found.push_back(TrianglesWithoutArea(
        dropped, report.Cleaning.FirstDroppedTriangle, ShapesOf(input.Points, missing, true)));
    }
    if (isPruned)
    {
      found.push_back(PrunedComponents(report.Pruned, ShapesOf(input.Points, missing, false)));
    }
  }
  return found;
}
}

Shapes ShapesOf(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles, bool withoutArea)
{
  Shapes shapes;
  for (const Triangle& c : triangles)
  {
    const bool isFlat = AreaVector(points[c[0]], points[c[1]], points[c[2]]).isZero(0.0);
    if (isFlat == withoutArea)
    {
      shapes.push_back({ points[c[0]], points[c[1]], points[c[2]] });
    }
  }
  return shapes;
}

//------------------------------------------------------------------------------
LeftOutShape TrianglesWithoutArea(std::int64_t count, std::int64_t first, Shapes shapes)
{
  LeftOutShape found;
  found.Entry = { "triangles", count,
    count == 1 ? "triangle without area" : "triangles without area", {} };
  found.Entry.FirstTriangle = first;
  found.Triangles = std::move(shapes);
  return found;
}

//------------------------------------------------------------------------------
double MaxDistance(const Shapes& shapes, const Surface& surface, int threads)
{
  Surface source;
  for (const std::array<Vector3, 3>& corners : shapes)
  {
    const auto first = static_cast<Index>(source.Points.size());
    source.Points.insert(source.Points.end(), corners.begin(), corners.end());
    source.Triangles.push_back({ first, first + 1, first + 2 });
  }
  CertificateOptions question;
  question.OneSided = true;
  question.WithBoundaries = false;
  question.RelativeGap = DistanceGap;
  question.NumberOfThreads = threads;
  const Certificate found = Certify(source, surface, question);
  return found.Status == CertificateStatus::Good ? found.ReferenceToResult.Distance.Upper
                                                 : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
void ListLeftOut(const Surface& input, const CleanSurface& cleaned, const KeptSurface* reference,
  const RunInputs& inputs, Result& result)
{
  std::vector<LeftOutShape> all;
  if (reference == nullptr)
  {
    all = LeftOutOfInput(input, cleaned, result.Report);
  }
  else if (!reference->LeftOut.empty())
  {
    all.push_back(TrianglesWithoutArea(static_cast<std::int64_t>(reference->LeftOut.size()), -1,
      ShapesOf(reference->Surface.Points, reference->LeftOut, true)));
  }
  if (inputs.LeftOut != nullptr)
  {
    all.insert(all.end(), inputs.LeftOut->begin(), inputs.LeftOut->end());
  }
  MeasureLeftOut(std::move(all), result);
}

//------------------------------------------------------------------------------
void MeasureLeftOut(std::vector<LeftOutShape> all, Result& result)
{
  Report& report = result.Report;
  const int threads = report.Requested.NumberOfThreads;
  const Surface nothing;
  report.LeftOut =
    DistancesOf(std::move(all), report.Proof.WasMade ? result.Surface : nothing, threads);
}

//------------------------------------------------------------------------------
std::vector<LeftOut> DistancesOf(std::vector<LeftOutShape> all, const Surface& surface, int threads)
{
  std::vector<LeftOut> entries;
  for (LeftOutShape& found : all)
  {
    found.Entry.Distance = MaxDistance(found.Triangles, surface, threads);
    entries.push_back(std::move(found.Entry));
  }
  return entries;
}

//------------------------------------------------------------------------------
std::vector<LeftOut> LeftOutOfPair(const std::vector<LeftOutShape>& ofReference,
  const Surface& reference, const std::vector<LeftOutShape>& ofResult, const Surface& result,
  int threads)
{
  std::vector<LeftOut> entries = DistancesOf(ofReference, result, threads);
  for (LeftOut& entry : entries)
  {
    entry.What += " of the reference";
  }
  for (LeftOut& entry : DistancesOf(ofResult, reference, threads))
  {
    entry.What += " of the result";
    entries.push_back(std::move(entry));
  }
  return entries;
}
}
