// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArgumentKinds.h"

#include "FileGrid.h"
#include "FlagNames.h"
#include "Options/RunKinds.h"

#include <vector>

namespace bonedecimate
{
namespace
{
/// An argument that is no option of the table.
struct ArgumentRow
{
  const char* Name;
  NeedList Needs;
  bool (*IsUsed)(const Arguments& arguments);
};

bool IsVolumeRun(const Arguments& arguments)
{
  return arguments.Iso.has_value() || arguments.Segments.IsRequested();
}

const std::vector<ArgumentRow>& ArgumentTable()
{
  using A = Arguments;
  static const std::vector<ArgumentRow> table = {
    { "several inputs", { Need::WholeInMemory }, [](const A& a) { return IsBatch(a); } },
    { "--iso", { Need::GrayValues }, [](const A& a) { return a.Iso.has_value(); } },
    { "--intensities", { Need::IsoSurface },
      [](const A& a) { return a.Given.count("intensities") > 0; } },
    { "--label-names", { Need::Segments },
      [](const A& a) { return !a.Segments.LabelNames.empty(); } },
    { "--model-grid", { Need::WholeInMemory, Need::Segments },
      [](const A& a) { return a.Given.count("model-grid") > 0; } },
    { "--memory", { Need::Volume }, [](const A& a) { return a.Memory > 0; } },
    { "--fill-volume", { Need::WholeInMemory, Need::Volume },
      [](const A& a) { return a.FillVolume > 0.0; } },
    { "--region", { Need::WholeInMemory }, [](const A& a) { return !a.Regions.empty(); } },
    { "--reference", { Need::WholeInMemory, Need::OneReference },
      [](const A& a) { return !a.Reference.empty(); } },
    { "--label-map", { Need::WholeInMemory, Need::OneLabelMap },
      [](const A& a) { return !a.LabelMap.Path.empty(); } },
    { "--unit", { Need::LengthUnit }, [](const A& a) { return !a.Unit.IsMillimeter(); } },
    { "--also", { Need::OneFile }, [](const A& a) { return !a.Also.empty(); } },
    { "--report", { Need::OneFile }, [](const A& a) { return !a.Report.empty(); } },
    { "--page", { Need::WholeInMemory, Need::OneFile },
      [](const A& a) { return !a.Page.empty(); } },
    { "--heatmap", { Need::WholeInMemory, Need::OneFile },
      [](const A& a) { return !a.Heatmap.empty(); } },
    { "--picture", { Need::WholeInMemory, Need::OneFile },
      [](const A& a) { return !a.Picture.empty(); } },
    { "--jobs", { Need::ManyFiles }, [](const A& a) { return a.Jobs > 0; } },
    { "--time-limit", { Need::ManyFiles }, [](const A& a) { return a.TimeLimit > 0.0; } },
    { "--memory-limit", { Need::ManyFiles }, [](const A& a) { return a.MemoryLimit > 0; } },
    { "--shard", { Need::ManyFiles }, [](const A& a) { return a.Shard.Of > 0; } },
    { "--force", { Need::ManyFiles }, [](const A& a) { return a.Force; } },
    { "--only", { Need::ManyFiles }, [](const A& a) { return !a.Only.empty(); } },
    { "--format", { Need::ManyFiles }, // or several segments
      [](const A& a) { return !a.Format.empty() && !a.Segments.IsRequested(); } },
    { "an output in glb", { Need::WholeInMemory },
      [](const A& a) { return !IsBatch(a) && WritesGrid(a); } },
  };
  return table;
}

/// A kind of run, and whether the arguments ask for one of that kind.
struct KindRow
{
  bool (*IsOfKind)(const Arguments& arguments);
  RunKind Kind;
};

KindRow SegmentsRow()
{
  return { [](const Arguments& a) { return a.Segments.IsRequested(); },
    { "Segments",
      {
        { { Need::GrayValues },
          "--segments takes the labels of a label map, {} a gray value; they exclude each other" },
        { { Need::OneLabelMap }, "{} is for surfaces; with --segments the input is the label map" },
        { { Need::Labels },
          "{} names an array of a surface; with --segments the labels are those of the map" },
        { { Need::PointTolerances },
          "{} names an array of a surface; with --segments use --region" },
        { { Need::PointLengths },
          "{} names an array of a surface; with --segments use --chordal-error" },
        { { Need::LengthUnit },
          "{} is for surfaces; the header of a label map for --segments says its unit" },
        { { Need::TriangleComponents },
          "{} counts triangles of surfaces; with --segments, whose islands are voxels, use "
          "--prune-size, --prune-area or --prune-volume" },
      } } };
}

/// In the order in which contradictions are told.
const std::vector<KindRow>& KindTable()
{
  static const std::vector<KindRow> table = {
    { [](const Arguments& a) { return a.Iso.has_value(); },
      { "Iso",
        { { { Need::LengthUnit },
          "{} is for surfaces; the header of a volume for --iso says its unit" } } } },
    { [](const Arguments& a) { return a.Memory > 0; },
      { "Memory",
        { { { Need::WholeInMemory, Need::PointTolerances, Need::Labels, Need::GradedLengths },
          "--memory and {} do not go together" } } } },
    { [](const Arguments& a) { return !IsVolumeRun(a); },
      { "Surface",
        { { { Need::Volume }, "{} is for volumes, together with --iso or --segments" } } } },
    { [](const Arguments& a) { return !a.Segments.IsRequested(); },
      { "WithoutSegments", { { { Need::Segments }, "{} has no effect; it needs --segments" } } } },
    SegmentsRow(),
    { [](const Arguments& a) { return !IsBatch(a); },
      { "OneBone", { { { Need::ManyFiles }, "{all} are for many bones and an output folder" } } } },
    { [](const Arguments& a) { return IsBatch(a); },
      { "ManyBones",
        { { { Need::OneFile }, "{all} are for one bone; many get a report each" },
          { { Need::OneReference, Need::OneLabelMap }, "{} is for one bone" } } } },
    { [](const Arguments& a) { return !a.Iso.has_value(); },
      { "WithoutIso", { { { Need::IsoSurface }, "{} is for volumes, together with --iso" } } } },
  };
  return table;
}
}

std::string FindContradiction(const Arguments& arguments)
{
  std::vector<Request> requests;
  for (const ArgumentRow& row : ArgumentTable())
  {
    requests.push_back({ row.Name, row.Needs, row.IsUsed(arguments) });
  }
  const std::vector<Request> options = RequestsOf(arguments.Options);
  requests.insert(requests.end(), options.begin(), options.end());
  std::vector<RunKind> kinds;
  for (const KindRow& row : KindTable())
  {
    if (row.IsOfKind(arguments))
    {
      kinds.push_back(row.Kind);
    }
  }
  return WithFlags(FindUnsupported(kinds, requests));
}
}
