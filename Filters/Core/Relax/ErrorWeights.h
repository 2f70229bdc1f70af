// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorWeights.h
 * @brief How distances in both directions add up to one error.
 *
 *     error = sum over samples   area f(d(sample, its face))
 *           + weight back * sum over vertices   area of ring / 3  f(d(vertex, original))      squares of the unit
 *     f(d) = (d / unit)^(3/2)          between the average (1) and the root mean square (2)
 *
 * A fit of f is a fit of squares with weights w(d) = f'(d) / (2 d) that follow d (P. Holland and R. Welsch, Robust
 * regression using iteratively reweighted least-squares, 1977).
 */
#ifndef BoneDecimate_Core_Relax_ErrorWeights_h
#define BoneDecimate_Core_Relax_ErrorWeights_h

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
/// Weight of the way from the current surface to the original: 0 lets spikes grow, 1 is too stiff.
constexpr double BackWeight = 0.03;
/// Stronger in collapses, which cannot be taken back.
constexpr double BackWeightOfCollapse = 0.1;
/// Of a face's area, how much each of its corners stands for.
constexpr double CornerShare = 1.0 / 3.0;

/// The unit is a power of two, so that scaling by powers of two changes no bit.
class ThreeHalves
{
public:
  struct Answer
  {
    double Value;  // f, no unit
    double Weight; // of the square in a fit, 1/mm^2
  };

  explicit ThreeHalves(double unit)
    : PerSquare(1.0 / (unit * unit))
  {
  }

  /// An area in squares of the unit. @param area mm^2
  double InUnits(double area) const { return area * this->PerSquare; }

  /// @param squared The squared distance, mm^2.
  double Of(double squared) const
  {
    const double root = std::sqrt(squared * this->PerSquare);
    return root * std::sqrt(root);
  }
  /// The weight is bounded, for places that lie on the surface already.
  Answer WithWeight(double squared) const
  {
    constexpr double least = 1e-3; // units
    const double root = std::sqrt(squared * this->PerSquare);
    const double fourth = std::sqrt(std::max(least, root));
    return { root * std::sqrt(root), 0.75 * this->PerSquare / fourth };
  }

private:
  double PerSquare; // 1/mm^2
};
}

#endif
