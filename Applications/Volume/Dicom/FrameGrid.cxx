// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameGrid.h"

#include "SpacingRuns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bonedecimate::volume
{
namespace
{
/// Largest shift of a frame, in voxels: rounding in a header shifts less, a misplaced frame more.
constexpr double LargestShift = 0.2;

/// Frames closer than this part of a pixel lie in one plane.
constexpr double MinGap = 0.01;

/// Largest relative difference between the distance of planes in the header and in the frames.
constexpr double LargestChange = 0.02;

/// Limits the number of planes, and so the memory, if the distance of planes is damaged.
constexpr double MostPlanes(double planesWithFrames)
{
  return 1024.0 + 64.0 * planesWithFrames;
}

double PixelSide(const FramePlacement& frame)
{
  return std::min(frame.RowDistance, frame.ColumnDistance);
}

/// What is wrong with the placement of one frame by itself; empty if nothing is.
std::string PlacementProblem(const FramePlacement& frame, const std::array<std::int64_t, 2>& size)
{
  const double rows = static_cast<double>(size[1]) * frame.RowDistance;
  if (!(PixelSide(frame) > 0.0) || !std::isfinite(frame.RowDistance * frame.ColumnDistance))
  {
    return "its spacing is zero, negative or not a finite number";
  }
  const bool areUnits = std::abs(Length(frame.AlongRow) - 1.0) < 0.01 &&
    std::abs(Length(frame.AlongColumn) - 1.0) < 0.01;
  const double shift = std::abs(Dot(frame.AlongRow, frame.AlongColumn)) * rows;
  return areUnits && shift <= LargestShift * PixelSide(frame)
    ? std::string()
    : "the directions of its rows and columns are not perpendicular";
}

/// What differs between the first frame and another one, so that no grid has both; empty: nothing.
std::string DifferenceProblem(const std::vector<FramePlacement>& frames)
{
  const FramePlacement& first = frames.front();
  for (const FramePlacement& frame : frames)
  {
    if (!std::isfinite(Length(frame.Position)))
    {
      return "its position is not a finite number";
    }
    if (!AreClose(frame.AlongRow, first.AlongRow) ||
      !AreClose(frame.AlongColumn, first.AlongColumn))
    {
      return "its frames have several orientations; save each in a file of its own";
    }
    if (!(std::abs(frame.RowDistance - first.RowDistance) < 1e-3) ||
      !(std::abs(frame.ColumnDistance - first.ColumnDistance) < 1e-3))
    {
      return "its frames have pixels of several sizes";
    }
  }
  return std::string();
}

/// Frames in the order of their planes.
class Stack
{
public:
  Stack(const std::vector<FramePlacement>& frames, const Vector3& normal)
    : Frames(frames)
    , Normal(normal)
    , Order(frames.size())
    , Least(MinGap * PixelSide(frames.front()))
  {
    std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
    std::stable_sort(this->Order.begin(), this->Order.end(),
      [this](std::size_t a, std::size_t b) { return this->Height(a) < this->Height(b); });
    for (std::size_t i = 1; i < this->Order.size(); ++i)
    {
      if (this->Gap(i) > this->Least)
      {
        this->Gaps.push_back(this->Gap(i));
      }
    }
    std::sort(this->Gaps.begin(), this->Gaps.end());
  }

  /// The median of the distances of neighboring planes; 0 of a single one.
  double MedianDistance() const
  {
    return this->Gaps.empty() ? 0.0 : this->Gaps[(this->Gaps.size() - 1) / 2];
  }

  /// Planes, the step between them and the origin.
  void AssignPlanes(double distance, FrameGrid& grid) const
  {
    std::vector<double> parts;
    for (const double gap : this->GapsInOrder())
    {
      parts.push_back(std::max(1.0, std::round(gap / distance)));
    }
    this->NumberPlanes(parts, distance, grid);
    grid.Layers.clear();
    grid.Note.clear();
    if (grid.Problem.empty())
    {
      this->TakeDirection(grid);
    }
  }

  /// Planes that are where frames are.
  /// @return Whether their distances change on purpose.
  bool AssignUnevenPlanes(FrameGrid& grid) const
  {
    const std::vector<double> gaps = this->GapsInOrder();
    const std::vector<double> parts = PartsOf(gaps);
    std::vector<double> distances;
    for (std::size_t i = 0; i < gaps.size(); ++i)
    {
      distances.insert(distances.end(), static_cast<std::size_t>(parts[i]), gaps[i] / parts[i]);
    }
    const std::vector<SpacingRun> runs = RunsOf(distances);
    if (runs.size() < 2 || !AreOnPurpose(runs))
    {
      return false;
    }
    FrameGrid uneven = grid;
    this->NumberPlanes(parts, 0.0, uneven);
    const double mean = Length(uneven.Geometry.Steps[2]);
    uneven.Layers = { 0.0 };
    for (const double distance : distances)
    {
      uneven.Layers.push_back(uneven.Layers.back() + distance / mean);
    }
    uneven.Note = RunsNote(runs);
    if (uneven.Problem.empty())
    {
      this->TakeDirection(uneven);
    }
    const bool isUneven = uneven.Problem.empty();
    grid = isUneven ? uneven : grid;
    return isUneven;
  }

private:
  double Height(std::size_t frame) const { return Dot(this->Frames[frame].Position, this->Normal); }

  double Gap(std::size_t i) const
  {
    return this->Height(this->Order[i]) - this->Height(this->Order[i - 1]);
  }

  /// Between neighboring planes with frames.
  std::vector<double> GapsInOrder() const
  {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < this->Order.size(); ++i)
    {
      if (this->Gap(i) > this->Least)
      {
        gaps.push_back(this->Gap(i));
      }
    }
    return gaps;
  }

  /// Into how many distances each gap is divided: more than one where planes without frames lie
  /// between equal distances.
  static std::vector<double> PartsOf(const std::vector<double>& gaps)
  {
    std::vector<double> parts(gaps.size(), 1.0);
    const std::vector<SpacingRun> runs = RunsOf(gaps);
    for (std::size_t i = 1; i + 1 < runs.size(); ++i)
    {
      const double usual = runs[i - 1].Distance;
      const double whole = std::round(runs[i].Distance / usual);
      const bool isGap = !IsOtherDistance(runs[i + 1].Distance, usual) && whole > 1.0 &&
        whole < MostPlanes(static_cast<double>(gaps.size())) &&
        !IsOtherDistance(runs[i].Distance / whole, usual) &&
        runs[i].Count < runs[i - 1].Count + runs[i + 1].Count;
      for (std::size_t k = 0; isGap && k < runs[i].Count; ++k)
      {
        parts[runs[i].First + k] = whole;
      }
    }
    return parts;
  }

  static std::string RunsNote(const std::vector<SpacingRun>& runs)
  {
    std::string note = "its planes are " + LengthText(runs.front().Distance) + " apart";
    for (std::size_t i = 1; i < runs.size(); ++i)
    {
      note += (i > 1 ? ", " : " and ") + LengthText(runs[i].Distance) + " from plane " +
        std::to_string(runs[i].First + 1) + " on";
    }
    return note + "; they are read where they are";
  }

  /// @param parts For each gap, the planes from one plane with frames to the next.
  /// @param distance Distance of planes if there is one plane alone.
  void NumberPlanes(const std::vector<double>& parts, double distance, FrameGrid& grid) const
  {
    grid.Problem.clear();
    grid.PlaneOf.assign(this->Order.size(), 0);
    double plane = 0.0;
    std::size_t gap = 0;
    for (std::size_t i = 1; i < this->Order.size(); ++i)
    {
      // From a plane to the next, so that rounding does not add up.
      plane += this->Gap(i) > this->Least ? parts[gap++] : 0.0;
      if (!(plane < MostPlanes(static_cast<double>(parts.size()))))
      {
        grid.Problem = "the distance of its planes is too small for its frames";
        return;
      }
      grid.PlaneOf[this->Order[i]] = static_cast<std::int64_t>(plane);
    }
    grid.Planes = static_cast<std::int64_t>(plane) + 1;
    grid.PlanesWithoutFrames = grid.Planes - 1 - static_cast<std::int64_t>(parts.size());
    const double height = this->Height(this->Order.back()) - this->Height(this->Order.front());
    grid.Geometry.Origin = this->Frames[this->Order.front()].Position;
    grid.Geometry.Steps[2] = Scaled(this->Normal, plane > 0.0 ? height / plane : distance);
  }

  /// Planes lie above each other, or, of a tilted gantry, in line from the first to the last one.
  void TakeDirection(FrameGrid& grid) const
  {
    grid.Problem = this->LineProblem(grid);
    if (!grid.Problem.empty() && grid.Planes > 1)
    {
      FrameGrid sheared = grid;
      const Vector3 way = Difference(
        this->Frames[this->Order.back()].Position, this->Frames[this->Order.front()].Position);
      sheared.Geometry.Steps[2] = Scaled(way, 1.0 / static_cast<double>(grid.Planes - 1));
      sheared.Problem = this->LineProblem(sheared);
      grid = sheared.Problem.empty() ? sheared : grid;
    }
  }

  std::string LineProblem(const FrameGrid& grid) const
  {
    const Vector3& step = grid.Geometry.Steps[2];
    const double largest = LargestShift *
      std::min(PixelSide(this->Frames.front()), Length(step) * LeastDistance(grid.Layers));
    for (std::size_t i = 0; i < this->Frames.size(); ++i)
    {
      const double layer = grid.Layers.empty()
        ? static_cast<double>(grid.PlaneOf[i])
        : grid.Layers[static_cast<std::size_t>(grid.PlaneOf[i])];
      const Vector3 expected = Sum(grid.Geometry.Origin, Scaled(step, layer));
      if (!(Length(Difference(this->Frames[i].Position, expected)) <= largest))
      {
        return "its planes are not evenly spaced or not above each other: frame " +
          std::to_string(i + 1) + " of " + std::to_string(this->Frames.size()) + " is out of line";
      }
    }
    return std::string();
  }

  const std::vector<FramePlacement>& Frames;
  Vector3 Normal;
  std::vector<std::size_t> Order;
  double Least;
  std::vector<double> Gaps; ///< Between neighboring planes with frames; ascending.
};
}

FrameGrid GridOfFrames(const std::vector<FramePlacement>& frames, double planeDistance,
  const std::array<std::int64_t, 2>& size)
{
  const FramePlacement& first = frames.front();
  FrameGrid grid;
  grid.Problem = PlacementProblem(first, size);
  grid.Problem = grid.Problem.empty() ? DifferenceProblem(frames) : grid.Problem;
  if (!grid.Problem.empty())
  {
    return grid;
  }
  const Vector3 alongRow = Scaled(first.AlongRow, 1.0 / Length(first.AlongRow));
  const Vector3 turned =
    Difference(first.AlongColumn, Scaled(alongRow, Dot(first.AlongColumn, alongRow)));
  const Vector3 alongColumn = Scaled(turned, 1.0 / Length(turned));
  grid.Geometry.Steps[0] = Scaled(alongRow, first.ColumnDistance);
  grid.Geometry.Steps[1] = Scaled(alongColumn, first.RowDistance);
  const Vector3 normal = Cross(alongRow, alongColumn);
  const Stack stack(frames, normal);
  const double median = stack.MedianDistance();
  const bool isKnown = std::isfinite(planeDistance) && planeDistance > 0.0;
  if (isKnown)
  {
    stack.AssignPlanes(planeDistance, grid);
  }
  const double change = std::abs(Dot(grid.Geometry.Steps[2], normal) - planeDistance);
  const bool fits = isKnown && grid.Problem.empty() && change <= LargestChange * planeDistance;
  if (!fits && !stack.AssignUnevenPlanes(grid))
  {
    stack.AssignPlanes(median > 0.0 ? median : PixelSide(first), grid);
  }
  return grid;
}
}
