// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChecksumRuns.h"

#include "Levels/LogBytes.h"
#include "Run/Decimate.h"

#include <algorithm>

namespace bonedecimate::testsupport
{
namespace
{
/// FNV-1a, 64 bits.
class Fnv
{
public:
  template <typename T>
  void Add(const T& value)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    for (std::size_t i = 0; i < sizeof(T); ++i)
    {
      this->Value = (this->Value ^ bytes[i]) * 0x100000001b3ULL;
    }
  }

  template <typename T>
  void AddAll(const std::vector<T>& values)
  {
    this->AddSize(values.size());
    for (const T& value : values)
    {
      this->Add(value);
    }
  }

  /// Every number that is none counts as the same.
  void AddAll(const std::vector<double>& values)
  {
    this->AddSize(values.size());
    for (const double value : values)
    {
      this->Add(value == value ? value : -1.0);
    }
  }

  void AddAll(const std::vector<Vector3>& points)
  {
    this->AddSize(points.size());
    for (const Vector3& p : points)
    {
      this->Add(p[0]);
      this->Add(p[1]);
      this->Add(p[2]);
    }
  }

  /// Adds the same bytes on systems whose sizes have 32 bits.
  void AddSize(std::size_t size) { this->Add(static_cast<std::uint64_t>(size)); }

  std::uint64_t Sum() const { return this->Value; }

private:
  std::uint64_t Value = 0xcbf29ce484222325ULL;
};

struct Box
{
  Vector3 Low = Vector3::Constant(1e300);
  Vector3 High = Vector3::Constant(-1e300);

  explicit Box(const Surface& surface)
  {
    for (const Vector3& p : surface.Points)
    {
      this->Low = this->Low.cwiseMin(p);
      this->High = this->High.cwiseMax(p);
    }
  }
  double Diagonal() const { return (this->High - this->Low).norm(); }
  /// From 0 to 1 along x.
  double Along(const Vector3& p) const
  {
    return (p[0] - this->Low[0]) / std::max(1e-9, this->High[0] - this->Low[0]);
  }
};

Options Quick()
{
  Options options;
  options.MeasureDistances = false;
  options.NumberOfThreads = 2;
  return options;
}

Options Reduced(double fraction)
{
  Options options = Quick();
  options.TargetReduction = fraction;
  options.TargetReductionIsExplicit = true;
  return options;
}

Options Bounded(double error)
{
  Options options = Quick();
  options.MaximumError = error;
  return options;
}

template <typename Change>
Options With(Options options, const Change& change)
{
  change(options);
  return options;
}

std::vector<double> TolerancesAlongX(const Surface& surface, double error)
{
  const Box box(surface);
  std::vector<double> tolerances;
  for (const Vector3& p : surface.Points)
  {
    const double along = box.Along(p);
    tolerances.push_back(along < 0.2 ? 0.0 : along > 0.8 ? -1.0 : along * error);
  }
  return tolerances;
}

Labels HalvesAlongX(const Surface& surface)
{
  const Box box(surface);
  Labels labels;
  labels.Names = { "1", "2" };
  for (const Triangle& t : surface.Triangles)
  {
    labels.OfTriangle.push_back(box.Along(surface.Points[t[0]]) < 0.5 ? 0 : 1);
  }
  return labels;
}

void AddResult(Fnv& sum, const Result& result)
{
  sum.AddAll(result.Surface.Points);
  sum.AddAll(result.Surface.Triangles);
  sum.AddAll(result.Origins.NearestTriangle);
  sum.AddAll(result.Origins.Barycentric);
  sum.AddAll(result.Origins.NearestPoint);
  sum.AddAll(result.Origins.TriangleAtCentroid);
  sum.AddAll(result.Origins.OutputPoint);
  sum.AddAll(result.Distance);
  sum.AddAll(result.RunningError);
  sum.AddAll(result.PointCount);
  sum.AddAll(result.InputDistance);
  sum.AddAll(result.ErrorBound);
  sum.AddAll(result.InputErrorBound);
}

void AddReport(Fnv& sum, const Report& report)
{
  sum.Add(report.Status);
  sum.Add(report.Stop);
  sum.Add(report.Input.Faces);
  sum.Add(report.Output.Faces);
  sum.Add(report.Output.Area);
  sum.Add(report.Output.Volume);
  sum.Add(report.OutputToInput.Maximum);
  sum.Add(report.InputToOutput.Mean);
  sum.Add(report.Proof.Lower());
  sum.Add(report.Proof.Upper());
  sum.Add(report.Edits.Collapses);
  for (const LabelArea& area : report.Labels)
  {
    sum.Add(area.Output);
  }
}
}

std::vector<NamedSurface> ShapesOfChecksums()
{
  std::vector<NamedSurface> shapes = AllShapes();
  shapes.push_back({ "FarTorus", Moved(Scaled(Torus(60, 40), 4.0), { 3000.0, -700.0, 90.0 }) });
  return shapes;
}

NamedSurface LargeShapeOfChecksums()
{
  return { "LargeBumpySphere", BumpySphere(6, 30.0, 0.3, 21) };
}

std::vector<ChecksumCase> CasesOfShapes(const Surface& surface)
{
  using Inputs = ChecksumInputs;
  const double error = 0.01 * Box(surface).Diagonal();
  const Options bounded = Bounded(error);
  return {
    { "reduction-0.5", Reduced(0.5) },
    { "reduction-0.9", With(Reduced(0.9), [](Options& o) { o.MeasureDistances = true; }) },
    { "triangles-40", With(Quick(), [](Options& o) { o.TargetNumberOfTriangles = 40; }) },
    { "maps", Reduced(0.7), Inputs::Origins },
    { "points-unmerged", With(Reduced(0.7), [](Options& o) { o.MergePoints = false; }) },
    { "single-precision",
      With(Reduced(0.7), [](Options& o) { o.OutputPointsPrecision = PointsPrecision::Single; }) },
    { "error", bounded },
    { "error-small", Bounded(0.1 * error) },
    { "error-unguarded", With(bounded, [](Options& o) { o.IntersectionGuard = false; }) },
    { "error-triangles", With(bounded, [](Options& o) { o.TargetNumberOfTriangles = 100; }) },
    { "error-single",
      With(bounded, [](Options& o) { o.OutputPointsPrecision = PointsPrecision::Single; }) },
    { "error-measured", With(bounded, [](Options& o) { o.MeasureInputDistances = true; }) },
    { "error-preset",
      With(Quick(),
        [&](Options& o)
        {
          o.ErrorPreset = ErrorPreset::HalfVoxel;
          o.VoxelSize = 2.0 * error;
        }) },
    { "normal-tolerance", With(Reduced(0.7), [](Options& o) { o.NormalTolerance = 0.3; }) },
    { "pruned", With(Reduced(0.7), [](Options& o) { o.PruneTriangles = 30; }) },
    { "tolerances", bounded, Inputs::Tolerances },
    { "tolerances-alone", Quick(), Inputs::Tolerances },
    { "labels", Reduced(0.7), Inputs::Labels },
    { "labels-error", bounded, Inputs::Labels },
    { "log", Reduced(0.9), Inputs::Log },
    { "log-error", bounded, Inputs::Log },
    { "reference", bounded, Inputs::Reference },
    { "least-angle", With(bounded, [](Options& o) { o.MinimumAngle = 25.0; }) },
    { "edge-length", With(bounded, [&](Options& o) { o.EdgeLength = 8.0 * error; }) },
  };
}

std::vector<ChecksumCase> CasesOfLarge(const Surface& surface)
{
  const double error = 0.005 * Box(surface).Diagonal();
  return {
    { "reduction-0.9", With(Reduced(0.9), [](Options& o) { o.MeasureDistances = true; }) },
    { "error", Bounded(error) },
    { "error-labels", Bounded(error), ChecksumInputs::Labels },
  };
}

std::uint64_t ChecksumOfRun(const Surface& surface, const ChecksumCase& one, Mode mode)
{
  Options options = one.Options;
  options.Mode = mode;
  const std::vector<double> tolerances = TolerancesAlongX(surface, 0.01 * Box(surface).Diagonal());
  const Labels labels = HalvesAlongX(surface);
  EditLog log;
  RunInputs inputs;
  inputs.WantsOrigins = one.Inputs == ChecksumInputs::Origins;
  inputs.Tolerances = one.Inputs == ChecksumInputs::Tolerances ? &tolerances : nullptr;
  inputs.Labels = one.Inputs == ChecksumInputs::Labels ? &labels : nullptr;
  inputs.Log = one.Inputs == ChecksumInputs::Log ? &log : nullptr;
  Surface input = surface;
  if (one.Inputs == ChecksumInputs::Reference)
  {
    Options first = options;
    first.MaximumError *= 0.5;
    input = Decimate(surface, first).Surface;
    inputs.Reference = &surface;
  }
  const Result result = Decimate(input, options, {}, inputs);
  Fnv sum;
  AddResult(sum, result);
  AddReport(sum, result.Report);
  sum.AddAll(WriteLog(log));
  return sum.Sum();
}
}
