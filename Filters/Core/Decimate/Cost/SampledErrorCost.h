// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledErrorCost.h
 * @brief The cost of the last collapses of Balanced and Accurate, and the error that their flips
 * and moves reduce: sampled distances in both directions, added up.
 *
 *     cost(collapse) = error of the triangles it changes, after it - before it
 *
 *     error = sum over samples    area f(d(sample, its face)) + far(d, 8)
 *           + sum over vertices   back weight * area of ring / 3 * f(d(vertex, original))
 *                                 + far(d, 5)
 *           + sum over faces      shape weight * mean area of a face * f(root mean square of the
 *                                 sampled distances) / (q + 0.02)^2               (ShapePenalty.h)
 *           + sum over two points on each sharply folded edge    far(d(point, original), 8)
 *
 *     f(d) = (d / unit)^(3/2)     between the average (1) and the root mean square (2)
 *     far(d, k) = mean area of a face * f(T) * ((d / T)^2 - 1)^2 beyond T, else 0
 *                 T = k * root mean square of the sampled distances
 *
 * Areas and errors are in squares of the unit of the mesh. f measures typical distances. far
 * measures outliers and is not weighted by area. The tip of a spur has no area. Neither has a chord
 * across a notch in the rim of a thin plate, whose samples all lie on the plate. The fourth power
 * outweighs the other terms only for outliers, so average and root mean square hardly change.
 *
 * Fits minimize squares with weights w(d) = f'(d) / (2 d), which follow d (P. Holland and R.
 * Welsch, Robust regression using iteratively reweighted least-squares, 1977).
 */
#ifndef BoneDecimate_Core_Decimate_Cost_SampledErrorCost_h
#define BoneDecimate_Core_Decimate_Cost_SampledErrorCost_h

#include "Proof/Reference/Samples.h"
#include "ShapePenalty.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
/// Weight of the distance from the current surface to the original: 0 lets spikes grow, and 1 is
/// too stiff.
constexpr double BackWeight = 0.03;
/// The weight in collapses is larger, because later steps cannot undo them.
constexpr double BackWeightOfCollapse = 0.1;
/// The fraction of a face's area that each of its corners represents.
constexpr double CornerFraction = 1.0 / 3.0;

/// A part of the error, and its weight in a fit of squares.
struct Penalty
{
  double Value = 0.0;  // squares of the unit
  double Weight = 0.0; // of the square, squares of the unit / mm^2
};

/// The function f of the header. The unit is a power of two, so scaling by powers of two changes no
/// bit.
class ThreeHalves
{
public:
  explicit ThreeHalves(double unit)
    : PerSquare(1.0 / (unit * unit))
  {
  }

  /// Converts mm^2 to squares of the unit.
  double InUnits(double area) const { return area * this->PerSquare; }

  /// @param squared The squared distance, mm^2.
  double Of(double squared) const
  {
    const double root = std::sqrt(squared * this->PerSquare);
    return root * std::sqrt(root);
  }
  /// The weight is bounded, because points may lie on the surface.
  /// @param area Squares of the unit.
  Penalty WithWeight(double area, double squared) const
  {
    constexpr double least = 1e-3; // units
    const double root = std::sqrt(squared * this->PerSquare);
    const double fourth = std::sqrt(std::max(least, root));
    return { area * root * std::sqrt(root), area * 0.75 * this->PerSquare / fourth };
  }

private:
  double PerSquare; // 1/mm^2
};

/// The function far of the header.
class FarPenalty
{
public:
  /// @param limit T, mm.  @param weight Squares of the unit.
  FarPenalty(double limit, double weight)
    : LimitSquared(limit > 0.0 ? limit * limit : Infinity)
    , PerLimitSquared(1.0 / this->LimitSquared)
    , Factor(weight)
  {
  }

  double SquaredLimit() const { return this->LimitSquared; } ///< mm^2
  bool IsFar(double squared) const { return squared > this->LimitSquared; }
  double Of(double squared) const
  {
    const double beyond = squared * this->PerLimitSquared - 1.0;
    return this->IsFar(squared) ? this->Factor * beyond * beyond : 0.0;
  }
  Penalty WithWeight(double squared) const
  {
    const double beyond = std::max(0.0, squared * this->PerLimitSquared - 1.0);
    return { this->Of(squared), 2.0 * this->Factor * beyond * this->PerLimitSquared };
  }

private:
  double LimitSquared;    // mm^2
  double PerLimitSquared; // 1/mm^2
  double Factor;          // squares of the unit
};

/// The terms of the error. Areas are in squares of the unit, squared distances in mm^2.
class ErrorPenalty
{
public:
  /// @param unit The unit of the mesh, mm.
  ErrorPenalty(double unit, const Samples::Averages& usual)
    : Near(unit)
    , Far(Beyond(FarOfSamples, unit, usual))
    , FarVertex(Beyond(FarOfVertices, unit, usual))
    , Shape(
        usual.ShapeWeight * usual.FaceArea * ThreeHalves(unit).Of(usual.Distance * usual.Distance))
  {
  }

  double InUnits(double area) const { return this->Near.InUnits(area); } ///< @param area mm^2
  double OfSample(double area, double squared) const
  {
    const double near = area * this->Near.Of(squared);
    return this->Far.IsFar(squared) ? near + this->Far.Of(squared) : near;
  }
  double OfVertex(double area, double squared) const
  {
    return area * this->Near.Of(squared) + this->FarVertex.Of(squared);
  }
  Penalty FitOfSample(double area, double squared) const
  {
    return Sum(this->Near.WithWeight(area, squared), this->Far, squared);
  }
  Penalty FitOfVertex(double area, double squared) const
  {
    return Sum(this->Near.WithWeight(area, squared), this->FarVertex, squared);
  }
  const ShapePenalty& OfShapes() const { return this->Shape; }
  const FarPenalty& OfChords() const { return this->Far; }
  const FarPenalty& OfFarVertices() const { return this->FarVertex; }

private:
  /// The factors k of far. Vertices lie near the surface more often than samples.
  static constexpr double FarOfSamples = 8.0;
  static constexpr double FarOfVertices = 5.0;

  static FarPenalty Beyond(double times, double unit, const Samples::Averages& usual)
  {
    const double limit = times * usual.Distance;
    return { limit, usual.FaceArea * ThreeHalves(unit).Of(limit * limit) };
  }
  static Penalty Sum(const Penalty& near, const FarPenalty& far, double squared)
  {
    if (!far.IsFar(squared))
    {
      return near;
    }
    const Penalty more = far.WithWeight(squared);
    return { near.Value + more.Value, near.Weight + more.Weight };
  }

  ThreeHalves Near;
  FarPenalty Far;
  FarPenalty FarVertex;
  ShapePenalty Shape;
};
}

#endif
