// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertifyRun.h"

#include "Figures/BoundText.h"
#include "NumberText.h"
#include "Options/NumberRange.h"
#include "PlainText.h"
#include "Report/CountText.h"
#include "Terminal/ProgressDisplay.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace bonedecimate
{
namespace
{
constexpr int DecimalsOfLine = 6;
constexpr int DecimalsOfProgress = 4;

/// mm, with six decimals if that is the very number, else with all of them.
std::string ToleranceText(double tolerance)
{
  const std::string text = FixedText(tolerance + 0.0, DecimalsOfLine); // without the sign of -0
  return (std::strtod(text.c_str(), nullptr) == tolerance ? text : NumberText(tolerance)) + " mm";
}
}

std::string CertifyRun::BoundsSoFar() const
{
  const double upper = this->Filter->GetUpperBound();
  return std::isnan(upper) ? std::string()
                           : LowerBoundText(this->Filter->GetLowerBound(), DecimalsOfProgress) +
      " to " + UpperBoundText(upper, DecimalsOfProgress) + " mm";
}

//------------------------------------------------------------------------------
void CertifyRun::Tell()
{
  if (this->Requested.Quiet)
  {
    return;
  }
  if (this->Requested.HasReference())
  {
    this->TellDistance();
  }
  if (this->Voxels)
  {
    this->Voxels->Print();
  }
  if (!this->ReportOfResult.empty())
  {
    std::cout << "report in the file   " << PlainText(this->ReportOfResult) << "\n";
  }
  PrintWarnings(this->Warnings);
}

//------------------------------------------------------------------------------
std::string CertifyRun::Line() const
{
  const std::string status = this->Filter->GetStatusAsString();
  const std::string stopped = this->Filter->GetReportText("stopped");
  return LowerBoundText(this->Filter->GetLowerBound(), DecimalsOfLine) + " to " +
    UpperBoundText(this->Filter->GetUpperBound(), DecimalsOfLine) + " mm" +
    this->FartherBoundary() +
    (this->Filter->GetStatus() == vtkBoneSurfaceDistance::NOT_REQUESTED
        ? ""
        : ", " + status + this->Reservations()) +
    (stopped.empty() ? "" : ", " + stopped);
}

//------------------------------------------------------------------------------
std::string CertifyRun::FartherBoundary() const
{
  const std::string presence = this->Filter->GetReportText("boundaries");
  if (presence == "reference_only" || presence == "result_only")
  {
    return std::string(", only the ") + (presence == "result_only" ? "result" : "reference") +
      " has open boundaries";
  }
  double lower = 0.0; // mm
  double upper = 0.0; // mm
  for (const std::string path : { "boundary_reference_to_result", "boundary_result_to_reference" })
  {
    lower = std::max(lower, this->Value(path + ".lower"));
    upper = std::max(upper, this->Value(path + ".upper"));
  }
  return upper <= this->Filter->GetUpperBound()
    ? std::string()
    : ", open boundaries " + LowerBoundText(lower, DecimalsOfLine) + " to " +
      UpperBoundText(upper, DecimalsOfLine) + " mm";
}

//------------------------------------------------------------------------------
void CertifyRun::TellDistance() const
{
  if (this->Filter->GetWasStopped())
  {
    std::cout << this->Filter->GetReportText("stopped") << "\n";
  }
  std::cout << "distance             "
            << LowerBoundText(this->Filter->GetLowerBound(), DecimalsOfRounding) << " to "
            << UpperBoundText(this->Filter->GetUpperBound(), DecimalsOfRounding)
            << " mm, two-sided\n";
  this->TellDirection("reference_to_result", "reference -> result  ");
  this->TellDirection("result_to_reference", "result -> reference  ");
  const std::string boundaries = this->Filter->GetReportText("boundaries");
  if (boundaries == "reference_only" || boundaries == "result_only")
  {
    std::cout << "boundaries           only the "
              << (boundaries == "result_only" ? "result" : "reference")
              << " has some: infinitely far apart\n";
  }
  else
  {
    this->TellDirection("boundary_reference_to_result", "boundary ref -> res  ");
    this->TellDirection("boundary_result_to_reference", "boundary res -> ref  ");
  }
  if (const double components = this->Value("result.components"); !std::isnan(components))
  {
    for (const std::string name : { "components", "triangles" })
    {
      const double before = this->Value("reference." + name);
      std::cout << name << std::string(21 - name.size(), ' ')
                << GroupedText(this->Value("result." + name))
                << (std::isnan(before) ? std::string()
                                       : ", the reference has " + GroupedText(before))
                << "\n";
    }
  }
  for (int i = 0; !this->LeftOut(i).empty(); ++i)
  {
    std::cout << "left out             " << PlainText(this->LeftOut(i)) << "\n";
  }
  this->TellStatus();
  std::cout << "seconds              " << FixedText(this->Value("seconds"), 2) << "\n";
}

//------------------------------------------------------------------------------
std::string CertifyRun::PositionText(const std::string& path) const
{
  const auto triangle = static_cast<long long>(this->Value(path + ".triangle"));
  return triangle < 0 ? std::string()
                      : " at (" + FixedText(this->Value(path + ".x"), 4) + ", " +
      FixedText(this->Value(path + ".y"), 4) + ", " + FixedText(this->Value(path + ".z"), 4) +
      "), triangle " + std::to_string(triangle);
}

//------------------------------------------------------------------------------
void CertifyRun::TellDirection(const std::string& path, const std::string& words) const
{
  const double lower = this->Value(path + ".lower");
  if (std::isnan(lower))
  {
    return;
  }
  std::cout << words << LowerBoundText(lower, DecimalsOfRounding) << " to "
            << UpperBoundText(this->Value(path + ".upper"), DecimalsOfRounding) << " mm";
  std::cout << this->PositionText(path) << "\n";
  const double mean = this->Value(path + ".mean");
  if (!std::isnan(mean))
  {
    std::cout << "                     mean " << FixedText(mean, 6) << " +- "
              << FixedText(this->Value(path + ".mean_error"), 6) << ", RMS "
              << FixedText(this->Value(path + ".rms"), 6) << " +- "
              << FixedText(this->Value(path + ".rms_error"), 6) << " mm\n";
  }
  const std::string excess = path + ".excess";
  if (!this->Requested.ToleranceArray.empty() && this->Value(excess + ".upper") > 0.0)
  {
    std::cout << "                     beyond the tolerance of a point "
              << LowerBoundText(std::max(0.0, this->Value(excess + ".lower")), DecimalsOfRounding)
              << " to " << UpperBoundText(this->Value(excess + ".upper"), DecimalsOfRounding)
              << " mm" << this->PositionText(excess) << "\n";
  }
}

//------------------------------------------------------------------------------
std::string CertifyRun::StatusText() const
{
  const std::string word = this->Filter->GetStatusAsString();
  return word +
    (this->Filter->GetStatus() == vtkBoneSurfaceDistance::VIOLATED       ? ", not <= "
        : this->Filter->GetStatus() == vtkBoneSurfaceDistance::UNDECIDED ? " whether <= "
                                                                         : " <= ");
}

//------------------------------------------------------------------------------
std::string CertifyRun::Reservations() const
{
  if (this->Filter->GetStatus() != vtkBoneSurfaceDistance::PROVED)
  {
    return "";
  }
  return std::string(this->CoversWhatWasLeftOut() ? "" : ", but for what was left out") +
    (this->Requested.WithoutBoundaries ? ", but for open boundaries" : "");
}

//------------------------------------------------------------------------------
void CertifyRun::TellStatus() const
{
  const std::string map = this->Requested.ToleranceArray.empty()
    ? ""
    : "the map '" + this->Requested.ToleranceArray + "'";
  const std::string number =
    this->Requested.Tolerance ? ToleranceText(*this->Requested.Tolerance) : "";
  if (this->Filter->GetStatus() != vtkBoneSurfaceDistance::NOT_REQUESTED)
  {
    std::cout << "tolerance            " << this->StatusText() << map
              << (map.empty() || number.empty() ? "" : " and ") << number << this->Reservations()
              << "\n";
  }
}
}
