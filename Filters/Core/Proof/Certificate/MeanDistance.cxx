// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeanDistance.h"

#include "Base/Parallel.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
constexpr std::size_t MinSamples = std::size_t{ 1 } << 16;
constexpr std::size_t MaxSamples = std::size_t{ 1 } << 21;
// 1/g and 1/g^2 of the plastic number: the R2 sequence (M. Roberts, 2018).
constexpr double FirstStep = 0.7548776662466927;
constexpr double SecondStep = 0.5698402909980532;

/// First and second moments of distances, mm and mm^2.
struct Moments
{
  double First = 0.0;
  double Second = 0.0;

  Moments& operator+=(const Moments& other)
  {
    this->First += other.First;
    this->Second += other.Second;
    return *this;
  }
  Moments operator-(const Moments& other) const
  {
    return { this->First - other.First, this->Second - other.Second };
  }
  Moments Squared() const { return { this->First * this->First, this->Second * this->Second }; }
};

struct Sums
{
  Moments Rest;
  Moments SquaredDifferences;

  Sums& operator+=(const Sums& other)
  {
    this->Rest += other.Rest;
    this->SquaredDifferences += other.SquaredDifferences;
    return *this;
  }
};

/// The number of samples that probably reaches the precision; 0 if it is reached or the count is at
/// its maximum.
std::size_t NextCount(
  std::size_t count, const MeanDistance& mean, double precision, double rounding)
{
  const auto isReached = [&](double factor)
  {
    return mean.MeanError <= std::max(factor * precision * mean.Mean, rounding) &&
      mean.RootMeanSquareError <= std::max(factor * precision * mean.RootMeanSquare, rounding);
  };
  if (isReached(1.0) || count >= MaxSamples)
  {
    return 0;
  }
  count *= 2;
  for (double factor = 1.2; count < MaxSamples && !isReached(factor); factor *= 1.4)
  {
    count *= 2; // errors are proportional to 1 / sqrt(count)
  }
  return count;
}

class MeanSearch
{
public:
  MeanSearch(const Simplices& source, const Target& target, const PointValues& values, int threads)
    : Source(source)
    , TargetSet(target)
    , Values(values)
    , Threads(threads)
  {
    this->Integrate();
  }

  MeanDistance Run(double precision, double rounding, const Monitor& monitor)
  {
    MeanDistance mean;
    mean.Area = this->Areas.back();
    std::size_t count = mean.Area > 0.0 ? MinSamples : 0;
    for (double from = 0.0; count > 0; from += 0.5 * (1.0 - from))
    {
      if (!this->Sample(count, PartOf(monitor, from, from + 0.5 * (1.0 - from)), mean))
      {
        return {};
      }
      count = NextCount(count, mean, precision, rounding);
    }
    return mean;
  }

private:
  /// Integrates the linear part of each triangle.
  void Integrate()
  {
    double area = 0.0;
    for (const auto& [a, b, c] : this->Source.Corners)
    {
      const std::vector<Vector3>& p = this->Source.Points;
      const double part = AreaVector(p[a], p[b], p[c]).norm();
      const Moments linear = this->Linear({ a, b, c }, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 });
      this->LinearPart += { part * linear.First, part * linear.Second };
      area += part;
      this->Areas.push_back(area);
    }
  }

  Moments Linear(const Triangle& corners, const std::array<double, 3>& weights) const
  {
    Moments linear;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double value = this->Values.Value[corners[i]];
      linear += { weights[i] * value, weights[i] * value * value };
    }
    return linear;
  }

  static double Fraction(double value) { return value - std::floor(value); }

  static std::array<double, 3> WeightsOf(double number)
  {
    double u = Fraction(0.5 + number * FirstStep);
    double v = Fraction(0.5 + number * SecondStep);
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    return { 1.0 - u - v, u, v };
  }

  /// The distance at a sample minus the linear part.
  Moments RestAt(std::size_t triangle, double number, Index& hint) const
  {
    const Triangle& corners = this->Source.Corners[triangle];
    const std::vector<Vector3>& p = this->Source.Points;
    const std::array<double, 3> weights = WeightsOf(number);
    const Target::Candidate found = this->TargetSet.FindLeast(
      weights[0] * p[corners[0]] + weights[1] * p[corners[1]] + weights[2] * p[corners[2]], hint);
    hint = found.Simplex;
    return Moments{ found.Value, found.Value * found.Value } - this->Linear(corners, weights);
  }

  Sums SampleChunk(std::size_t first, std::size_t last, std::size_t count) const
  {
    const auto areaOf = [&](std::size_t i)
    { return (static_cast<double>(i) + 0.5) / static_cast<double>(count) * this->Areas.back(); };
    auto at = std::lower_bound(this->Areas.begin(), this->Areas.end(), areaOf(first));
    Sums sums;
    Moments before;
    Index hint = None;
    for (std::size_t i = first; i < last; ++i)
    {
      at =
        std::find_if(at, this->Areas.end() - 1, [&](double passed) { return passed >= areaOf(i); });
      const Moments rest = this->RestAt(
        static_cast<std::size_t>(at - this->Areas.begin()), static_cast<double>(i), hint);
      sums.Rest += rest;
      if ((i - first) % 2 == 1)
      {
        sums.SquaredDifferences += (rest - before).Squared();
      }
      before = rest;
    }
    return sums;
  }

  bool Sample(std::size_t count, const Monitor& monitor, MeanDistance& mean) const
  {
    std::vector<Sums> parts(NumberOfChunks(count));
    const bool done = ForEachChunk(count, this->Threads, monitor,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      { parts[chunk] = this->SampleChunk(first, last, count); });
    Sums sums;
    for (const Sums& part : parts)
    {
      sums += part;
    }
    const auto samples = static_cast<double>(count);
    mean.Samples = static_cast<std::int64_t>(count);
    mean.Mean = std::max(0.0, this->LinearPart.First / mean.Area + sums.Rest.First / samples);
    mean.RootMeanSquare =
      std::sqrt(std::max(0.0, this->LinearPart.Second / mean.Area + sums.Rest.Second / samples));
    mean.MeanError = 2.0 * std::sqrt(sums.SquaredDifferences.First) / samples;
    const double squareError = 2.0 * std::sqrt(sums.SquaredDifferences.Second) / samples;
    mean.RootMeanSquareError =
      mean.RootMeanSquare > 0.0 ? 0.5 * squareError / mean.RootMeanSquare : 0.0;
    return done;
  }

  const Simplices& Source;
  const Target& TargetSet;
  const PointValues& Values;
  int Threads;
  std::vector<double> Areas; // mm^2, up to and including each triangle
  Moments LinearPart;        // times mm^2
};
}

MeanDistance FindMeanDistance(const Simplices& source, const Target& target,
  const PointValues& values, double precision, double rounding, int threads, const Monitor& monitor)
{
  return MeanSearch(source, target, values, threads).Run(precision, rounding, monitor);
}
}
