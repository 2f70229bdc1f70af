// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelPieces.h"

#include "LabelRanks.h"
#include "LabelRuns.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace bonedecimate
{
namespace
{
/// The labels of a map without the background, ascending: the label of rank r has the index r - 1.
std::vector<std::int64_t> LabelsOf(const LabelImage& image, std::int64_t background)
{
  std::vector<std::int64_t> labels = FindLabelValues(image, 0, {}).Values;
  labels.erase(std::remove(labels.begin(), labels.end(), background), labels.end());
  return labels;
}

/// The runs of a map, and which of its ranks are segments.
class SegmentRuns
{
public:
  SegmentRuns(
    const LabelImage& image, const std::vector<std::int64_t>& segments, std::int64_t background)
    : Labels(LabelsOf(image, background))
    , Runs(image, LabelRanks(Labels))
    , Background(background)
    , Grid(image.Grid)
    , VoxelVolume(image.Grid.Spacing.prod() * image.Grid.UnitVolume())
    , IndexOfRank(Labels.size() + 1, LabelRuns::None)
  {
    std::vector<std::int64_t> sorted = segments;
    std::sort(sorted.begin(), sorted.end());
    for (const std::int64_t segment : sorted)
    {
      const auto found = std::lower_bound(this->Labels.begin(), this->Labels.end(), segment);
      if (found != this->Labels.end() && *found == segment)
      {
        this->IndexOfRank[static_cast<std::size_t>(found - this->Labels.begin()) + 1] =
          this->Changes.Segments.size();
      }
      this->Changes.Segments.push_back({ segment, 0, 0, 0.0, false });
    }
  }

  bool IsSegment(Index rank) const
  {
    return this->IndexOfRank[static_cast<std::size_t>(rank)] != LabelRuns::None;
  }

  SegmentPieces& SegmentOf(Index rank)
  {
    return this->Changes.Segments[this->IndexOfRank[static_cast<std::size_t>(rank)]];
  }

  /// Counts a piece that changes.
  void CountPiece(Index rank, std::size_t voxels, double amount)
  {
    const Vector3& spacing = this->Grid.Spacing;
    SegmentPieces& segment = this->SegmentOf(rank);
    ++segment.Pieces;
    segment.Voxels += static_cast<std::int64_t>(voxels);
    segment.Volume += amount * (spacing[0] * spacing[1] * spacing[2] * this->Grid.UnitVolume());
  }

  /// Changes the label of a run.
  void Change(const LabelRun& run, Index rank)
  {
    const std::int64_t label =
      rank == 0 ? this->Background : this->Labels[static_cast<std::size_t>(rank) - 1];
    this->Changes.Runs.push_back({ this->Runs.FirstVoxel(run), LabelRuns::Length(run), label });
  }

  std::vector<std::int64_t> Labels;
  LabelRuns Runs;
  std::int64_t Background;
  const VoxelGrid& Grid;
  double VoxelVolume; // mm^3, of a voxel as thick as the grid's spacing
  PieceChanges Changes;

private:
  std::vector<std::size_t> IndexOfRank; // among the segments; None: no segment
};

/// A piece of a segment, at the index of its first run.
struct Piece
{
  std::size_t Voxels = 0;
  double Amount = 0.0; // LabelRuns::Amount()
  std::array<std::size_t, 3> Low = { LabelRuns::None, LabelRuns::None, LabelRuns::None };
  std::array<std::size_t, 3> High = { 0, 0, 0 }; // the voxels behind the last ones
  double Area = 0.0;                             // mm^2

  void Add(const LabelRun& run, std::size_t height)
  {
    const std::array<std::size_t, 3> begin = { static_cast<std::size_t>(run.Begin),
      run.Row % height, run.Row / height };
    const std::array<std::size_t, 3> end = { static_cast<std::size_t>(run.End), begin[1] + 1,
      begin[2] + 1 };
    this->Voxels += LabelRuns::Length(run);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], begin[axis]);
      this->High[axis] = std::max(this->High[axis], end[axis]);
    }
  }
};

class IslandSearch
{
public:
  IslandSearch(const LabelImage& image, SegmentRuns& segments, const IslandLimits& limits)
    : Grid(image.Grid)
    , Segments(segments)
    , Runs(segments.Runs.All())
    , Limits(limits)
    , PieceOf(segments.Runs.JoinByFaces())
  {
  }

  void Run()
  {
    this->Measure();
    this->FindIslands();
    this->FindContacts();
    this->GiveLabels();
    for (std::size_t run = 0; run < this->Runs.size(); ++run)
    {
      const auto island = this->Islands.find(this->PieceOf[run]);
      if (island != this->Islands.end())
      {
        this->Segments.Change(this->Runs[run], std::max(island->second.Rank, 0));
      }
    }
  }

private:
  struct Island
  {
    Index Rank = Unknown; ///< The new rank.
    /// mm^2 of its boundary, by ranks that stay and by other islands.
    std::map<Index, double> AreaOfRank;
    std::map<std::size_t, double> AreaOfIsland;
  };

  static constexpr Index Unknown = -1;

  bool IsOfSegment(std::size_t run) const { return this->Segments.IsSegment(this->Runs[run].Rank); }

  void Measure()
  {
    const auto height = static_cast<std::size_t>(this->Grid.Dimensions[1]);
    for (std::size_t run = 0; run < this->Runs.size(); ++run)
    {
      if (this->IsOfSegment(run))
      {
        Piece& piece = this->Pieces[this->PieceOf[run]];
        piece.Add(this->Runs[run], height);
        piece.Amount += this->Segments.Runs.Amount(this->Runs[run]);
      }
    }
    if (!(this->Limits.Area > 0.0))
    {
      return;
    }
    const auto add = [&](std::size_t run, double area)
    {
      if (this->IsOfSegment(run))
      {
        this->Pieces[this->PieceOf[run]].Area += area;
      }
    };
    this->Segments.Runs.VisitFaces(
      [&](std::size_t run, std::size_t other, double area)
      {
        if (other == LabelRuns::None)
        {
          add(run, area);
        }
        else if (this->PieceOf[run] != this->PieceOf[other])
        {
          add(run, area);
          add(other, area);
        }
      });
  }

  bool IsTooSmall(const Piece& piece) const
  {
    double size =
      this->Grid.ThicknessOf(static_cast<Index>(piece.Low[2]), static_cast<Index>(piece.High[2]));
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      size = std::max(size,
        static_cast<double>(piece.High[axis] - piece.Low[axis]) *
          this->Grid.Spacing[static_cast<Eigen::Index>(axis)]);
    }
    return size < this->Limits.Size || piece.Area < this->Limits.Area ||
      piece.Amount * this->Segments.VoxelVolume < this->Limits.Volume;
  }

  /// All pieces that are too small, except the largest of each segment.
  void FindIslands()
  {
    std::map<Index, std::size_t> largest;
    for (const auto& [first, piece] : this->Pieces)
    {
      const auto [kept, isNew] = largest.emplace(this->Runs[first].Rank, first);
      if (!isNew && piece.Amount > this->Pieces[kept->second].Amount)
      {
        kept->second = first;
      }
    }
    for (const auto& [first, piece] : this->Pieces)
    {
      SegmentPieces& segment = this->Segments.SegmentOf(this->Runs[first].Rank);
      const bool isLargest = largest[this->Runs[first].Rank] == first;
      const bool isTooSmall = this->IsTooSmall(piece);
      segment.IsLargestTooSmall = segment.IsLargestTooSmall || (isLargest && isTooSmall);
      if (isTooSmall && !isLargest)
      {
        this->Islands[first];
        this->Segments.CountPiece(this->Runs[first].Rank, piece.Voxels, piece.Amount);
      }
    }
  }

  void FindContacts()
  {
    const auto addContact = [&](std::size_t run, std::size_t other, double area)
    {
      const auto island = this->Islands.find(this->PieceOf[run]);
      if (island == this->Islands.end())
      {
        return;
      }
      if (other == LabelRuns::None)
      {
        island->second.AreaOfRank[0] += area;
      }
      else if (this->Islands.count(this->PieceOf[other]) == 0)
      {
        island->second.AreaOfRank[this->Runs[other].Rank] += area;
      }
      else if (this->PieceOf[other] != this->PieceOf[run])
      {
        island->second.AreaOfIsland[this->PieceOf[other]] += area;
      }
    };
    if (this->Islands.empty())
    {
      return;
    }
    this->Segments.Runs.VisitFaces(
      [&](std::size_t run, std::size_t other, double area)
      {
        addContact(run, other, area);
        if (other != LabelRuns::None)
        {
          addContact(other, run, area);
        }
      });
  }

  /// In rounds: islands that touch only other islands get the labels that these got in the rounds
  /// before. The rest gets the background.
  void GiveLabels()
  {
    for (bool shouldContinue = true; shouldContinue;)
    {
      std::vector<std::pair<Island*, Index>> round;
      for (auto& [first, island] : this->Islands)
      {
        const Index rank = island.Rank == Unknown ? this->RankAround(island) : Unknown;
        if (rank != Unknown)
        {
          round.emplace_back(&island, rank);
        }
      }
      for (const auto& [island, rank] : round)
      {
        island->Rank = rank;
      }
      shouldContinue = !round.empty();
    }
  }

  /// The rank with the largest area; the least of several.
  Index RankAround(const Island& island) const
  {
    std::map<Index, double> areas = island.AreaOfRank;
    for (const auto& [other, area] : island.AreaOfIsland)
    {
      const Index rank = this->Islands.at(other).Rank;
      if (rank != Unknown)
      {
        areas[rank] += area;
      }
    }
    const auto largest = std::max_element(
      areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return largest == areas.end() ? Unknown : largest->first;
  }

  const VoxelGrid& Grid;
  SegmentRuns& Segments;
  const std::vector<LabelRun>& Runs;
  const IslandLimits& Limits;
  std::vector<std::size_t> PieceOf; // the first run of the piece of each run
  std::map<std::size_t, Piece> Pieces;
  std::map<std::size_t, Island> Islands;
};

/// A piece of background.
struct Cavity
{
  static constexpr Index Open = -1; ///< Reaches the end of the image, or touches several labels.

  std::size_t Voxels = 0;
  double Amount = 0.0; ///< LabelRuns::Amount()
  Index Rank = 0;      ///< Around it; 0: not known yet.

  void Touch(Index rank) { this->Rank = this->Rank == 0 || this->Rank == rank ? rank : Open; }
};
}

//------------------------------------------------------------------------------
PieceChanges FindIslands(const LabelImage& image, const std::vector<std::int64_t>& segments,
  std::int64_t background, const IslandLimits& limits)
{
  SegmentRuns runs(image, segments, background);
  IslandSearch(image, runs, limits).Run();
  return std::move(runs.Changes);
}

//------------------------------------------------------------------------------
PieceChanges FindCavities(const LabelImage& image, const std::vector<std::int64_t>& segments,
  std::int64_t background, double maxVolume)
{
  SegmentRuns runs(image, segments, background);
  const std::vector<LabelRun>& all = runs.Runs.All();
  const std::vector<std::size_t> pieceOf = runs.Runs.JoinByEdges();
  std::map<std::size_t, Cavity> cavities;
  for (std::size_t run = 0; run < all.size(); ++run)
  {
    if (all[run].Rank == 0)
    {
      Cavity& cavity = cavities[pieceOf[run]];
      cavity.Voxels += LabelRuns::Length(all[run]);
      cavity.Amount += runs.Runs.Amount(all[run]);
    }
  }
  runs.Runs.VisitFaces(
    [&](std::size_t run, std::size_t other, double)
    {
      const Index rank = all[run].Rank;
      const Index otherRank = other == LabelRuns::None ? Cavity::Open : all[other].Rank;
      if (rank == 0 && otherRank != 0)
      {
        cavities[pieceOf[run]].Touch(otherRank);
      }
      else if (rank != 0 && otherRank == 0)
      {
        cavities[pieceOf[other]].Touch(rank);
      }
    });
  const auto isFilled = [&](const Cavity& cavity)
  {
    return cavity.Rank > 0 && runs.IsSegment(cavity.Rank) &&
      cavity.Amount * runs.VoxelVolume <= maxVolume;
  };
  for (const auto& [first, cavity] : cavities)
  {
    if (isFilled(cavity))
    {
      runs.CountPiece(cavity.Rank, cavity.Voxels, cavity.Amount);
    }
  }
  for (std::size_t run = 0; run < all.size(); ++run)
  {
    const Cavity* const cavity = all[run].Rank == 0 ? &cavities[pieceOf[run]] : nullptr;
    if (cavity != nullptr && isFilled(*cavity))
    {
      runs.Change(all[run], cavity->Rank);
    }
  }
  return std::move(runs.Changes);
}
}
