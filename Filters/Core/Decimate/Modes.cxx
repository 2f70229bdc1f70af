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
namespace
{
SweepSettings SweepsBeforeRefinement()
{
  SweepSettings settings;
  settings.SpikeWeight = 0.5; // more than in Fast: refinement wins back the mean error it costs
  settings.PositionsTriedForVoxels = MaximumPositions;
  return settings;
}

//------------------------------------------------------------------------------
RefineSettings RefinementOfBalanced()
{
  RefineSettings settings;
  settings.ExtraOfTarget = 0.2;
  settings.ExtraOfOriginal = 0.02;
  settings.EdgesOfCollapse = 4;
  settings.SweepsBefore = 1;
  settings.SweepsAfter = 1;
  settings.SweepsIfFew = 4;
  settings.ProvedRounds = 2;
  settings.ProvedSweeps = 1;
  settings.ProvedSweepsAfter = 1;
  settings.ShapeWeight = 0.11;
  settings.VoxelRounds = 2;
  return settings;
}

//------------------------------------------------------------------------------
RefineSettings RefinementOfAccurate()
{
  RefineSettings settings;
  settings.ExtraOfTarget = 0.3;
  settings.ExtraOfOriginal = 0.06;
  settings.EdgesOfCollapse = 4;
  settings.SweepsBefore = 1;
  settings.SweepsAfter = 6;
  settings.SweepsIfFew = 8;
  settings.ProvedRounds = 2;
  settings.ProvedSweeps = 2;
  settings.ForcedRounds = 6;
  settings.ProvedSweepsAfter = 3;
  settings.VoxelRounds = 3;
  return settings;
}

//------------------------------------------------------------------------------
ModeInfo ThesisRow()
{
  ModeInfo mode;
  mode.Mode = Mode::Thesis;
  mode.Name = "Thesis";
  mode.Schedule = QueuePolicies{ MakeNormalFieldDeviation, PlaneQuadricPositions };
  mode.ErrorMeaning = ErrorPolicy::RunningStop;
  mode.RecordsDistances = true;
  mode.Stages = { { "collapse", CollapseStage, 1.0 } };
  mode.Text = { "reproduces H. Brand\u00e3o's thesis",
    "vertex of lowest cost, then its cheapest edge; costs come from the normal field deviation "
    "(NFD)",
    "the candidates of the thesis", "none" };
  return mode;
}

//------------------------------------------------------------------------------
ModeInfo FastRow()
{
  ModeInfo mode;
  mode.Mode = Mode::Fast;
  mode.Name = "Fast";
  mode.Schedule = SweepPolicies{ QuadricDeviation, VolumePreservingPosition };
  mode.Stages = { { "collapse", CollapseStage, 1.0 } };
  mode.Text = { "previews; with a largest error a sixth less time than `Balanced`, a quarter more "
                "triangles",
    "by how much the collapse changes the normals", "least squares to the planes, volume preserved",
    "none" };
  return mode;
}

//------------------------------------------------------------------------------
ModeInfo BalancedRow()
{
  ModeInfo mode = FastRow();
  mode.Mode = Mode::Balanced;
  mode.Name = "Balanced";
  mode.KeepsInitialMesh = true;
  mode.Sweep = SweepsBeforeRefinement();
  mode.Refine = RefinementOfBalanced();
  mode.Stages = { { "collapse", CollapseStage, 0.3 }, { "refine", RefineStage, 1.0 } };
  mode.Text = { "planning on the result",
    "as `Fast`; without a largest error, the last ones by sampled error",
    "as `Fast`, then fitted to the original",
    "edge flips and vertex moves: one pass before the last collapses and one after (four if few "
    "triangles remain)" };
  return mode;
}

//------------------------------------------------------------------------------
ModeInfo AccurateRow()
{
  ModeInfo mode = BalancedRow();
  mode.Mode = Mode::Accurate;
  mode.Name = "Accurate";
  mode.Refine = RefinementOfAccurate();
  mode.Text = { "smallest error for a number of triangles",
    "as `Balanced`, with more collapses by sampled error", "as `Balanced`",
    "one pass before, six after (eight if few triangles remain)" };
  return mode;
}
}

//------------------------------------------------------------------------------
const std::vector<ModeInfo>& ModeTable()
{
  static const std::vector<ModeInfo> table = { ThesisRow(), FastRow(), BalancedRow(),
    AccurateRow() };
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
