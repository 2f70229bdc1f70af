// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportTable.h"

#include "Mesh/Checksum.h"
#include "Options/OptionTable.h"
#include "Proof/Certificate/Certificate.h"
#include "ProofSentence.h"
#include "Repair/Diagnostics/Diagnostics.h"
#include "ReportEntries.h"
#include "ShapeTable.h"
#include "TunnelTable.h"
#include "Words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bonedecimate
{
namespace
{
void AddSurface(Entries& entries, const std::string& side, const SurfaceStatistics& surface)
{
  AddCounts(entries, side, surface);
  AddShape(entries, side + ".shape", surface.Shape);
}

std::string ChecksumText(std::uint64_t checksum)
{
  char text[32];
  std::snprintf(text, sizeof(text), "fnv1a64:%016llx", static_cast<unsigned long long>(checksum));
  return text;
}

void AddCleaning(Entries& entries, const Report& report)
{
  const CleaningStatistics& found = report.Cleaning;
  entries.push_back({ "input.triangles_read", "", found.TrianglesRead });
  entries.push_back({ "input.points_read", "", found.PointsRead });
  entries.push_back({ "input.merged_points", "", found.MergedPoints });
  entries.push_back({ "input.unused_points", "", found.UnusedPoints });
  entries.push_back({ "input.dropped_triangles", "", found.DroppedTriangles });
  entries.push_back({ "input.first_dropped_triangle", "", found.FirstDroppedTriangle });
  entries.push_back({ "input.non_manifold_points", "", found.NonManifoldPoints });
  entries.push_back({ "input.first_non_manifold_point", "", found.FirstNonManifoldPoint });
  entries.push_back({ "input.constrained_points", "", found.ConstrainedPoints });
  entries.push_back({ "input.diagonal", "mm", report.Size.Diagonal });
  entries.push_back({ "input.checksum", "", ChecksumText(report.InputChecksum) });
}

void AddDistance(Entries& entries, const std::string& direction, const DistanceStatistics& distance)
{
  const std::string path = "distance." + direction;
  entries.push_back({ path + ".max", "mm", distance.Maximum });
  AddPosition(entries, path + ".max_at",
    { distance.MaximumAt[0], distance.MaximumAt[1], distance.MaximumAt[2] });
  entries.push_back({ path + ".second", "mm", distance.Second });
  entries.push_back({ path + ".mean", "mm", distance.Mean });
  entries.push_back({ path + ".rms", "mm", distance.RootMeanSquare });
  entries.push_back({ path + ".point_max", "mm", distance.PointMaximum });
  entries.push_back({ path + ".point_mean", "mm", distance.PointMean });
  entries.push_back({ path + ".point_rms", "mm", distance.PointRootMeanSquare });
  entries.push_back({ path + ".samples", "", distance.Samples });
  entries.push_back({ path + ".samples_per_mm2", "1/mm2", distance.SamplesPerSquareMillimeter });
}

void AddBounds(Entries& entries, const std::string& path, const ProvedDistance& distance)
{
  entries.push_back({ path + ".lower", "mm", distance.Lower });
  entries.push_back({ path + ".upper", "mm", distance.Upper });
}

void AddProof(Entries& entries, const Report& report)
{
  const ErrorProof& proof = report.Proof;
  if (!proof.WasMade && proof.Status != ProofStatus::Aborted)
  {
    return;
  }
  entries.push_back({ "proof.status", "", std::string(ProofStatusWord(proof.Status)) });
  if (!proof.WasMade)
  {
    entries.push_back({ "proof.sentence", "", std::string("nothing: the run was aborted") });
    return;
  }
  entries.push_back({ "proof.tolerance", "mm", proof.Tolerance });
  AddBounds(entries, "proof", { proof.Lower(), proof.Upper() });
  AddBounds(entries, "proof.output_to_input", proof.OutputToInput);
  AddBounds(entries, "proof.input_to_output", proof.InputToOutput);
  entries.push_back({ "proof.boundaries", "", BoundariesWord(proof) });
  if (proof.BoundariesCompared && proof.Boundaries == BoundaryPresence::Both)
  {
    AddBounds(entries, "proof.boundary_output_to_input", proof.BoundaryOutputToInput);
    AddBounds(entries, "proof.boundary_input_to_output", proof.BoundaryInputToOutput);
  }
  entries.push_back({ "proof.sentence", "", ProofSentence(report) });
}

void AddReference(Entries& entries, const ReferenceFigures& reference)
{
  entries.push_back({ "reference.triangles", "", reference.Faces });
  entries.push_back({ "reference.checksum", "", ChecksumText(reference.Checksum) });
  AddBounds(entries, "reference.to_input", reference.ToInput);
}

void AddLabels(Entries& entries, const Report& report)
{
  entries.push_back({ "labels.count", "", static_cast<std::int64_t>(report.Labels.size()) });
  entries.push_back({ "labels.largest_change", "", MaxLabelChange(report.Labels) });
  for (const LabelArea& area : report.Labels)
  {
    entries.push_back({ "labels.of_" + area.Name + ".input_area", "mm2", area.Input });
    entries.push_back({ "labels.of_" + area.Name + ".output_area", "mm2", area.Output });
  }
}

/// The diagnostics, a list of objects.
void AddDiagnostics(Entries& entries, const std::vector<Diagnostic>& diagnostics)
{
  for (std::size_t i = 0; i < diagnostics.size(); ++i)
  {
    const Diagnostic& found = diagnostics[i];
    const DiagnosticInfo& info = InfoOf(found.Kind);
    const std::string path = "diagnostics." + std::to_string(i);
    entries.push_back({ path + ".kind", "", info.Word });
    entries.push_back({ path + ".severity", "", std::string(SeverityWord(info.Severity)) });
    entries.push_back({ path + ".sentence", "", DiagnosticSentence(found) });
    entries.push_back({ path + ".count", "", found.Count });
    AddIfKnown(entries, path + ".length", "mm", found.Length);
    for (std::size_t k = 0; k < found.First.size() && !info.IdKind.empty(); ++k)
    {
      entries.push_back({ path + ".first_" + info.IdKind + "s." + std::to_string(k), "",
        static_cast<std::int64_t>(found.First[k]) });
    }
  }
}

/// The pruned components; only the largest are listed.
void AddPruned(Entries& entries, const PruneFigures& pruned)
{
  constexpr std::size_t mostListed = 1000;
  const std::vector<PrunedComponent>& all = pruned.Components;
  entries.push_back({ "pruned.components", "", static_cast<std::int64_t>(all.size()) });
  entries.push_back({ "pruned.triangles", "", pruned.Triangles });
  for (std::size_t i = 0; i < std::min(all.size(), mostListed); ++i)
  {
    const std::string path = "pruned.list." + std::to_string(i);
    entries.push_back({ path + ".triangles", "", all[i].Triangles });
    entries.push_back({ path + ".size", "mm", all[i].Size });
    entries.push_back({ path + ".area", "mm2", all[i].Area });
    AddIfKnown(entries, path + ".volume", "mm3", all[i].Volume);
    AddPosition(entries, path + ".center", all[i].Center);
  }
}

void AddVoxel(Entries& entries, const VoxelFigures& voxel)
{
  static const char* const sources[] = { "not_requested", "given", "grid", "edges" };
  entries.push_back({ "voxel.from", "", std::string(WordOf(sources, voxel.From)) });
  entries.push_back({ "voxel.size", "mm", voxel.Size });
  entries.push_back({ "voxel.error", "mm", voxel.Error });
  entries.push_back({ "voxel.largest_error", "mm", voxel.MaxError });
}

void AddSmoothing(Entries& entries, const SmoothingFigures& smoothing)
{
  static const char* const sources[] = { "not_requested", "label_map", "binary", "gray_level",
    "unknown" };
  entries.push_back({ "smoothing.surface", "", std::string(WordOf(sources, smoothing.From)) });
  entries.push_back({ "smoothing.bound", "mm", smoothing.Bound });
  if (!smoothing.HasRun())
  {
    return;
  }
  entries.push_back({ "smoothing.in_voxels", "", std::int64_t(smoothing.IsInVoxels ? 1 : 0) });
  entries.push_back({ "smoothing.strength", "", smoothing.Strength });
  entries.push_back({ "smoothing.rms_displacement", "mm", smoothing.RmsDisplacement });
  entries.push_back({ "smoothing.largest_displacement", "mm", smoothing.MaxDisplacement });
  entries.push_back({ "smoothing.angle_before", "degrees", smoothing.AngleBefore });
  entries.push_back({ "smoothing.angle_after", "degrees", smoothing.AngleAfter });
  entries.push_back({ "smoothing.area_before", "mm2", smoothing.AreaBefore });
  entries.push_back({ "smoothing.area_after", "mm2", smoothing.AreaAfter });
  entries.push_back({ "smoothing.volume_before", "mm3", smoothing.VolumeBefore });
  entries.push_back({ "smoothing.volume_after", "mm3", smoothing.VolumeAfter });
  entries.push_back({ "smoothing.sharp_points", "", smoothing.SharpPoints });
  entries.push_back({ "smoothing.limited_points", "", smoothing.LimitedPoints });
  entries.push_back({ "smoothing.rounds", "", smoothing.Rounds });
}

void AddPart(Entries& entries, const std::string& path, const PartFigures& part)
{
  if (!part.Label.empty())
  {
    entries.push_back({ path + ".label", "", part.Label });
  }
  entries.push_back({ path + ".triangles", "", part.Triangles });
  AddPosition(entries, path + ".center", part.Center);
  for (const auto& [side, measures] :
    { std::pair(".input", &part.Input), std::pair(".output", &part.Output) })
  {
    entries.push_back({ path + side + ".area", "mm2", measures->Area });
    AddIfKnown(entries, path + side + ".volume", "mm3", measures->Volume);
    AddIfKnown(entries, path + side + ".thickness_median", "mm", measures->Thickness.Median);
    AddIfKnown(
      entries, path + side + ".thickness_percentile_5", "mm", measures->Thickness.Percentile5);
  }
}

/// Only the largest are listed.
void AddParts(Entries& entries, const PartComparison& compared)
{
  static const char* const kinds[] = { "not_compared", "components", "labels" };
  entries.push_back({ "parts.kind", "", std::string(WordOf(kinds, compared.Of)) });
  entries.push_back({ "parts.count", "", static_cast<std::int64_t>(compared.Parts.size()) });
  entries.push_back({ "parts.smallest_volume", "mm3", compared.MinVolume });
  const std::size_t listed = std::min(compared.Parts.size(), PartComparison::MaxListed);
  for (std::size_t i = 0; i < listed; ++i)
  {
    AddPart(entries, "parts.list." + std::to_string(i), compared.Parts[i]);
  }
}

void AddVoxels(Entries& entries, const VoxelReport& voxels)
{
  const VoxelChanges& changes = voxels.Changes;
  entries.push_back({ "voxels.guard", "", std::string(voxels.WereGuarded ? "on" : "off") });
  entries.push_back({ "voxels.compared", "", changes.Compared });
  entries.push_back({ "voxels.changed", "", changes.Changed });
  for (std::size_t axis = 0; axis < 3 && changes.Changed > 0; ++axis)
  {
    entries.push_back(
      { "voxels.first_changed." + std::to_string(axis), "", changes.FirstChanged[axis] });
  }
  for (std::size_t i = 0; i < changes.OfLabel.size() && i < voxels.Values.size(); ++i)
  {
    const std::string path = "voxels.of_" + std::to_string(voxels.Values[i]);
    entries.push_back({ path + ".voxels", "", changes.OfLabel[i].Voxels });
    entries.push_back({ path + ".lost", "", changes.OfLabel[i].Lost });
    entries.push_back({ path + ".gained", "", changes.OfLabel[i].Gained });
  }
}

void AddRun(Entries& entries, const Report& report)
{
  if (report.Size.MaxError > 0.0)
  {
    entries.push_back({ "error_bound", "mm", report.Size.ErrorBound });
  }
  AddIfKnown(entries, "running_error", "mm", report.RunningError);
  if (FindMode(report.Requested.Mode).HasNormalTolerance())
  {
    entries.push_back({ "normal_tolerance", "", report.NormalTolerance });
  }
  entries.push_back({ "collapses", "", report.Edits.Collapses });
  for (std::size_t i = 1; i < NumberOfRejections; ++i)
  {
    entries.push_back(
      { std::string("rejections.") + RejectionTable[i].Word, "", report.Edits.Rejections[i] });
  }
  if (report.Edits.Draft.Status != DraftStatus::NoBound)
  {
    entries.push_back(
      { "draft.status", "", std::string(DraftStatusWord(report.Edits.Draft.Status)) });
    entries.push_back({ "draft.collapses", "", report.Edits.Draft.Collapses });
    entries.push_back({ "draft.undone", "", report.Edits.Draft.Undone });
    if (FindMode(report.Requested.Mode).Refine.ForcedRounds > 0)
    {
      entries.push_back({ "forced_collapses.tried", "", report.Edits.Forced.Tried });
      entries.push_back({ "forced_collapses.made", "", report.Edits.Forced.Made });
    }
  }
  AddShapeLimits(entries, report);
  if (report.Regions.Status != RegionStatus::NotRequested)
  {
    const RegionFigures& regions = report.Regions;
    entries.push_back({ "regions.status", "", std::string(RegionStatusWord(regions.Status)) });
    entries.push_back({ "regions.count", "", regions.Count });
    entries.push_back({ "regions.triangles", "", regions.Triangles });
    entries.push_back({ "regions.kept", "", regions.Kept });
  }
  entries.push_back({ "seconds.prepare", "s", report.Seconds.Prepare });
  entries.push_back({ "seconds.collapse", "s", report.Seconds.Collapse });
  entries.push_back({ "seconds.decimate", "s", report.Seconds.Decimate });
  entries.push_back({ "seconds.measure", "s", report.Seconds.Measure });
  entries.push_back({ "seconds.prove", "s", report.Seconds.Prove });
  entries.push_back({ "seconds.total", "s", report.Seconds.Total });
}

/// What refers to voxels.
void AddSegmentation(Entries& entries, const Report& report)
{
  if (report.Voxel.From != VoxelFigures::Source::NotRequested)
  {
    AddVoxel(entries, report.Voxel);
  }
  if (report.Smoothing.From != SmoothingFigures::Source::NotRequested)
  {
    AddSmoothing(entries, report.Smoothing);
  }
  if (report.Parts.Of != PartComparison::Kind::NotCompared)
  {
    AddParts(entries, report.Parts);
  }
  if (report.Voxels.WasChecked)
  {
    AddVoxels(entries, report.Voxels);
  }
}
}

std::vector<ReportEntry> ReportEntries(const Report& report)
{
  Entries entries;
  entries.push_back({ "version", "", std::string(Version()) });
  entries.push_back({ "stop_reason", "", std::string(StopReasonWord(report.Stop)) });
  entries.push_back({ "stop_sentence", "", std::string(StopReasonSentence(report.Stop)) });
  AddSurface(entries, "input", report.Input);
  AddCleaning(entries, report);
  entries.push_back({ "input.problem", "", InputMessage(report) });
  AddDiagnostics(entries, report.Diagnostics);
  if (report.Pruned.IsRequested)
  {
    AddPruned(entries, report.Pruned);
  }
  AddTunnels(entries, report.Tunnels);
  if (report.Weld.HasRun)
  {
    entries.push_back({ "weld.points", "", report.Weld.Points });
    entries.push_back({ "weld.movement", "mm", report.Weld.Movement });
  }
  AddSurface(entries, "output", report.Output);
  entries.push_back({ "output.checksum", "", TriangleChecksumText(report.OutputChecksum) });
  if (report.DistancesMeasured)
  {
    AddDistance(entries, "output_to_input", report.OutputToInput);
    AddDistance(entries, "input_to_output", report.InputToOutput);
  }
  if (report.BoundariesMeasured)
  {
    AddBounds(entries, "distance.boundary_output_to_input", report.BoundaryOutputToInput);
    AddBounds(entries, "distance.boundary_input_to_output", report.BoundaryInputToOutput);
  }
  AddSegmentation(entries, report);
  if (report.Reference.IsPresent)
  {
    AddReference(entries, report.Reference);
  }
  AddLeftOut(entries, "left_out", report.LeftOut);
  AddProof(entries, report);
  if (report.FragmentGapMeasured)
  {
    entries.push_back({ "fragment_gap.input", "mm", report.Gap.Input });
    entries.push_back({ "fragment_gap.output", "mm", report.Gap.Output });
  }
  if (!report.Labels.empty())
  {
    AddLabels(entries, report);
  }
  AddRun(entries, report);
  for (const OptionInfo& info : OptionTable())
  {
    entries.push_back({ "options." + info.Name, info.Unit, OptionText(report.Requested, info) });
  }
  return entries;
}
}
