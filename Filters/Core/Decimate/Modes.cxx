// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/Modes.h"

#include "Decimate/Cost/NormalFieldDeviation.h"
#include "Decimate/Cost/QuadricDeviation.h"
#include "Decimate/Placement/AlternatePositions.h"
#include "Decimate/Placement/PlaneQuadric.h"
#include "Decimate/Placement/VolumePreserving.h"
#include "Decimate/Stages/CollapseStage.h"
#include "Decimate/Stages/RefineStage.h"

namespace bonedecimate
{
const std::vector<ModeInfo>& ModeTable()
{
  using Error = ErrorPolicy;
  constexpr QueuePolicies byNormalFieldDeviation = { MakeNormalFieldDeviation,
    PlaneQuadricPositions };
  constexpr SweepPolicies byQuadricDeviation = { QuadricDeviation, VolumePreservingPosition };
  static const std::vector<Stage> collapse = { { "collapse", CollapseStage, 1.0 } };
  static const std::vector<Stage> collapseAndRefine = { { "collapse", CollapseStage, 0.3 },
    { "refine", RefineStage, 1.0 } };
  static const std::vector<ModeInfo> table = {
    { Mode::Thesis, "Thesis", byNormalFieldDeviation, Error::RunningStop, true, false, {}, {},
      collapse,
      { "reproduces H. Brand\u00e3o's thesis",
        "vertex of lowest cost, then its cheapest edge; costs come from the normal field deviation "
        "(NFD)",
        "the candidates of the thesis", "none" } },
    { Mode::Fast, "Fast", byQuadricDeviation, Error::ProvedBound, false, false, { 0.3, 4, 4 }, {},
      collapse,
      { "previews, large batches", "by how much the collapse changes the normals",
        "least squares to the planes, volume preserved", "none" } },
    // Spikes weigh more than in Fast: refinement wins back the mean error that costs.
    { Mode::Balanced, "Balanced", byQuadricDeviation, Error::ProvedBound, false, true,
      { 0.5, 4, MaximumPositions }, { 0.2, 0.02, 4, 1, 1, 4, 2, 1, 0, 1, 0.11, 2 },
      collapseAndRefine,
      { "planning on the result",
        "as `Fast`; without a largest error, the last ones by sampled error",
        "as `Fast`, then fitted to the original",
        "edge flips and vertex moves: one pass before the last collapses and one after (four if "
        "few triangles remain)" } },
    { Mode::Accurate, "Accurate", byQuadricDeviation, Error::ProvedBound, false, true,
      { 0.5, 4, MaximumPositions }, { 0.3, 0.06, 4, 1, 6, 8, 2, 2, 6, 3, 0.0, 3 },
      collapseAndRefine,
      { "smallest error for a number of triangles",
        "as `Balanced`, with more collapses by sampled error", "as `Balanced`",
        "one pass before, six after (eight if few triangles remain)" } },
  };
  return table;
}

//------------------------------------------------------------------------------
const ModeInfo& FindMode(Mode mode)
{
  const std::size_t row = static_cast<std::size_t>(mode);
  const std::vector<ModeInfo>& table = ModeTable();
  return table[row < table.size() ? row : static_cast<std::size_t>(Mode::Balanced)];
}

//------------------------------------------------------------------------------
std::vector<std::string> ModeNames()
{
  std::vector<std::string> names;
  for (const ModeInfo& mode : ModeTable())
  {
    names.emplace_back(mode.Name);
  }
  return names;
}
}
