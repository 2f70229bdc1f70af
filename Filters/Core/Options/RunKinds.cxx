// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunKinds.h"

#include "OptionTable.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Runs of the whole surface whose inputs leave something out.
std::vector<RunKind> WholeKinds()
{
  return {
    { "Whole", {} },
    { "KeepingVoxels",
      { { { Need::Tunnels },
          "{} does not go with KeepVoxels: a plug changes the labels of voxels" },
        { { Need::Welding },
          "{} does not go with KeepVoxels: welding moves points before labels are compared" } } },
    { "LabelMapSurface",
      { { { Need::Tunnels },
          "{} is not for the surface of a label map, whose voxels say what is bone: close tunnels "
          "in "
          "the label map, or remove the arrays BoundaryLabels and GridPoint" },
        { { Need::Welding }, "{} is not for the surface of a label map, which has no gaps" } } },
    { "Referenced",
      { { { Need::Tunnels },
          "{} does not go with a reference: errors then refer to the surface with its tunnels "
          "closed" },
        { { Need::Welding },
          "{} does not go with a reference: errors then refer to the surface that is welded" } } },
    { "PartOfSurface",
      { { { Need::Tunnels },
          "{} is not for a part of a surface, because a part does not show which loops go around a "
          "tunnel: run the whole surface on one process" },
        { { Need::Welding },
          "{} is not for a part of a surface, whose boundaries are not those of the whole" } } },
    { "Recorded",
      { { { Need::Tunnels },
          "{} does not go with recorded levels, which start from the input: close tunnels in a run "
          "of its own with TargetReduction 0" },
        { { Need::Welding },
          "{} does not go with recorded levels, which start from the input: weld in a run of its "
          "own with TargetReduction 0" } } },
  };
}

/// Runs that divide the surface.
std::vector<RunKind> DividedKinds()
{
  return {
    { "Regions",
      { { { Need::TargetCount, Need::SmoothingChoice, Need::Components, Need::Diagnostics,
            Need::InputOutput, Need::KeptVoxels, Need::GradedLengths, Need::Reference,
            Need::LabelMap, Need::Log, Need::PartOfSurface },
        "{} needs a run of the whole surface" } } },
    { "Slabs",
      { { { Need::VoxelSize },
          "A run in slabs needs the VoxelSize of its {}, because a slab does not tell it" },
        { { Need::TargetCount },
          "A run in slabs does not know the whole surface, so it has no target number of "
          "triangles" },
        { { Need::SmoothingChoice }, "A run in slabs does not smooth" },
        { { Need::Grid }, "A run in slabs does not round points to a grid" },
        { { Need::Components },
          "A run in slabs does not remove components, because it does not know them as a whole" },
        { { Need::Tunnels },
          "A run in slabs does not close tunnels, because it does not know them as a whole" },
        { { Need::Welding }, "A run in slabs does not weld: slabs have boundaries of their own" },
        { { Need::InputOutput, Need::Diagnostics },
          "A run in slabs does not keep the input, so it neither measures nor diagnoses it" },
        { { Need::SeparatePoints },
          "A run in slabs merges points, because this joins the slabs" } } },
  };
}

/// Runs on several processes. The first ones depend on the inputs.
std::vector<RunKind> ParallelKinds()
{
  return {
    { "RanksWithoutVoxelSize",
      { { { Need::VoxelSize },
        "{} on several processes needs VoxelSize: a part tells too little" } } },
    { "RanksWithoutVoxelGrid",
      { { { Need::KeptVoxels },
        "{} needs the voxel grid of the label map, and no process has one" } } },
    { "RanksWithReference",
      { { { Need::SmoothingChoice },
        "smoothing with a reference is for one process alone: a process may have a part of "
        "it" } } },
    { "RanksOfTwoPrecisions",
      { { { Need::SmoothingChoice },
        "smoothing on several processes needs points of one precision on all of them" } } },
    { "RanksWithoutPassedArrays",
      { { { Need::Labels },
        "{} on several processes needs PassArrays: triangles take their labels to another "
        "process" } } },
    { "Ranks",
      { { { Need::GradedLengths },
          "{all} are for one process alone: lengths are graded along the whole surface" },
        { { Need::SeparatePoints },
          "{} off is for one process alone: parts are joined where points are equal" },
        { { Need::Tunnels },
          "{} is for one process alone: a part does not show which loops go around a tunnel" },
        { { Need::Welding },
          "{} is for one process alone: the boundaries of a part are not those of the whole" },
        { { Need::Maps },
          "{} is for one process alone: the ids of a part are not those of the whole" },
        { { Need::Precision },
          "{} on several processes is that of the input: parts are joined where points are equal" },
        { { Need::Grid },
          "{} is for one process alone: points that parts have in common keep their coordinates" },
        { { Need::Diagnostics },
          "{} is for one process alone: what is odd about a part need not be so in the whole" } } },
  };
}

/// Needs of what a filter that is not vtkBoneDecimate does not write.
NeedList OutputNeeds()
{
  return { Need::InputOutput, Need::Diagnostics, Need::Grid, Need::Maps, Need::ArrayNames,
    Need::Components, Need::Tunnels, Need::Welding };
}

NeedList Joined(NeedList needs, const NeedList& more)
{
  needs.insert(needs.end(), more.begin(), more.end());
  return needs;
}

/// Filters, with the options that they do not have.
std::vector<RunKind> FilterKinds()
{
  const NeedList output = Joined(OutputNeeds(), { Need::Precision, Need::PassedArrays });
  return {
    { "ErrorSearch",
      { { Joined({ Need::SingleRun }, output),
        "the search makes many runs, whose errors it sets" } } },
    { "LevelsFilter", { { output, "levels have no output of their own" } } },
    { "SmoothFilter",
      { { Joined({ Need::Edits, Need::VoxelLengths }, OutputNeeds()),
        "smoothing keeps all triangles" } } },
  };
}

/// Functions for arrays of points and triangles, which are no data sets, in Python and JavaScript.
std::vector<RunKind> ArrayKinds()
{
  return {
    { "Arrays",
      { { { Need::InputArrays, Need::PassedArrays, Need::ArrayNames },
        "it is about the arrays of a data set" } } },
    { "RecordedLevels",
      { { { Need::Components, Need::Maps, Need::Grid },
          "levels are of all components, on no grid, and have no maps" },
        { { Need::Tunnels, Need::Welding }, "levels start from the input" } } },
    { "Smooth",
      { { { Need::Edits, Need::Maps, Need::Grid, Need::Tunnels, Need::Components, Need::Welding },
          "smoothing keeps all triangles" },
        { { Need::SmoothingChoice }, "distance says how far points may move" } } },
    { "OneThread", { { { Need::ThreadChoice }, "there is one thread" } } },
  };
}

bool NeedsOneOf(const NeedList& needs, const NeedList& lacked)
{
  return std::find_first_of(needs.begin(), needs.end(), lacked.begin(), lacked.end()) !=
    needs.end();
}

/// "MakeMaps", "--also, --page and --picture"
std::string NamesOf(const std::vector<Request>& requests, const NeedList& lacked)
{
  std::vector<std::string> names;
  for (const Request& request : requests)
  {
    if (NeedsOneOf(request.Needs, lacked))
    {
      names.push_back(request.Name);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

std::string Replaced(std::string text, const std::string& mark, const std::string& by)
{
  const std::size_t at = text.find(mark);
  return at == std::string::npos ? text : text.replace(at, mark.size(), by);
}
}

const std::vector<RunKind>& RunKindTable()
{
  static const std::vector<RunKind> table = []
  {
    std::vector<RunKind> rows;
    for (const std::vector<RunKind>& group :
      { WholeKinds(), DividedKinds(), ParallelKinds(), FilterKinds(), ArrayKinds() })
    {
      rows.insert(rows.end(), group.begin(), group.end());
    }
    return rows;
  }();
  return table;
}

const RunKind& FindRunKind(std::string_view name)
{
  const std::vector<RunKind>& table = RunKindTable();
  return *std::find_if(
    table.begin(), table.end(), [name](const RunKind& kind) { return kind.Name == name; });
}

std::vector<Request> RequestsOf(const Options& options)
{
  std::vector<Request> requests;
  for (const OptionInfo& info : OptionTable())
  {
    NeedList needs;
    for (const NeedList& group : info.Needs)
    {
      needs = Joined(needs, group);
    }
    requests.push_back({ info.Name, needs, IsUsed(options, info) });
  }
  return requests;
}

std::string FindUnsupported(const std::vector<RunKind>& kinds, const std::vector<Request>& requests)
{
  for (const RunKind& kind : kinds)
  {
    for (const Lack& lack : kind.Lacks)
    {
      for (const Request& request : requests)
      {
        if (request.IsUsed && NeedsOneOf(request.Needs, lack.Needs))
        {
          return Replaced(
            Replaced(lack.Sentence, "{all}", NamesOf(requests, lack.Needs)), "{}", request.Name);
        }
      }
    }
  }
  return {};
}

std::string WhyUnsupported(const RunKind& kind, const OptionInfo& info)
{
  for (const Lack& lack : kind.Lacks)
  {
    for (const NeedList& needs : info.Needs)
    {
      if (NeedsOneOf(needs, lack.Needs))
      {
        return Replaced(lack.Sentence, "{}", info.Name);
      }
    }
  }
  return {};
}
}
