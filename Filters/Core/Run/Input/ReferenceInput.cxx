// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceInput.h"

#include "Geometry/BoundingTree.h"
#include "Mesh/Checksum.h"
#include "Proof/Certificate/Certificate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Gap of the bounds of a triangle, as a fraction of the largest error.
constexpr double TriangleGap = 0.01;
/// The same for the distance of the whole surface.
constexpr double WholeGap = 1e-4;
/// Margins for rounding: of the differences below, relative to the largest error; of
/// distances, relative to coordinates.
constexpr double RelativeSlack = 1e-12;

Certificate DistanceOf(
  const Surface& reference, const Surface& input, const Options& options, const Monitor& monitor)
{
  CertificateOptions question;
  question.Tolerance = options.MaximumError;
  question.RelativeGap = TriangleGap;
  question.MinGap = WholeGap * options.MaximumError;
  question.ReferenceTriangleGap = TriangleGap * options.MaximumError;
  question.ResultTriangleGap = question.ReferenceTriangleGap;
  question.WithBoundaries = options.MergePoints;
  question.NumberOfThreads = options.NumberOfThreads;
  return Certify(reference, input, question, monitor);
}

double MaxCoordinateOf(const Surface& surface)
{
  double largest = 0.0;
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index corner : triangle)
    {
      largest = std::max(largest, surface.Points[corner].cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

std::array<Vector3, 3> CornersOf(const Surface& surface, Index triangle)
{
  const Triangle& v = surface.Triangles[triangle];
  return { surface.Points[v[0]], surface.Points[v[1]], surface.Points[v[2]] };
}

/// Raises the bound of every triangle of the input that may be the nearest to a point of a
/// reference triangle.
/// @param bounds mm, for each reference triangle.  @param used mm, for each triangle of the input.
void RaiseToNearest(const Surface& reference, const std::vector<double>& bounds,
  const Surface& input, int threads, std::vector<double>& used)
{
  const BoundingTree tree(input, threads);
  const double rounding =
    RelativeSlack * std::max(MaxCoordinateOf(reference), MaxCoordinateOf(input));
  for (std::size_t r = 0; r < bounds.size(); ++r)
  {
    const std::array<Vector3, 3> c = CornersOf(reference, static_cast<Index>(r));
    const Vector3 middle = (c[0] + c[1] + c[2]) / 3.0;
    const double radius =
      std::max({ (c[0] - middle).norm(), (c[1] - middle).norm(), (c[2] - middle).norm() });
    const double reach = bounds[r] + radius + rounding; // mm
    const double squaredReach = reach * reach;
    tree.VisitNear(middle, squaredReach,
      [&](Index t)
      {
        if (used[t] < bounds[r])
        {
          const std::array<Vector3, 3> at = CornersOf(input, t);
          const bool isNear =
            NearestOnTriangle(middle, at[0], at[1], at[2]).SquaredDistance <= squaredReach;
          used[t] = isNear ? bounds[r] : used[t];
        }
      });
  }
}

/// The ends of boundary edges after merging points of equal coordinates, as points of the input.
std::vector<Index> BoundaryPoints(const CleanSurface& cleaned)
{
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(3 * cleaned.Surface.Triangles.size());
  for (const Triangle& t : cleaned.Surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      edges.push_back({ std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3]) });
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Index> points;
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next)
  {
    while (next < edges.size() && edges[next] == edges[first])
    {
      ++next;
    }
    if (next - first == 1)
    {
      points.push_back(cleaned.InputPoint[edges[first][0]]);
      points.push_back(cleaned.InputPoint[edges[first][1]]);
    }
  }
  return points;
}

/// mm, for each point of the input.
std::vector<double> LeftOf(const Surface& reference, const KeptSurface& input,
  const CleanSurface& cleaned, const Certificate& found, const Options& options)
{
  std::vector<double> used = found.ResultToReference.TriangleUpper;
  RaiseToNearest(
    reference, found.ReferenceToResult.TriangleUpper, input.Surface, options.NumberOfThreads, used);
  const double error = options.MaximumError * (1.0 - RelativeSlack);
  std::vector<double> left(input.Surface.Points.size(), options.MaximumError);
  const auto lower = [&](Index point, double usedThere)
  { left[point] = std::min(left[point], std::max(0.0, error - usedThere)); };
  for (std::size_t t = 0; t < used.size(); ++t)
  {
    for (const Index corner : input.Surface.Triangles[t])
    {
      lower(corner, used[t]);
    }
  }
  if (options.MergePoints)
  {
    const double boundary = std::max(found.BoundaryOfReferenceToResult.Distance.Upper,
      found.BoundaryOfResultToReference.Distance.Upper);
    for (const Index point : BoundaryPoints(cleaned))
    {
      lower(point, boundary);
    }
  }
  return left;
}
}

KeptSurface KeptPart(const Surface& input, const CleanSurface& cleaned)
{
  std::vector<Index> triangles = cleaned.InputTriangle;
  std::sort(triangles.begin(), triangles.end());
  KeptSurface kept;
  kept.Surface.Points = input.Points;
  kept.Surface.Triangles.reserve(triangles.size());
  auto next = triangles.begin();
  for (std::size_t t = 0; t < input.Triangles.size(); ++t)
  {
    const bool isKept = next != triangles.end() && static_cast<std::size_t>(*next) == t;
    next += isKept ? 1 : 0;
    (isKept ? kept.Surface.Triangles : kept.LeftOut).push_back(input.Triangles[t]);
  }
  return kept;
}

//------------------------------------------------------------------------------
ReferenceInput CompareWithReference(const Surface& reference, const Surface& input,
  const CleanSurface& cleaned, const Options& options, const Monitor& monitor)
{
  ReferenceInput prepared;
  if (!options.BoundsError())
  {
    prepared.Status = InputStatus::ReferenceWithoutError;
    return prepared;
  }
  {
    const CleanSurface clean = Clean(reference, options.MergePoints, options.NumberOfThreads);
    if (clean.Status != InputStatus::Good)
    {
      prepared.Status = InputStatus::BadReference;
      return prepared;
    }
    prepared.Reference = KeptPart(reference, clean);
  }
  const Surface& first = prepared.Reference.Surface;
  const KeptSurface kept = KeptPart(input, cleaned);
  const Certificate found = DistanceOf(first, kept.Surface, options, monitor);
  if (found.Status != CertificateStatus::Good)
  {
    prepared.Left.assign(input.Points.size(), 0.0); // aborted
    return prepared;
  }
  prepared.Figures = { true, static_cast<std::int64_t>(first.Triangles.size()),
    Checksum(reference, options.NumberOfThreads), { found.Lower(), found.Upper() } };
  if (found.Proof == ProofStatus::Violated)
  {
    prepared.Status = InputStatus::FarFromReference;
    return prepared;
  }
  prepared.Left = LeftOf(first, kept, cleaned, found, options);
  return prepared;
}
}
