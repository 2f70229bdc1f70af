// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the worker of the package calls: each function takes and returns plain objects and typed
// arrays. Problems are the text `problem` of what is returned; nothing is thrown.
#include "BindOptions.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Decimate.h"
#include "Run/Output/ComparedSurface.h"
#include "Run/Report/CertificateTable.h"
#include "Run/Report/PairWarnings.h"
#include "Run/Report/ReportJson.h"
#include "Run/Report/ReportTable.h"
#include "Run/RunWarnings.h"
#include "Values.h"

#include <emscripten/bind.h>

#include <array>
#include <cmath>
#include <optional>

namespace bonedecimate
{
namespace
{
constexpr double MeanPrecision = 5e-3; // as the command certify has it

val Failed(const std::string& problem)
{
  val failed = val::object();
  failed.set("problem", problem);
  return failed;
}

VoxelGrid GridOf(const val& from)
{
  const std::vector<double> origin = ToNumbers<double>(from["origin"]);
  const std::vector<double> spacing = ToNumbers<double>(from["spacing"]);
  const std::vector<double> direction = ToNumbers<double>(from["direction"]);
  const std::vector<Index> dimensions = ToNumbers<Index>(from["dimensions"]);
  VoxelGrid grid;
  grid.Origin = Vector3(origin.data());
  grid.Spacing = Vector3(spacing.data());
  grid.Direction = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(direction.data());
  grid.Dimensions = { dimensions[0], dimensions[1], dimensions[2] };
  return grid;
}

val FromGrid(const VoxelGrid& grid)
{
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = grid.Direction;
  val to = val::object();
  to.set("origin", ToArray<double>(std::vector<Vector3>{ grid.Origin }));
  to.set("spacing", ToArray<double>(std::vector<Vector3>{ grid.Spacing }));
  to.set("direction", ToArray<double>(std::vector<double>(rows.data(), rows.data() + 9)));
  to.set("dimensions", ToArray<Index>(std::vector<std::array<Index, 3>>{ grid.Dimensions }));
  return to;
}

/// What a surface of a label map knows of it.
std::optional<LabelMapSource> SourceOf(const val& surface)
{
  if (surface["grid"].isUndefined())
  {
    return {};
  }
  LabelMapSource source;
  source.Grid = GridOf(surface["grid"]);
  for (const double value : ToNumbers<double>(surface["labelValues"]))
  {
    source.Values.push_back(static_cast<std::int64_t>(value));
  }
  const std::vector<Index> pairs = ToNumbers<Index>(surface["boundaryLabels"]);
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
  {
    source.OfTriangle.push_back({ pairs[i], pairs[i + 1] });
  }
  source.OfPoint = ToRows<std::int32_t, GridPoint>(surface["gridPoints"]);
  return source;
}

val FromLabels(const std::vector<std::int64_t>& values)
{
  return ToArray<double>(std::vector<double>(values.begin(), values.end()));
}

/// Points in single precision if the run rounded them to it.
val PointsOf(const Surface& surface, bool isSingle)
{
  if (!isSingle)
  {
    return ToArray<double>(surface.Points);
  }
  std::vector<float> numbers;
  numbers.reserve(3 * surface.Points.size());
  for (const Vector3& p : surface.Points)
  {
    numbers.insert(numbers.end(),
      { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) });
  }
  return ToArray<float>(numbers);
}

val FromResult(const Result& result, bool isSingle)
{
  const std::string problem = InputMessage(result.Report);
  if (!problem.empty())
  {
    return Failed(problem);
  }
  val to = val::object();
  to.set("points", PointsOf(result.Surface, isSingle));
  to.set("triangles", ToArray<Index>(result.Surface.Triangles));
  to.set("distance", ToArray<double>(result.Distance));
  to.set("errorBound", ToArray<double>(result.ErrorBound));
  to.set("inputDistance", ToArray<double>(result.InputDistance));
  to.set("inputErrorBound", ToArray<double>(result.InputErrorBound));
  to.set("pointCount", ToArray<Index>(result.PointCount));
  to.set("nearestTriangle", ToArray<Index>(result.Origins.NearestTriangle));
  to.set("outputPoint", ToArray<Index>(result.Origins.OutputPoint));
  to.set("report", ReportJson(ReportEntries(result.Report)));
  to.set("stop", std::string(StopReasonSentence(result.Report.Stop)));
  to.set("contradiction", ProofMessage(result.Report));
  return to;
}

val RunDecimate(const val& surface, const val& given, const val& progress)
{
  Options options;
  const std::string problem = ReadOptions(given, options);
  if (!problem.empty())
  {
    return Failed(problem);
  }
  const std::optional<LabelMapSource> source = SourceOf(surface);
  const std::vector<double> tolerances = ToNumbers<double>(surface["tolerances"]);
  const std::vector<double> edgeLengths = ToNumbers<double>(surface["edgeLengths"]);
  RunInputs inputs;
  inputs.InputIsSingle = surface["isSingle"].as<bool>();
  inputs.WantsOrigins = options.MakeMaps;
  inputs.Tolerances = surface["tolerances"].isUndefined() ? nullptr : &tolerances;
  inputs.EdgeLengths = surface["edgeLengths"].isUndefined() ? nullptr : &edgeLengths;
  inputs.LabelMap = source ? &*source : nullptr;
  const Surface input = ToSurface(surface);
  const Result result = Decimate(input, options, MonitorOf(progress), inputs);
  val to = FromResult(result, options.WritesSingle(inputs.InputIsSingle));
  to.set("warnings", ToTexts(RunWarnings(input, result.Report, options.NumberOfThreads)));
  if (source && !result.BoundaryLabels.empty())
  {
    to.set("boundaryLabels", ToArray<Index>(result.BoundaryLabels));
    to.set("labelValues", FromLabels(source->Values));
  }
  return to;
}

template <typename Label>
LabelSurfaces ExtractFrom(
  const val& map, const LabelSurfaceOptions& options, const Monitor& monitor)
{
  const std::vector<Label> labels = ToNumbers<Label>(map["labels"]);
  return ExtractLabelSurfaces(MakeLabelImage(labels.data(), GridOf(map["grid"])), options, monitor);
}

/// @param map labels, a typed array of integers, x fastest, and the grid.
val RunExtract(const val& map, const val& given, const val& progress)
{
  LabelSurfaceOptions options;
  for (const double label : ToNumbers<double>(given["labels"]))
  {
    options.Labels.push_back(static_cast<std::int64_t>(label));
  }
  options.Background = static_cast<std::int64_t>(given["background"].as<double>());
  options.Closed = given["closed"].as<bool>();
  options.Threads = 1;
  const std::string type = map["labels"]["constructor"]["name"].as<std::string>();
  const auto extract = type == "Uint8Array" ? ExtractFrom<std::uint8_t>
    : type == "Int8Array"                   ? ExtractFrom<std::int8_t>
    : type == "Uint16Array"                 ? ExtractFrom<std::uint16_t>
    : type == "Int16Array"                  ? ExtractFrom<std::int16_t>
    : type == "Uint32Array"                 ? ExtractFrom<std::uint32_t>
                                            : ExtractFrom<std::int32_t>;
  const LabelSurfaces surfaces = extract(map, options, MonitorOf(progress));
  if (surfaces.Status != LabelSurfaceStatus::Good)
  {
    return Failed(LabelSurfaceMessage(surfaces.Status));
  }
  val to = val::object();
  to.set("points", ToArray<double>(surfaces.Surface.Points));
  to.set("triangles", ToArray<Index>(surfaces.Surface.Triangles));
  to.set("boundaryLabels", ToArray<Index>(surfaces.Source.OfTriangle));
  to.set("gridPoints", ToArray<std::int32_t>(surfaces.Source.OfPoint));
  to.set("labelValues", FromLabels(surfaces.Source.Values));
  to.set("grid", FromGrid(surfaces.Source.Grid));
  return to;
}

val RunCertify(const val& reference, const val& result, const val& given, const val& progress)
{
  CertificateOptions options;
  options.NumberOfThreads = 1;
  options.RelativeGap = given["relativeGap"].as<double>();
  options.WithPointDistances = given["pointDistances"].as<bool>();
  options.WithMeans = given["means"].as<bool>();
  options.MeanPrecision = MeanPrecision;
  if (!given["tolerance"].isUndefined())
  {
    options.Tolerance = given["tolerance"].as<double>();
  }
  const Surface one = ToSurface(reference);
  const Surface two = ToSurface(result);
  PairFigures figures;
  const std::vector<LeftOutShape> nothing;
  const Certificate found = CertifyPair({ one, nothing }, { two, nothing }, options,
    given["surfaces"].as<bool>(), MonitorOf(progress), figures);
  if (found.Status != CertificateStatus::Good)
  {
    return Failed(StatusSentence(found.Status));
  }
  val to = val::object();
  to.set("lower", found.Lower());
  to.set("upper", found.Upper());
  to.set("report", ReportJson(CertificateEntries(found, figures)));
  to.set("warnings", ToTexts(PairWarnings(one, two, options.Tolerance.value_or(0.0), figures)));
  to.set("referenceDistance", ToArray<double>(found.ReferenceToResult.Points.Distance));
  to.set("resultDistance", ToArray<double>(found.ResultToReference.Points.Distance));
  return to;
}
}

//------------------------------------------------------------------------------
val ToTexts(const std::vector<std::string>& texts)
{
  val array = val::array();
  for (const std::string& text : texts)
  {
    array.call<void>("push", text);
  }
  return array;
}

//------------------------------------------------------------------------------
Monitor MonitorOf(const val& progress)
{
  return [progress](double fraction)
  {
    progress(fraction);
    return true;
  };
}
}

EMSCRIPTEN_BINDINGS(bonedecimate)
{
  using namespace bonedecimate;
  emscripten::function("options", &OptionRows);
  emscripten::function("decimate", &RunDecimate);
  emscripten::function("extract", &RunExtract);
  emscripten::function("certify", &RunCertify);
  emscripten::function(
    "version", emscripten::optional_override([] { return std::string(Version()); }));
}
