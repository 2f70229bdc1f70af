// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AreaSamples.h
 * @brief Points spread evenly over the area of triangles, the same in every run.
 *
 * Sample i of n lies in the triangle at which the cumulative area reaches (i + 1/2) / n of the
 * whole, at the i-th position of the R2 sequence.
 *
 * M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018: R2.
 */
#ifndef BoneDecimate_Core_Proof_Measure_AreaSamples_h
#define BoneDecimate_Core_Proof_Measure_AreaSamples_h

#include "Geometry/Surface.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bonedecimate
{
class AreaSamples
{
public:
  /// Keeps references.
  /// @param count Number of samples; there are none if the triangles have no area.
  AreaSamples(
    const std::vector<Vector3>& points, const std::vector<Triangle>& triangles, std::size_t count);
  AreaSamples(std::vector<Vector3>&&, const std::vector<Triangle>&, std::size_t) = delete;
  AreaSamples(const std::vector<Vector3>&, std::vector<Triangle>&&, std::size_t) = delete;

  std::size_t Count() const { return this->Number; }
  /// mm^2
  double Area() const { return this->Areas.empty() ? 0.0 : this->Areas.back(); }

  /// Calls visit(sample, triangle, position) for the samples first to last - 1. Consecutive samples
  /// are near each other.
  template <typename VisitSample>
  void Visit(std::size_t first, std::size_t last, const VisitSample& visit) const
  {
    auto at = std::lower_bound(this->Areas.begin(), this->Areas.end(), this->AreaBefore(first));
    for (std::size_t i = first; i < last; ++i)
    {
      at = std::find_if(
        at, this->Areas.end() - 1, [&](double passed) { return passed >= this->AreaBefore(i); });
      const auto triangle = static_cast<std::size_t>(at - this->Areas.begin());
      visit(i, triangle, this->PositionIn(this->Triangles[triangle], static_cast<double>(i)));
    }
  }

private:
  /// mm^2
  double AreaBefore(std::size_t sample) const
  {
    return (static_cast<double>(sample) + 0.5) / static_cast<double>(this->Number) * this->Area();
  }
  Vector3 PositionIn(const Triangle& corners, double number) const;

  const std::vector<Vector3>& Points;
  const std::vector<Triangle>& Triangles;
  std::vector<double> Areas; // up to and including each triangle, mm^2
  std::size_t Number;
};
}

#endif
