// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlabRuns.h
 * @brief Surfaces of sampled functions, cut into slabs between layers of voxels, and runs over
 * them.
 */
#ifndef BoneDecimate_Testing_SlabRuns_h
#define BoneDecimate_Testing_SlabRuns_h

#include "NoisyBones.h"
#include "Partition/Slabs/SlabRun.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace bonedecimate::testsupport
{
using Function = std::function<double(const Vector3& p)>;

/// Where the function is 0: the surface of the voxels at which it is positive, its points moved
/// along their grid edges.
inline Surface SurfaceOfFunction(
  const std::array<Index, 3>& size, const Function& function, bool isClosed = true)
{
  const LabelMap map = MakeLabelMap(size,
    [&](const std::array<Index, 3>& v) {
      return function({ 1.0 * v[0], 1.0 * v[1], 1.0 * v[2] }) > 0.0 ? 1 : 0;
    });
  LabelSurfaces extracted = Extracted(map, isClosed);
  for (std::size_t i = 0; i < extracted.Surface.Points.size(); ++i)
  {
    Vector3 a, b;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      const int twice = extracted.Source.OfPoint[i][static_cast<std::size_t>(axis)];
      a[axis] = std::floor(0.5 * twice);
      b[axis] = std::ceil(0.5 * twice);
    }
    const double from = function(a);
    const double t = from / (from - function(b));
    extracted.Surface.Points[i] = a + std::clamp(t, 0.05, 0.95) * (b - a);
  }
  return extracted.Surface;
}

/// The triangles between planes at these layers of voxels, where no triangle passes.
inline std::vector<Slab> CutAtLayers(const Surface& surface,
  const std::vector<BoundaryLabels>& labels, const std::vector<double>& tops, std::size_t axis = 2)
{
  std::vector<Slab> slabs(tops.size());
  std::vector<std::vector<Index>> points(
    tops.size(), std::vector<Index>(surface.Points.size(), None));
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& c = surface.Triangles[t];
    const Vector3 middle =
      (surface.Points[c[0]] + surface.Points[c[1]] + surface.Points[c[2]]) / 3.0;
    const auto at = static_cast<std::size_t>(
      std::lower_bound(tops.begin(), tops.end(), middle[static_cast<Eigen::Index>(axis)]) -
      tops.begin());
    Triangle corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      Index& point = points[at][static_cast<std::size_t>(c[i])];
      if (point == None)
      {
        point = static_cast<Index>(slabs[at].Surface.Points.size());
        slabs[at].Surface.Points.push_back(surface.Points[c[i]]);
      }
      corners[i] = point;
    }
    slabs[at].Surface.Triangles.push_back(corners);
    if (!labels.empty())
    {
      slabs[at].BoundaryLabels.push_back(labels[t]);
    }
  }
  for (std::size_t i = 0; i < tops.size(); ++i)
  {
    slabs[i].Top = tops[i];
  }
  return slabs;
}

struct SlabOutcome
{
  SlabStatus Status;
  bonedecimate::Result Result;
  SlabFigures Figures;
};

inline SlabOutcome RunInSlabs(const std::vector<Slab>& slabs, const Options& options,
  const SlabInputs& inputs = {}, double bottom = -2.0)
{
  SlabAxis axis;
  axis.Bottom = bottom;
  SlabRun run(options, axis, inputs);
  for (const Slab& slab : slabs)
  {
    run.Add(slab);
  }
  SlabOutcome outcome;
  outcome.Result = run.Finish();
  outcome.Status = run.Status();
  outcome.Figures = run.Figures();
  return outcome;
}
}

#endif
