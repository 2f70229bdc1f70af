// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Piece.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool BoxesMeet(const Piece& a, const Piece& b, double reach)
{
  unsigned meet = 1; // without branches: most boxes are near each other
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    meet &= static_cast<unsigned>(a.Low[axis] - reach <= b.High[axis]);
    meet &= static_cast<unsigned>(b.Low[axis] - reach <= a.High[axis]);
  }
  return meet != 0;
}

bool HasCorner(const Piece& piece, Index vertex)
{
  const Triangle& own = piece.Vertices;
  return own[0] == vertex || own[1] == vertex || own[2] == vertex;
}

/// The number of the first corner for which that is so.
std::size_t FindCorner(const Piece& piece, const Piece& other, bool isShared)
{
  std::size_t i = 0;
  while (i < 2 && HasCorner(other, piece.Vertices[i]) != isShared)
  {
    ++i;
  }
  return i;
}

void FindWritten(Piece& piece, const WrittenPositions& written)
{
  if (!piece.Written)
  {
    const TriangleCorners& local = piece.Corners;
    piece.Written.emplace(TriangleCorners{ written.Of(piece.Vertices[0], local[0]),
      written.Of(piece.Vertices[1], local[1]), written.Of(piece.Vertices[2], local[2]) });
  }
}

}

bool Meet(Piece& a, Piece& b, const WrittenPositions& written)
{
  if (!BoxesMeet(a, b, written.Rounding()))
  {
    return false;
  }
  FindWritten(a, written);
  FindWritten(b, written);
  switch (CountShared(a, b))
  {
    case 0:
      return bonedecimate::Meet(*a.Written, *b.Written);
    case 1:
      return MeetBeyondCorner(
        *a.Written, FindCorner(a, b, true), *b.Written, FindCorner(b, a, true));
    case 2:
      return MeetBeyondEdge(
        *a.Written, FindCorner(a, b, false), b.Written->Corners[FindCorner(b, a, false)]);
    default:
      return true;
  }
}

namespace
{
/// Pairs that meet.
struct Meetings
{
  std::size_t All = 0;
  std::size_t Piercing = 0;
  std::size_t Apart = 0; // of two fragments

  bool ExceedAny(const Meetings& other) const
  {
    return this->All > other.All || this->Piercing > other.Piercing || this->Apart > other.Apart;
  }
};

/// Pairs of a patch with what is near it, and within it, that meet.
/// @param isEnough Requested after each with how many they are by then; true ends it.
template <typename IsEnough>
void CountMeetings(std::vector<Piece>& patch, std::vector<Piece>& near,
  const WrittenPositions& written, const IsEnough& isEnough)
{
  Meetings count;
  for (auto piece = patch.begin(); piece != patch.end(); ++piece)
  {
    const auto endsIt = [&](Piece& other)
    {
      if (!Meet(*piece, other, written))
      {
        return false;
      }
      ++count.All;
      count.Piercing += Pierce(*piece->Written, *other.Written) ? 1 : 0;
      count.Apart += piece->Fragment != other.Fragment ? 1 : 0;
      return isEnough(count);
    };
    if (std::any_of(near.begin(), near.end(), endsIt) ||
      std::any_of(piece + 1, patch.end(), endsIt))
    {
      return;
    }
  }
}

/// Where a point lies to the volume that two patches with one rim enclose.
enum class Between
{
  No,
  Yes,
  Unclear
};

/// @param size mm, longer than the box around both.
Between IsBetween(
  const Vector3& p, double size, const std::vector<Piece>& a, const std::vector<Piece>& b)
{
  // Directions that no modeled geometry is aligned with.
  for (const Vector3& direction : { Vector3(0.61, 0.53, 0.587), Vector3(-0.37, 0.71, -0.599) })
  {
    const Vector3 farPoint = p + 2.0 * size * direction;
    bool isInside = false;
    bool isClear = true;
    for (const std::vector<Piece>* patch : { &a, &b })
    {
      for (const Piece& piece : *patch)
      {
        const RayResult result = ShootRay(p, farPoint, piece);
        isInside = isInside != (result == RayResult::Hits);
        isClear = isClear && result != RayResult::Unclear;
      }
    }
    if (isClear)
    {
      return isInside ? Between::Yes : Between::No;
    }
  }
  return Between::Unclear;
}

/// Exactly: then they enclose nothing.
bool LieInOnePlane(const std::vector<Piece>& a, const std::vector<Piece>& b)
{
  const OrientedPlane& plane = a[0].Plane;
  const auto isInPlane = [&plane](const Piece& piece)
  {
    return std::all_of(piece.Corners.begin(), piece.Corners.end(),
      [&plane](const Vector3& p) { return plane.SideOf(p) == 0; });
  };
  return HasArea(a[0].Corners) && std::all_of(b.begin(), b.end(), isInPlane) &&
    std::all_of(a.begin(), a.end(), isInPlane);
}
}

Piece::Piece(const HalfEdgeMesh& mesh, const Triangle& vertices, const TriangleCorners& corners)
  : PlaneTriangle(corners)
  , Vertices{ mesh.OriginalVertex(vertices[0]), mesh.OriginalVertex(vertices[1]),
    mesh.OriginalVertex(vertices[2]) }
  , Low(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]))
  , High(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]))
{
}

//------------------------------------------------------------------------------
/// mm^2, between the boxes.
double SquaredDistance(const Piece& a, const Piece& b)
{
  return (a.Low - b.High).cwiseMax(b.Low - a.High).cwiseMax(0.0).squaredNorm();
}

//------------------------------------------------------------------------------
int CountShared(const Piece& a, const Piece& b)
{
  return static_cast<int>(std::count_if(
    a.Vertices.begin(), a.Vertices.end(), [&b](Index vertex) { return HasCorner(b, vertex); }));
}

//------------------------------------------------------------------------------
Vector3 MinOf(const std::vector<Piece>& pieces)
{
  Vector3 low = pieces[0].Low;
  for (const Piece& piece : pieces)
  {
    low = low.cwiseMin(piece.Low);
  }
  return low;
}
//------------------------------------------------------------------------------
Vector3 MaxOf(const std::vector<Piece>& pieces)
{
  Vector3 high = pieces[0].High;
  for (const Piece& piece : pieces)
  {
    high = high.cwiseMax(piece.High);
  }
  return high;
}

//------------------------------------------------------------------------------
bool MeetMore(std::vector<Piece>& before, std::vector<Piece>& after, std::vector<Piece>& near,
  const WrittenPositions& written)
{
  Meetings allowed;
  bool isMore = false;
  CountMeetings(after, near, written,
    [&](const Meetings& count)
    {
      if (count.All == 1) // most edits need not know
      {
        CountMeetings(before, near, written,
          [&](const Meetings& countBefore)
          {
            allowed = countBefore;
            return false;
          });
      }
      isMore = count.ExceedAny(allowed);
      return isMore;
    });
  return isMore;
}

//------------------------------------------------------------------------------
/// What meets neither the faces that go nor the new ones lies between them as a whole or not at
/// all: one corner that does not lie on them tells.
bool JumpOver(
  const std::vector<Piece>& before, const std::vector<Piece>& after, const std::vector<Piece>& left)
{
  const Vector3 low = MinOf(before).cwiseMin(MinOf(after));
  const Vector3 high = MaxOf(before).cwiseMax(MaxOf(after));
  const double size = (high - low).sum();
  const auto isOfPatch = [&](Index vertex)
  {
    return std::any_of(
      before.begin(), before.end(), [&](const Piece& old) { return HasCorner(old, vertex); });
  };
  const auto isBetween = [&](const Piece& piece)
  {
    Between found = Between::No;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector3& p = piece.Corners[i];
      if (!isOfPatch(piece.Vertices[i]))
      {
        const bool isInBox = (p - low).minCoeff() >= 0.0 && (high - p).minCoeff() >= 0.0;
        found = isInBox ? IsBetween(p, size, before, after) : Between::No;
        if (found != Between::Unclear)
        {
          break;
        }
      }
    }
    return found != Between::No;
  };
  return std::any_of(left.begin(), left.end(), isBetween) && !LieInOnePlane(before, after);
}
}
