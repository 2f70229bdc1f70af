// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzCore.cxx
 * @brief Fuzzes the core with any soup of triangles and any options: the result must be a surface within the error bound.
 *
 *     bytes:  options, a byte each; whether there are a map, a reference, labels, invalid coordinates and corners
 *             number of points, three bytes each; then triangles, three bytes each
 */
#include "Bytes.h"
#include "Proof/Certificate/Certificate.h"
#include "Repair/Diagnostics/Diagnostics.h"
#include "Run/Decimate.h"
#include "Run/Input/Labels.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

using namespace bonedecimate;
using bonedecimate::testsupport::Bytes;

namespace
{
constexpr int MaxPoints = 60;

struct Question
{
  bonedecimate::Options Options;
  int NumberOfLabels = 0; // 0: none
  bool HasMap = false;
  bool HasReference = false;
  bool MovesReference = false;
  bool HasNonsense = false;
  bool IsSingle = false;
  bool WantsOrigins = false;
};

Question AnyQuestion(Bytes& bytes)
{
  Question question;
  Options& options = question.Options;
  options.Mode = static_cast<Mode>(bytes.Below(4));
  options.NumberOfThreads = 1;
  options.OutputPointsPrecision = static_cast<PointsPrecision>(bytes.Below(3));
  options.MergePoints = bytes.Switch();
  options.IntersectionGuard = bytes.Switch();
  options.ProveResult = bytes.Switch();
  options.MeasureInputDistances = bytes.Switch();
  options.MeasureDistances = bytes.Below(64) == 1; // a hundred thousand samples each time
  options.TargetNumberOfTriangles = bytes.Below(128);
  options.TargetReduction = bytes.Below(101) / 100.0;
  options.TargetReductionIsExplicit = bytes.Switch();
  options.MaximumError = std::pow(bytes.Below(64) / 16.0, 3.0); // mm
  options.NormalTolerance = bytes.Below(101) / 100.0;
  options.ErrorPreset = static_cast<ErrorPreset>(bytes.Below(8) < 4 ? 0 : bytes.Below(4));
  options.VoxelSize = bytes.Below(32) / 8.0; // mm
  options.AutomaticNormalTolerance = bytes.Switch();
  options.PruneTriangles = bytes.Below(4) == 1 ? 5 : 0;
  options.PruneSize = bytes.Below(4) == 1 ? 2.0 : 0.0; // mm
  question.NumberOfLabels = bytes.Below(4);
  question.HasMap = bytes.Below(3) == 1;
  question.HasReference = bytes.Below(4) == 1;
  question.MovesReference = bytes.Switch();
  question.HasNonsense = bytes.Below(4) == 1;
  question.IsSingle = bytes.Switch();
  question.WantsOrigins = bytes.Switch();
  options.Smoothing = bytes.Below(4) == 1 ? bytes.Below(32) / 16.0 : 0.0; // mm
  options.AutomaticSmoothing = bytes.Below(4) == 1;
  options.FeatureAngle = bytes.Below(2) == 1 ? bytes.Below(181) : 180.0; // degrees
  return question;
}

/// mm; few different ones, so that points meet and planes are flat.
double Coordinate(Bytes& bytes, bool hasNonsense)
{
  const int byte = bytes.Next();
  if (hasNonsense && byte >= 250)
  {
    constexpr double nonsense[] = { 1e300, -1e31, 1e29, 1e-310,
      std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity() };
    return nonsense[byte - 250];
  }
  return (byte - 128) / 16.0;
}

Surface AnySurface(Bytes& bytes, bool hasNonsense)
{
  Surface surface;
  const int points = bytes.Below(MaxPoints + 1);
  for (int p = 0; p < points; ++p)
  {
    const double x = Coordinate(bytes, hasNonsense);
    const double y = Coordinate(bytes, hasNonsense);
    surface.Points.emplace_back(x, y, Coordinate(bytes, hasNonsense));
  }
  while (bytes.Count() >= 3)
  {
    Triangle triangle = {};
    for (Index& corner : triangle)
    {
      const int byte = bytes.Next();
      corner = hasNonsense ? byte - 2 : points == 0 ? -1 : byte % points;
    }
    surface.Triangles.push_back(triangle);
  }
  return surface;
}

std::vector<double> MapOf(const Surface& surface)
{
  std::vector<double> map;
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    map.push_back(static_cast<double>((p * 7) % 5) - 1.0);
  }
  return map;
}

/// The labels of stripes of seven triangles: neighbors in a soup have one or two labels.
Labels LabelsOf(const Surface& surface, int count)
{
  Labels labels;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    labels.OfTriangle.push_back(static_cast<Index>(t / 7) % count);
  }
  for (int label = 0; label < count; ++label)
  {
    labels.Names.push_back(std::to_string(label));
  }
  return labels;
}

void Demand(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
  }
}

void DemandSurface(const Surface& surface)
{
  for (const Vector3& p : surface.Points)
  {
    Demand(p.allFinite(), "a point is not finite");
  }
  for (const Triangle& t : surface.Triangles)
  {
    for (const Index corner : t)
    {
      Demand(corner >= 0 && static_cast<std::size_t>(corner) < surface.Points.size(),
        "a corner is no point");
    }
    Demand(t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "a corner is there twice");
  }
}

void DemandReport(const Report& report)
{
  const bool isGood = report.Status == InputStatus::Good;
  Demand(isGood == InputMessage(report).empty(),
    "a rejection without a message, or a message without a rejection");
  if (isGood)
  {
    Demand(report.Output.Components == report.Input.Components, "a component is gone");
    Demand(report.Output.Faces <= report.Input.Faces, "there are more triangles than before");
    Demand(report.Output.NonManifoldEdges <= report.Input.NonManifoldEdges, "edges of three");
    // Overlapping soups may have several nearest triangles: the proof is undecided then, and reported so.
    Demand(report.Proof.Status != ProofStatus::Violated, "the error bound is violated");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const Question question = AnyQuestion(bytes);
  const Surface surface = AnySurface(bytes, question.HasNonsense);
  const std::vector<double> map = question.HasMap ? MapOf(surface) : std::vector<double>();
  Surface reference = surface;
  if (question.MovesReference && !reference.Points.empty())
  {
    reference.Points.front()[2] += 0.25;
  }
  const bool hasLabels = question.NumberOfLabels > 0;
  const Labels labels = hasLabels ? LabelsOf(surface, question.NumberOfLabels) : Labels();
  const Result result = Decimate(surface, question.Options, {},
    { question.IsSingle, question.WantsOrigins, question.HasMap ? &map : nullptr,
      question.HasReference ? &reference : nullptr, hasLabels ? &labels : nullptr });
  DemandSurface(result.Surface);
  DemandReport(result.Report);
  const std::vector<Diagnostic> diagnostics = Diagnose(surface, 1);
  Demand(diagnostics.size() <= static_cast<std::size_t>(NumberOfDiagnosticKinds),
    "diagnostics of no kind");
  CertificateOptions options;
  options.NumberOfThreads = 1;
  options.RelativeGap = 0.01;
  const Certificate found = Certify(surface, result.Surface, options);
  Demand(found.Status != CertificateStatus::Good || found.Lower() <= found.Upper(),
    "a lower bound above the upper");
  return 0;
}
