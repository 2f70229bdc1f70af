// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditFigures.h
 * @brief Why the collapse ended, and what came of drafts, regions and forced collapses.
 */
#ifndef BoneDecimate_Core_Figures_EditFigures_h
#define BoneDecimate_Core_Figures_EditFigures_h

#include "Rejection.h"

#include <array>
#include <cstdint>

namespace bonedecimate
{
/// Why the collapse ended.
enum class StopReason : int
{
  NotRun = 0,
  TargetReached,    ///< The requested number of triangles, or the reduction.
  ErrorReached,     ///< The requested largest error.
  AlreadySatisfied, ///< The input already had no more triangles than requested.
  NothingLeft,      ///< No further collapse is allowed.
  Aborted,          ///< By the monitor.
  /// The number of triangles is out of reach: most collapses that are left would close a handle.
  Handles
};

/// What came of drafting the first collapses of a proved run.
enum class DraftStatus : int
{
  NoBound = 0, ///< Edits are not limited by an error.
  NotUsed,     ///< No collapse was needed.
  Used, ///< Collapses were drafted and proved together; those that could not be proved were undone.
  Undone,           ///< All drafted collapses were undone, and the run went on edit by edit.
  EditsAreRecorded, ///< Not possible, because every level of detail has to be proved.
  EachEditIsProved, ///< Not wanted: Options::ProveEachEdit.
  MoreFilters       ///< Not possible with filters of the caller.
};

struct DraftFigures
{
  DraftStatus Status = DraftStatus::NoBound;
  std::int64_t Collapses = 0; ///< That were drafted.
  std::int64_t Undone = 0;    ///< Drafted collapses that were undone.
};

/// Whether a run read only the regions that may change, and their surroundings.
enum class RegionStatus : int
{
  NotRequested = 0, ///< No point has a tolerance of 0.
  Used,
  OtherOptions, ///< Not possible with another option or input: the whole surface was read.
  TooLarge,     ///< Regions and surroundings are more than half of the surface.
  /// The result of a region could not be joined to the rest or proved; the whole surface was run.
  NotProved
};

struct RegionFigures
{
  RegionStatus Status = RegionStatus::NotRequested;
  std::int64_t Count = 0;     ///< Regions.
  std::int64_t Triangles = 0; ///< In the regions and their surroundings.
  std::int64_t Kept = 0;      ///< Regions whose results were kept from earlier runs.
};

/// Collapses that keep the error only together with moves around them
/// (Decimate/Stages/ForcedCollapse.h).
struct ForcedCollapseFigures
{
  std::int64_t Tried = 0; ///< On a copy of their neighborhood.
  std::int64_t Made = 0;  ///< Proved and applied.
};

/// The edits of a run, or of all parts of a surface.
struct EditFigures
{
  std::int64_t Collapses = 0;
  /// By Rejection; [NotRejected] is always 0.
  std::array<std::int64_t, NumberOfRejections> Rejections{};
  DraftFigures Draft;
  ForcedCollapseFigures Forced; ///< Only in modes that make them, with an error bound.

  /// The status of the drafts is then the last in the enumeration.
  void Add(const EditFigures& ofPart);
};
}

#endif
