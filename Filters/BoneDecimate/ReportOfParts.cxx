// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportOfParts.cxx
 * @brief The report of vtkPBoneDecimate on a surface in parts.
 */
#include "DecimateInternals.h"
#include "FiguresOfParts.h"
#include "Run/Input/ComponentCensus.h"
#include "Run/Report/ProofSentence.h"
#include "RunState.h"
#include "SurfaceConversion.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
using namespace bonedecimate;

constexpr const char* Missing =
  "on one process the report has, beside these figures, the points, edges, volume, Euler number "
  "and "
  "angles of both surfaces, distances over their areas, proof.lower and each direction of the "
  "proof, labels, parts, seconds and options";

/// Whether the report of a surface in parts has the entry of that name, beside its numbers.
bool IsOfWhole(const std::string& name)
{
  static const char* const groups[] = { "smoothing.", "voxels.", "pruned.", "left_out.",
    "rejections.", "draft.", "forced_collapses.", "stop_" };
  static const char* const names[] = { "version", "proof.sentence", "proof.status",
    "output.checksum", "collapses" };
  return std::find(std::begin(names), std::end(names), name) != std::end(names) ||
    std::any_of(std::begin(groups), std::end(groups),
      [&name](const std::string& group) { return name.compare(0, group.size(), group) == 0; });
}

std::string UnitOf(const std::string& name)
{
  const bool isArea = name == "input.area" || name == "output.area";
  const bool isLength = name.compare(0, 9, "distance.") == 0 || name.compare(0, 6, "proof.") == 0;
  return isArea ? "mm2" : isLength ? "mm" : "";
}
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::AddComponents(const std::string& side, vtkPolyData* part,
  const bonedecimate::MeetingOfParts& meeting, std::map<std::string, double>& entries) const
{
  const int threads = this->Filter->State->Options.NumberOfThreads;
  const Vector3 origin(meeting.Origin[0], meeting.Origin[1], meeting.Origin[2]);
  const CensusOfPart census =
    TakeCensus(ToSurface(part, threads).Surface, origin, meeting.Shared, threads);
  std::vector<CensusOfPart> parts;
  for (const Numbers& numbers : meeting.Exchange(NumbersOf(census)))
  {
    parts.push_back(CensusFrom(numbers));
  }
  const std::vector<PrunedComponent> all = JoinCensus(parts, origin).All;
  entries[side + ".components"] = static_cast<double>(all.size());
  for (const PrunedComponent& component : all)
  {
    entries[side + ".area"] += component.Area;
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::SetReportOfParts(const std::map<std::string, double>& entries,
  int stopReason, int proofStatus, const std::vector<Numbers>& ofParts, vtkPolyData* output)
{
  std::vector<ReportEntry> list;
  for (const auto& [name, value] : entries)
  {
    const std::string unit = UnitOf(name);
    list.push_back({ name, unit,
      unit.empty() ? ReportValue(static_cast<std::int64_t>(value)) : ReportValue(value) });
  }
  const auto of = [&entries](const char* name)
  {
    const auto found = entries.find(name);
    return found == entries.end() ? 0.0 : found->second;
  };
  Report report;
  report.Input.Faces = static_cast<std::int64_t>(of("input.triangles"));
  report.Output.Faces = static_cast<std::int64_t>(of("output.triangles"));
  report.Output.Components = static_cast<std::int64_t>(of("output.components"));
  report.Stop = static_cast<StopReason>(stopReason);
  report.DistancesMeasured = entries.count("distance.output_to_input.max") > 0;
  report.OutputToInput.Maximum = of("distance.output_to_input.max");
  report.InputToOutput.Maximum = of("distance.input_to_output.max");
  report.Proof.WasMade = entries.count("proof.upper") > 0;
  report.Proof.Status = static_cast<ProofStatus>(proofStatus);
  report.Proof.OutputToInput.Upper = of("proof.upper");
  report.Requested = this->Filter->State->Options;
  report.Pruned = this->Filter->State->Report.Pruned;
  report.Smoothing = this->Filter->State->Report.Smoothing;
  report.Voxels = this->Filter->State->Report.Voxels;
  report.Proof.BoundariesCompared = true; // each part compared its own
  TakeFiguresOfParts(ofParts, report);
  for (const ReportEntry& entry : ReportEntries(report))
  {
    if (IsOfWhole(entry.Name))
    {
      list.push_back(entry);
    }
  }
  list.push_back({ "parallel.missing", "", std::string(Missing) });
  this->Filter->State->Report = std::move(report);
  this->Filter->State->Entries = NamedEntries(list);
  SetReport(BoundToSurface(list), ArraysOfReport(), output->GetFieldData());
}
