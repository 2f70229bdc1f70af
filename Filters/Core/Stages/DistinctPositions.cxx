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
using RoundedPosition = std::array<float, 3>; // mm

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
  steps.erase(steps.begin()); // where it is
  return steps;
}

class DistinctPositions
{
public:
  DistinctPositions(Editor& editor, const Surface& input, const CleanSurface& clean)
    : MeshEditor(editor)
    , Input(input)
    , Clean(clean)
  {
    this->Space.Range.Last = editor.Mesh().NumberOfVertexSlots();
  }

  std::vector<Index> Give()
  {
    std::vector<Index> later = this->FindCoincident();
    if (!later.empty())
    {
      this->MeshEditor.DistributeVolumeBudget();
      this->MeshEditor.BeginFlipsAndMoves();
      later.erase(std::remove_if(
                    later.begin(), later.end(), [this](VertexId v) { return this->Separate(v); }),
        later.end());
      this->MeshEditor.EndFlipsAndMoves();
      this->MeshEditor.DistributeVolumeBudget();
    }
    return later;
  }

private:
  /// Vertices whose rounded position is already taken. Vertices that cannot move take their position first.
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
    const Vector3 p =
      OutputPosition(this->Input, this->Clean, v, this->MeshEditor.Mesh().Position(v), true);
    return { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) };
  }

  /// Moves the vertex or, if that is rejected, the vertex that took the position first.
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
        RoundedPosition to = from;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const float far = std::numeric_limits<float>::infinity();
          to[k] = step[k] == 0 ? from[k] : std::nextafter(from[k], step[k] < 0 ? -far : far);
        }
        const bool moved = this->Taken.count(to) == 0 && this->Move(v, to);
        return moved && this->Taken.emplace(to, v).second;
      });
  }

  bool Move(VertexId v, const RoundedPosition& to)
  {
    const Vector3 position = Vector3(to[0], to[1], to[2]) - this->Clean.Origin;
    return this->MeshEditor.Move(v, position, this->Space, 1).IsAccepted();
  }

  Editor& MeshEditor;
  const Surface& Input;
  const CleanSurface& Clean;
  std::map<RoundedPosition, VertexId> Taken; // by the first vertex there
  Workspace Space;
};
}

InputStatus SeparateCoincidentPoints(
  Editor& editor, const Surface& input, const CleanSurface& clean, CleaningStatistics& found)
{
  const std::vector<Index> left = DistinctPositions(editor, input, clean).Give();
  if (left.empty())
  {
    return InputStatus::Good;
  }
  found.MeetingPoints = static_cast<std::int64_t>(left.size());
  found.FirstCoarsePoint = clean.InputPoint[left.front()];
  return InputStatus::SinglePrecisionTooCoarse;
}
}
