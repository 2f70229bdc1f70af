// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistinctPositions.h"

#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bonedecimate
{
namespace
{
using RoundedPosition = std::array<double, 3>; // mm

/// Steps to the neighboring positions; those that differ in fewer coordinates come first.
std::vector<std::array<int, 3>> StepsAround()
{
  std::vector<std::array<int, 3>> steps;
  steps.reserve(27);
  for (int i = 0; i < 27; ++i)
  {
    steps.push_back({ i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 });
  }
  const auto length = [](const std::array<int, 3>& s)
  { return std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]); };
  std::stable_sort(steps.begin(), steps.end(),
    [&](const auto& one, const auto& other) { return length(one) < length(other); });
  steps.erase(steps.begin()); // no step
  return steps;
}

/// The nearest other coordinate, mm, that a vertex can have and that is written as another number.
/// Near 0, single precision is finer than positions relative to the local origin. Denormal numbers
/// are left out, because many programs read them as 0.
double BesideInSingle(double position, int step, double origin)
{
  const auto from = static_cast<float>(position);
  const double local = std::abs(position - origin);
  const double least = std::max<double>(
    2.0 * (std::nextafter(local, Infinity) - local), std::numeric_limits<float>::min());
  const float next = std::nextafter(from, static_cast<float>(step * Infinity));
  return std::abs(static_cast<double>(next) - position) < least
    ? static_cast<float>(position + step * least)
    : next;
}

class DistinctPositions
{
public:
  DistinctPositions(
    Editor& editor, const Surface& input, const CleanSurface& clean, const PointRounding& rounding)
    : MeshEditor(editor)
    , Input(input)
    , Clean(clean)
    , Rounding(rounding)
  {
    this->Workspace.Change.Range.End = editor.Mesh().NumberOfVertexSlots();
  }

  std::vector<Index> SeparateAll()
  {
    std::vector<Index> later = this->FindCoincident();
    if (!later.empty())
    {
      this->MeshEditor.FlipAndMove(
        [&]
        {
          later.erase(std::remove_if(later.begin(), later.end(),
                        [this](VertexId v) { return this->Separate(v); }),
            later.end());
          return true;
        });
    }
    return later;
  }

private:
  /// Vertices whose rounded position is taken. Vertices that cannot move take their position first.
  std::vector<Index> FindCoincident()
  {
    const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
    std::vector<Index> later;
    for (const bool stays : { true, false })
    {
      for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
      {
        if (mesh.Outgoing(v) != None && (mesh.IsConstrained(v) || mesh.IsStationary(v)) == stays)
        {
          const auto [first, isFree] = this->Taken.emplace(this->RoundedPositionOf(v), v);
          if (!isFree && mesh.OriginalVertex(first->second) != mesh.OriginalVertex(v))
          {
            later.push_back(v);
          }
        }
      }
    }
    return later;
  }

  /// The position as it is written.
  RoundedPosition RoundedPositionOf(VertexId v) const
  {
    return this->WrittenAt(v, this->MeshEditor.Mesh().Position(v));
  }

  RoundedPosition WrittenAt(VertexId v, const Vector3& position) const
  {
    const Vector3 p = OutputPosition(this->Input, this->Clean, v, position, this->Rounding);
    return { p[0], p[1], p[2] };
  }

  /// The nearest other coordinate that is written as another number, mm.
  double Beside(double from, int step, double origin) const
  {
    return this->Rounding.HasGrid() ? from + step * this->Rounding.GridStep
                                    : BesideInSingle(from, step, origin);
  }

  /// Moves the vertex or, if this is rejected, the vertex that took the position first.
  bool Separate(VertexId v)
  {
    VertexId& owner = this->Taken.find(this->RoundedPositionOf(v))->second;
    if (this->MoveAway(v))
    {
      return true;
    }
    const bool moved = this->MoveAway(owner);
    owner = moved ? v : owner;
    return moved;
  }

  bool MoveAway(VertexId v)
  {
    static const std::vector<std::array<int, 3>> steps = StepsAround();
    const RoundedPosition from = this->RoundedPositionOf(v);
    return std::any_of(steps.begin(), steps.end(),
      [&](const std::array<int, 3>& step)
      {
        Vector3 to(from[0], from[1], from[2]);
        for (std::size_t k = 0; k < 3; ++k)
        {
          const auto axis = static_cast<Eigen::Index>(k);
          to[axis] =
            step[k] == 0 ? to[axis] : this->Beside(from[k], step[k], this->Clean.Origin[axis]);
        }
        return this->Move(v, to) && this->Taken.emplace(this->RoundedPositionOf(v), v).second;
      });
  }

  /// Moves the vertex, unless another one is written at that position.
  bool Move(VertexId v, const Vector3& to)
  {
    const Vector3 position = to - this->Clean.Origin;
    return this->Taken.count(this->WrittenAt(v, position)) == 0 &&
      this->MeshEditor.Try(MoveTo(v, position), this->Workspace).IsAccepted();
  }

  Editor& MeshEditor;
  const Surface& Input;
  const CleanSurface& Clean;
  const PointRounding& Rounding;
  std::map<RoundedPosition, VertexId> Taken; // the first vertex at each position
  EditWorkspace Workspace;
};
}

InputStatus SeparateCoincidentPoints(Editor& editor, const Surface& input,
  const CleanSurface& clean, const PointRounding& rounding, CleaningStatistics& found)
{
  const std::vector<Index> left = DistinctPositions(editor, input, clean, rounding).SeparateAll();
  if (left.empty())
  {
    return InputStatus::Good;
  }
  found.MeetingPoints = static_cast<std::int64_t>(left.size());
  found.FirstCoarsePoint = clean.InputPoint[left.front()];
  return InputStatus::RoundingTooCoarse;
}
}
