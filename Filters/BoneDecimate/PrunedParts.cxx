// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrunedParts.cxx
 * @brief How vtkBoneDecimate prunes components of a surface that is in parts.
 */
#include "DecimateInternals.h"
#include "Run/Input/ComponentCensus.h"
#include "Run/Input/Prune.h"
#include "RunState.h"
#include "SurfaceConversion.h"

#include "vtkPolyData.h"

bool vtkBoneDecimate::Internals::FindPrunedCells(
  vtkPolyData* part, const bonedecimate::MeetingOfParts& meeting, std::vector<bool>& pruned)
{
  using namespace bonedecimate;
  const Options& options = this->Filter->State->Options;
  const ConvertedSurface converted = ToSurface(part, options.NumberOfThreads);
  const Vector3 common(meeting.Origin[0], meeting.Origin[1], meeting.Origin[2]);
  const CensusOfPart census =
    TakeCensus(converted.Surface, common, meeting.Shared, options.NumberOfThreads);
  std::vector<CensusOfPart> parts;
  for (const Numbers& numbers : meeting.Exchange(NumbersOf(census)))
  {
    parts.push_back(CensusFrom(numbers));
  }
  const JoinedCensus joined = JoinCensus(parts, common);
  Report& report = this->Filter->State->Report;
  report.Pruned = FindPruned(joined.All, options);
  pruned.assign(static_cast<std::size_t>(part->GetNumberOfCells()), false);
  if (report.Pruned.TookAll && !joined.All.empty())
  {
    Report found;
    found.Status = InputStatus::EverythingPruned;
    found.Pruned = report.Pruned;
    vtkErrorWithObjectMacro(this->Filter, << InputMessage(found));
    return false;
  }
  const std::vector<Index>& whole = joined.OfComponent[static_cast<std::size_t>(meeting.Own)];
  for (std::size_t t = 0; t < census.OfTriangle.size(); ++t)
  {
    const Index component = census.OfTriangle[t];
    if (component != None && IsPruned(joined.All[whole[component]], options))
    {
      pruned[static_cast<std::size_t>(converted(t))] = true;
    }
  }
  return true;
}
