// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificateFinding.h"

#include "Figures/BoundText.h"
#include "PageParts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr int DecimalsOfProof = 6;
constexpr int DecimalsOfFinding = 4;
constexpr int MostDecimals = 17;
constexpr double WidthOfCloseUp = 20.0; // distances
const std::array<std::string, 2> Directions = { "reference_to_result.", "result_to_reference." };

/// Rounded down, but not to a tolerance that the bound exceeds.
std::string LowerText(double lower, double tolerance, int decimals)
{
  std::string text = LowerBoundText(lower, decimals);
  while (
    lower > tolerance && std::strtod(text.c_str(), nullptr) <= tolerance && decimals < MostDecimals)
  {
    text = LowerBoundText(lower, ++decimals);
  }
  return text;
}

/// "0.5151 mm" and both bounds; "at least" unless they agree.
std::string ExceedingText(const ReportFields& report, const std::string& path, double tolerance)
{
  const double lower = report.Number(path + "lower").value_or(0.0);
  const std::optional<double> upper = report.Number(path + "upper");
  const bool doAgree = upper && *upper - lower < std::pow(10.0, -DecimalsOfFinding);
  return (doAgree ? "" : "at least ") + LowerText(lower, tolerance, DecimalsOfFinding) +
    " mm <small>(proved: " + LowerText(lower, tolerance, DecimalsOfProof) +
    (upper ? " to " + UpperText(*upper, tolerance, DecimalsOfProof) : " or more") + ")</small>";
}

/// The index of the direction with the larger lower bound.
std::size_t FartherOf(const ReportFields& report)
{
  const auto lower = [&](std::size_t side)
  { return report.Number(Directions[side] + "lower").value_or(0.0); };
  return lower(0) < lower(1) ? 1 : 0;
}

bool IsOnReference(const std::string& path)
{
  return path.find(Directions[0]) != std::string::npos;
}

/// Begins a sentence.
std::string OwnerOf(const std::string& path)
{
  return (path.rfind("boundary_", 0) == 0 ? "A point of an open boundary of the "
                                          : "A point of the ") +
    std::string(IsOnReference(path) ? "reference" : "result");
}

/// The path of the largest violation of the tolerance of a point; empty without one.
std::string LargestExcess(const ReportFields& report)
{
  std::string found;
  double largest = 0.0; // mm
  for (const char* of : { "", "boundary_" })
  {
    for (const std::string& direction : Directions)
    {
      const std::string path = std::string(of) + direction + "excess.";
      const double lower = report.Number(path + "lower").value_or(0.0);
      found = lower > largest ? path : found;
      largest = std::max(largest, lower);
    }
  }
  return report.Text("tolerance_array").empty() ? std::string() : found;
}
}

double ToleranceOf(const ReportFields& report)
{
  return report.Number("tolerance").value_or(0.0);
}

std::string UpperText(double upper, double tolerance, int decimals)
{
  std::string text = UpperBoundText(upper, decimals);
  while (
    upper <= tolerance && std::strtod(text.c_str(), nullptr) > tolerance && decimals < MostDecimals)
  {
    text = UpperBoundText(upper, ++decimals);
  }
  return text;
}

std::array<double, 3> PositionOf(const ReportFields& report, const std::string& path)
{
  const auto value = [&](const char* axis) { return report.Number(path + axis).value_or(0.0); };
  return { value("x"), value("y"), value("z") };
}

LargestDistance LargestOf(const ReportFields& report, const std::string& path)
{
  return { report.Number(path + "triangle").value_or(-1.0) < 0.0
      ? 0.0
      : report.Number(path + "lower").value_or(0.0),
    PositionOf(report, path) };
}

//------------------------------------------------------------------------------
std::string ViolatingBoundary(const ReportFields& report)
{
  const auto isViolated = [&report](const std::string& path)
  { return report.Text(path + "status") == "violated"; };
  std::string found;
  for (const std::string& direction : Directions)
  {
    if (isViolated(direction))
    {
      return {};
    }
    const std::string boundary = "boundary_" + direction;
    found = isViolated(boundary) ? boundary : found;
  }
  return found;
}

//------------------------------------------------------------------------------
std::array<std::string, 2> Violation(const ReportFields& report, const std::string& frame)
{
  const auto at = [&](const std::string& path)
  { return " at " + AnatomicalText(PositionOf(report, path), frame) + " mm"; };
  const std::string farthest = " farther than " +
    UpperText(report.Number("upper").value_or(0.0), ToleranceOf(report), DecimalsOfFinding) +
    " mm from the other.";
  if (const std::string excess = LargestExcess(report); !excess.empty())
  {
    return { ExceedingText(report, excess, 0.0) + " too far",
      OwnerOf(excess) + at(excess) +
        " is that far beyond its tolerance. No point of either surface is" + farthest };
  }
  const std::string boundary = ViolatingBoundary(report);
  if (boundary.empty())
  {
    const std::size_t side = FartherOf(report);
    return { ExceedingText(report, "", ToleranceOf(report)),
      OwnerOf(Directions[side]) + at(Directions[side]) + " is that far from the " +
        (side == 0 ? "result." : "reference.") };
  }
  const std::string apart = " Apart from that, no point of either surface is" + farthest;
  const std::string boundaries = report.Text("boundaries");
  if (boundaries == "reference_only" || boundaries == "result_only")
  {
    const std::string surface = boundaries == "result_only" ? "result" : "reference";
    return { "open boundary",
      "Only the " + surface + " has open boundaries, one" + at(boundary) + "." + apart };
  }
  return { ExceedingText(report, boundary, ToleranceOf(report)),
    "An open boundary" + at(boundary) + " is that far from those of the other surface." + apart };
}

//------------------------------------------------------------------------------
std::optional<PictureMark> MarkOfCertificate(const std::string& certificate)
{
  const ReportFields report(certificate);
  if (const std::string excess = LargestExcess(report); !excess.empty())
  {
    const double beyond = report.Number(excess + "lower").value_or(0.0);
    return PictureMark{ PositionOf(report, excess), IsOnReference(excess),
      LowerText(beyond, 0.0, DecimalsOfFinding) + " mm beyond", WidthOfCloseUp * beyond,
      LowerText(report.Number("lower").value_or(0.0), 0.0, DecimalsOfFinding) };
  }
  const std::string boundary = ViolatingBoundary(report);
  const std::string& farther = Directions[FartherOf(report)];
  const double lower = report.Number("lower").value_or(0.0);
  if (boundary.empty() && LargestOf(report, farther).Distance <= 0.0)
  {
    return {};
  }
  const std::string largest = LowerText(lower, ToleranceOf(report), DecimalsOfFinding);
  const std::string path = boundary.empty() ? farther : boundary;
  return PictureMark{ PositionOf(report, path), IsOnReference(path),
    boundary.empty() ? largest + " mm" : "open boundary",
    boundary.empty() ? WidthOfCloseUp * lower : std::numeric_limits<double>::infinity(), largest };
}
}
