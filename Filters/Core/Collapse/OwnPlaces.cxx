// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OwnPlaces.h"

#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bonedecimate
{
namespace
{
using Place = std::array<float, 3>; // mm

/// To the places around one: those that differ in fewer coordinates first.
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

class OwnPlaces
{
public:
  OwnPlaces(Editor& editor, const Surface& input, const CleanSurface& clean)
    : Work(editor)
    , Input(input)
    , Clean(clean)
  {
    this->Space.Range.Last = editor.Mesh().NumberOfVertexSlots();
  }

  std::vector<Index> Give()
  {
    std::vector<Index> later = this->FindWhoCameLater();
    if (!later.empty())
    {
      this->Work.ShareVolumes();
      this->Work.BeginSmallEdits();
      later.erase(
        std::remove_if(later.begin(), later.end(), [this](Index v) { return this->Separate(v); }),
        later.end());
      this->Work.EndSmallEdits();
      this->Work.ShareVolumes();
    }
    return later;
  }

private:
  /// Those that cannot move come first.
  std::vector<Index> FindWhoCameLater()
  {
    const HalfEdgeMesh& mesh = this->Work.Mesh();
    std::vector<Index> later;
    for (const bool stays : { true, false })
    {
      for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
      {
        if (mesh.Outgoing(v) != None && (mesh.IsFixed(v) || mesh.IsPinned(v)) == stays)
        {
          const auto [first, isFree] = this->Taken.emplace(this->PlaceOf(v), v);
          if (!isFree && mesh.Site(first->second) != mesh.Site(v))
          {
            later.push_back(v);
          }
        }
      }
    }
    return later;
  }

  /// Where it will be when it has been written.
  Place PlaceOf(Index v) const
  {
    const Vector3 p =
      OutputPosition(this->Input, this->Clean, v, this->Work.Mesh().Position(v), true);
    return { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) };
  }

  /// Itself, or else who was there first.
  bool Separate(Index v)
  {
    Index& owner = this->Taken.find(this->PlaceOf(v))->second;
    if (this->MoveAway(v))
    {
      return true;
    }
    const bool moved = this->MoveAway(owner);
    owner = moved ? v : owner;
    return moved;
  }

  bool MoveAway(Index v)
  {
    static const std::vector<std::array<int, 3>> steps = StepsAround();
    const Place from = this->PlaceOf(v);
    return std::any_of(steps.begin(), steps.end(),
      [&](const std::array<int, 3>& step)
      {
        Place to = from;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const float far = std::numeric_limits<float>::infinity();
          to[k] = step[k] == 0 ? from[k] : std::nextafter(from[k], step[k] < 0 ? -far : far);
        }
        const bool moved = this->Taken.count(to) == 0 && this->Move(v, to);
        return moved && this->Taken.emplace(to, v).second;
      });
  }

  bool Move(Index v, const Place& to)
  {
    Edit edit;
    edit.Kind = EditKind::Move;
    edit.Keep = v;
    edit.Position = Vector3(to[0], to[1], to[2]) - this->Clean.Origin;
    return this->Work.ApplySmall(edit, this->Space, 1) == Verdict::Allowed;
  }

  Editor& Work;
  const Surface& Input;
  const CleanSurface& Clean;
  std::map<Place, Index> Taken; // by the first vertex there
  Workspace Space;
};
}

InputStatus GiveOwnPlaces(
  Editor& editor, const Surface& input, const CleanSurface& clean, CleaningStatistics& found)
{
  const std::vector<Index> left = OwnPlaces(editor, input, clean).Give();
  if (left.empty())
  {
    return InputStatus::Good;
  }
  found.MeetingPoints = static_cast<std::int64_t>(left.size());
  found.FirstCoarsePoint = clean.InputPoint[left.front()];
  return InputStatus::SinglePrecisionTooCoarse;
}
}
