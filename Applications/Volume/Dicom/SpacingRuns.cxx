// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpacingRuns.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace bonedecimate::volume
{
bool IsOtherDistance(double distance, double usual)
{
  return std::abs(distance - usual) > 0.2 * std::min(distance, usual);
}

std::vector<SpacingRun> RunsOf(const std::vector<double>& distances)
{
  std::vector<SpacingRun> runs;
  for (std::size_t k = 0; k < distances.size(); ++k)
  {
    if (runs.empty() || IsOtherDistance(distances[k], runs.back().Distance))
    {
      runs.push_back({ k, 0, 0.0 });
    }
    SpacingRun& run = runs.back();
    run.Distance += (distances[k] - run.Distance) / static_cast<double>(run.Count + 1);
    ++run.Count;
  }
  return runs;
}

bool AreOnPurpose(const std::vector<SpacingRun>& runs)
{
  constexpr std::size_t fewest = 3;
  constexpr std::size_t most = 6;
  return runs.size() <= most &&
    std::all_of(
      runs.begin(), runs.end(), [](const SpacingRun& run) { return run.Count >= fewest; });
}

std::string LengthText(double millimeters)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << millimeters << " mm";
  return text.str();
}
}
