// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Options/NumberRange.h"
#include "Options/OptionTable.h"
#include "Options/UnmetNeeds.h"
#include "Proof/Certificate/Certificate.h"
#include "SizeText.h"
#include "TunnelTable.h"
#include "Words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr double LabelChangeToWarn = 0.01;
/// A warning names the position where the result is farthest if this distance exceeds this fraction
/// of the input's diagonal, and this many root mean squares of the distance: it is a spike's tip.
constexpr double DistanceToWarn = 0.05;
constexpr double RatioToWarn = 10.0;

/// "point has NaN" for "points have NaN".
std::string InSingular(std::string text)
{
  text.erase(text.find("s "), 1);
  for (const auto& [plural, singular] : { std::pair(" have ", " has "),
         std::pair(" were ", " was "), std::pair(" stay where they are ", " stays where it is ") })
  {
    const std::size_t at = text.find(plural);
    if (at != std::string::npos)
    {
      return text.replace(at, std::string(plural).size(), singular);
    }
  }
  return text;
}

/// @param what Plural noun and verb, such as "points have NaN".
std::string Found(std::int64_t count, const char* what, const char* kind, std::int64_t first)
{
  return std::to_string(count) + " " + (count == 1 ? InSingular(what) : what) + ", the first is " +
    kind + " " + std::to_string(first);
}

std::string Counted(std::int64_t count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Names of arrays that are not computed are ignored, because ParaView's panel sets all of them.
std::vector<std::string> IdleWarnings(const Report& report)
{
  const std::string suffix = "ArrayName";
  const auto isName = [&suffix](const std::string& option)
  {
    return option.size() > suffix.size() &&
      option.compare(option.size() - suffix.size(), suffix.size(), suffix) == 0;
  };
  Options options = report.Requested;
  std::vector<std::string> given = ChangedOptions(options);
  given.erase(std::remove_if(given.begin(), given.end(), isName), given.end());
  if (report.HasTolerances && options.ToleranceArrayName.empty())
  {
    options.ToleranceArrayName = "without a name";
  }
  return UnmetNeeds(options, given);
}

/// Nothing was smoothed.
std::vector<std::string> SmoothingWarnings(const Report& report)
{
  using Source = SmoothingFigures::Source;
  const SmoothingFigures& smoothing = report.Smoothing;
  std::vector<std::string> warnings;
  if (smoothing.From != Source::NotRequested && !smoothing.HasRun())
  {
    const bool isGray = smoothing.From == Source::GrayLevel;
    const bool isOfLabelMap = report.Voxels.Values.size() > 2; // labels and the background
    warnings.emplace_back(isOfLabelMap || (report.Labels.size() > 1 && !isGray)
        ? "the surface was not smoothed: it has several labels, which are smoothed in the run that "
          "extracts them from their label map (Smoothing smooths it anyway)"
        : isGray
        ? "the surface was not smoothed: it is that of a gray-level volume, which holds more "
          "detail than its voxels (Smoothing smooths it anyway)"
        : "the surface was not smoothed: it is not the unmodified surface of one label of a "
          "segmentation (Smoothing smooths it anyway)");
  }
  return warnings;
}

/// Without a largest error nothing keeps the result near.
std::vector<std::string> DistanceWarnings(const Report& report)
{
  const double distance = report.OutputToInput.Maximum;
  if (report.Requested.BoundsError() || !report.DistancesMeasured ||
    !(distance > DistanceToWarn * report.Size.Diagonal) ||
    !(distance > RatioToWarn * report.OutputToInput.RootMeanSquare))
  {
    return {};
  }
  char text[200];
  std::snprintf(text, sizeof(text),
    "the result has a spike: a position is %.3g mm from the input, %.0f %% of its diagonal; more "
    "triangles, or a largest error, keep it near",
    distance, 100.0 * distance / report.Size.Diagonal);
  return { text };
}

/// Areas of a label map are those of walls between two labels, "1_2" (LabelArrays.h).
std::vector<std::string> LabelWarnings(const std::vector<LabelArea>& areas)
{
  const auto isChanged = [](const LabelArea& a) { return a.Change() > LabelChangeToWarn; };
  const auto most = std::max_element(areas.begin(), areas.end(),
    [](const LabelArea& a, const LabelArea& b) { return a.Change() < b.Change(); });
  if (most == areas.end() || !isChanged(*most))
  {
    return {};
  }
  const std::size_t between = most->Name.find('_');
  const bool isWall = std::count(most->Name.begin(), most->Name.end(), '_') == 1;
  const std::string name = isWall
    ? "the wall between " + most->Name.substr(0, between) + " and " + most->Name.substr(between + 1)
    : "label " + most->Name;
  const auto count = std::count_if(areas.begin(), areas.end(), isChanged);
  char change[40];
  std::snprintf(change, sizeof(change), ": by %.3g %%", 100.0 * most->Change());
  return { "the areas of " + std::to_string(count) +
    (isWall ? " walls between labels" : " labels") + " changed by more than 1 %, most that of " +
    name + change };
}

std::string FarMessage(const ProvedDistance& distance)
{
  char text[160];
  std::snprintf(text, sizeof(text),
    "the input itself is farther from the reference than the largest error: between %.9g and %.9g "
    "mm, or its open boundaries are",
    distance.Lower, distance.Upper);
  return text;
}

/// Rounding moved points onto others, or too far.
std::string CoarseMessage(const CleaningStatistics& found, double gridStep)
{
  char rounding[80] = "single precision";
  if (gridStep > 0.0)
  {
    std::snprintf(rounding, sizeof(rounding), "rounding to multiples of %.3g mm", gridStep);
  }
  const char* const remedy =
    gridStep > 0.0 ? "a finer grid" : "double precision, or an origin near the surface,";
  char text[320];
  if (found.MeetingPoints > 0)
  {
    std::snprintf(text, sizeof(text),
      "%s leaves %lld points of the result at the positions of others, the first is point %lld of "
      "the input; %s keeps them apart",
      rounding, static_cast<long long>(found.MeetingPoints),
      static_cast<long long>(found.FirstCoarsePoint), remedy);
    return text;
  }
  std::snprintf(text, sizeof(text),
    "%s alone moves %lld points farther than the largest error or their tolerances allow, by up to "
    "%.3g mm, the first is point %lld; %s leaves them where they are",
    rounding, static_cast<long long>(found.CoarsePoints), found.MaxRounding,
    static_cast<long long>(found.FirstCoarsePoint), remedy);
  return text;
}
}

double ErrorProof::Lower() const
{
  return std::max({ this->InputToOutput.Lower, this->OutputToInput.Lower,
    this->BoundaryInputToOutput.Lower, this->BoundaryOutputToInput.Lower });
}

double ErrorProof::Upper() const
{
  return std::max({ this->InputToOutput.Upper, this->OutputToInput.Upper,
    this->BoundaryInputToOutput.Upper, this->BoundaryOutputToInput.Upper });
}

const char* StopReasonWord(StopReason reason)
{
  static const char* const words[] = { "not_run", "target_reached", "error_reached",
    "already_satisfied", "nothing_left", "aborted", "handles" };
  return WordOf(words, reason);
}

void StageSeconds::AddStages(const StageSeconds& ofPart)
{
  this->Prepare += ofPart.Prepare;
  this->Collapse += ofPart.Collapse;
  this->Decimate += ofPart.Decimate;
  this->Measure += ofPart.Measure;
  this->Prove += ofPart.Prove;
}

const char* StopReasonSentence(StopReason reason)
{
  static const char* const sentences[] = { "Nothing was run.",
    "The requested number of triangles or reduction was reached.",
    "The requested largest error was reached.", "No triangle was to be removed.",
    ("No further collapse is allowed: it would change the topology, a boundary, a fragment, "
     "constrained vertices or what else was requested."),
    "The run was aborted; the surface is valid, but may have more triangles than requested.",
    ("The handles of the surface prevent fewer triangles: most collapses that are left "
     "would close one.") };
  return WordOf(sentences, reason);
}

const char* DraftStatusWord(DraftStatus status)
{
  static const char* const words[] = { "no_bound", "not_used", "used", "undone",
    "edits_are_recorded", "each_edit_is_proved", "more_filters" };
  return WordOf(words, status);
}

const char* RegionStatusWord(RegionStatus status)
{
  static const char* const words[] = { "not_requested", "used", "other_options", "too_large",
    "not_proved" };
  return WordOf(words, status);
}

namespace
{
/// Rejection of tolerances or edge lengths, which have one value for each point.
std::string NumbersMessage(const CleaningStatistics& found, InputStatus status)
{
  const bool areLengths = status == InputStatus::BadEdgeLengths;
  if ((areLengths ? found.BadEdgeLengths : found.BadTolerances) == 0)
  {
    return std::string("there is not one ") + (areLengths ? "edge length" : "tolerance") +
      " for each point";
  }
  if (!areLengths)
  {
    return Found(found.BadTolerances, "points have a tolerance that is NaN or beyond 1e30 mm",
      "point", found.FirstBadTolerance);
  }
  return Found(found.BadEdgeLengths,
    "points have an edge length that is not above 0 mm, NaN or beyond 1e30 mm", "point",
    found.FirstBadEdgeLength);
}
}

std::string InputMessage(const Report& report)
{
  const CleaningStatistics& found = report.Cleaning;
  switch (report.Status)
  {
    case InputStatus::Good:
      return {};
    case InputStatus::Empty:
      return "the input is empty: no points and no triangles";
    case InputStatus::NoTriangles:
      return "the input has no triangle with an area (" + Counted(found.PointsRead, "point") +
        ", " + Counted(found.TrianglesRead, "triangle") + ")";
    case InputStatus::NonFinitePoints:
      return Found(found.NonFinitePoints, "points have NaN or infinite coordinates", "point",
        found.FirstNonFinitePoint);
    case InputStatus::HugeCoordinates:
      return Found(
        found.HugePoints, "points have coordinates beyond 1e30 mm", "point", found.FirstHugePoint);
    case InputStatus::IndexOutOfRange:
      return Found(found.TrianglesOutOfRange, "triangles have point indices out of range",
               "triangle", found.FirstTriangleOutOfRange) +
        " (there are " + std::to_string(found.PointsRead) + " points)";
    case InputStatus::TooManyTriangles:
      return "the input has " + std::to_string(found.TrianglesRead) +
        " triangles; 536870911 is the most";
    case InputStatus::BadTolerances:
    case InputStatus::BadEdgeLengths:
      return NumbersMessage(found, report.Status);
    case InputStatus::UnprovableTolerances:
      return FindMode(report.Requested.Mode).Name +
        std::string(" mode proves no distances: its tolerances can only be 0 (no change) or "
                    "negative (no limit)");
    case InputStatus::ReferenceWithoutError:
      return "a reference needs a largest error and a mode other than " +
        ModeNamesWhere([](const ModeInfo& mode) { return !mode.ProvesError(); });
    case InputStatus::BadReference:
      return "the reference has no triangles, or points or triangles that no surface has";
    case InputStatus::FarFromReference:
      return FarMessage(report.Reference.ToInput);
    case InputStatus::EverythingPruned:
      return "each of the " + std::to_string(report.Pruned.Components.size()) +
        " components is smaller than what was to be kept; nothing would be left";
    case InputStatus::RoundingTooCoarse:
      return CoarseMessage(found, report.Requested.OutputPointsGrid);
    case InputStatus::ErrorBeyondSize:
    case InputStatus::ErrorBelowSize:
      return SizeMessage(report.Size, report.Status);
    case InputStatus::BadLabelMap:
      return "the voxel grid is not valid, its labels are not one pair for each triangle, or the "
             "surface is farther than 65536 voxels from the grid";
    case InputStatus::NoVoxelGrid:
      return "KeepVoxels is on, but the surface has no voxel grid: give its label map, extract it "
             "with vtkBoneSurfaces, which stores the grid, or set KeepVoxels to Auto or Off";
    case InputStatus::OptionConflict:
      return report.Conflict;
    case InputStatus::InvalidOption:
      return CheckOptions(report.Requested);
  }
  return {};
}

std::vector<std::string> InputWarnings(const Report& report)
{
  const CleaningStatistics& found = report.Cleaning;
  std::vector<std::string> warnings = IdleWarnings(report);
  if (report.Requested.MaximumError > 0.0 && !FindMode(report.Requested.Mode).ProvesError())
  {
    warnings.push_back(std::string("nothing is proved in ") + FindMode(report.Requested.Mode).Name +
      " mode: its largest error only limits the distance of new vertices");
  }
  const std::vector<std::string> ofSize = SizeWarnings(report.Size);
  warnings.insert(warnings.end(), ofSize.begin(), ofSize.end());
  if (report.Voxel.From == VoxelFigures::Source::Edges)
  {
    warnings.push_back("the surface has no grid of voxels, so their size of " +
      SentenceNumber(std::round(1000.0 * report.Voxel.Size) / 1000.0) +
      " mm is estimated from its edges; for a simplified surface that is too large: set VoxelSize");
  }
  const std::vector<std::string> ofTunnels = TunnelWarnings(report.Tunnels);
  warnings.insert(warnings.end(), ofTunnels.begin(), ofTunnels.end());
  const std::vector<std::string> ofSmoothing = SmoothingWarnings(report);
  warnings.insert(warnings.end(), ofSmoothing.begin(), ofSmoothing.end());
  const std::vector<std::string> ofParts = PartWarnings(report.Parts);
  warnings.insert(warnings.end(), ofParts.begin(), ofParts.end());
  const std::vector<std::string> ofDistance = DistanceWarnings(report);
  warnings.insert(warnings.end(), ofDistance.begin(), ofDistance.end());
  if (found.DroppedTriangles > 0)
  {
    warnings.push_back(Found(found.DroppedTriangles, "triangles without area were left out",
      "triangle", found.FirstDroppedTriangle));
  }
  if (found.NonManifoldPoints > 0)
  {
    warnings.push_back(Found(found.NonManifoldPoints,
      "points stay where they are because the surface is not manifold there", "point",
      found.FirstNonManifoldPoint));
  }
  const std::vector<std::string> ofLabels = LabelWarnings(report.Labels);
  warnings.insert(warnings.end(), ofLabels.begin(), ofLabels.end());
  return warnings;
}

std::string ProofMessage(const Report& report)
{
  const ErrorProof& proof = report.Proof;
  if (!proof.WasMade || proof.Status == ProofStatus::Proved ||
    proof.Status == ProofStatus::NotRequested)
  {
    return {};
  }
  const std::string limit = proof.Tolerance > 0.0
    ? "the largest error of " + SentenceNumber(proof.Tolerance) + " mm" +
      (report.HasTolerances ? " and the tolerances of the points" : "")
    : "the tolerances of the points";
  char text[120];
  std::snprintf(
    text, sizeof(text), ": the distance is between %.9g and %.9g mm", proof.Lower(), proof.Upper());
  return std::string("the certificate ") +
    (proof.Status == ProofStatus::Violated ? "contradicts" : "cannot decide") +
    " that the result keeps " + limit + text;
}
}
