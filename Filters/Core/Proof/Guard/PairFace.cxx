// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PairFace.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool BoxesMeet(const PairFace& a, const PairFace& b, double reach)
{
  unsigned meet = 1; // without branches: most boxes are near each other
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    meet &= static_cast<unsigned>(a.Low[axis] - reach <= b.High[axis]);
    meet &= static_cast<unsigned>(b.Low[axis] - reach <= a.High[axis]);
  }
  return meet != 0;
}

void FindWritten(PairFace& face, const WrittenPositions& written)
{
  if (!face.Written)
  {
    const TriangleCorners& local = face.Corners;
    face.Written.emplace(TriangleCorners{ written.Of(face.Vertices[0], local[0]),
      written.Of(face.Vertices[1], local[1]), written.Of(face.Vertices[2], local[2]) });
  }
}

}

bool Meet(PairFace& a, PairFace& b, const WrittenPositions& written)
{
  if (!BoxesMeet(a, b, written.Rounding()))
  {
    return false;
  }
  FindWritten(a, written);
  FindWritten(b, written);
  return bonedecimate::Meet(*a.Written, a.Vertices, *b.Written, b.Vertices);
}

namespace
{
/// Counts of intersecting pairs.
struct Meetings
{
  std::size_t Pairs = 0;
  std::size_t PiercingPairs = 0;
  std::size_t PairsOfFragments = 0; // different ones

  bool ExceedAny(const Meetings& other) const
  {
    return this->Pairs > other.Pairs || this->PiercingPairs > other.PiercingPairs ||
      this->PairsOfFragments > other.PairsOfFragments;
  }
};

/// Counts the intersecting pairs of a patch with near faces and within it.
/// @param isEnough Called after each pair with the counts so far; true ends the count.
template <typename IsEnough>
void CountMeetings(std::vector<PairFace>& patch, std::vector<PairFace>& near,
  const WrittenPositions& written, const IsEnough& isEnough)
{
  Meetings count;
  for (auto face = patch.begin(); face != patch.end(); ++face)
  {
    const auto endsIt = [&](PairFace& other)
    {
      if (!Meet(*face, other, written))
      {
        return false;
      }
      ++count.Pairs;
      count.PiercingPairs += Pierce(*face->Written, *other.Written) ? 1 : 0;
      count.PairsOfFragments += face->Fragment != other.Fragment ? 1 : 0;
      return isEnough(count);
    };
    if (std::any_of(near.begin(), near.end(), endsIt) || std::any_of(face + 1, patch.end(), endsIt))
    {
      return;
    }
  }
}

/// Whether a point lies in the volume that two patches with one rim enclose.
enum class Between
{
  No,
  Yes,
  Unclear
};

/// @param size mm, longer than the diagonal of the box around both.
Between IsBetween(
  const Vector3& p, double size, const std::vector<PairFace>& a, const std::vector<PairFace>& b)
{
  // Directions along which modeled geometry is hardly ever aligned.
  for (const Vector3& direction : { Vector3(0.61, 0.53, 0.587), Vector3(-0.37, 0.71, -0.599) })
  {
    const Vector3 farPoint = p + 2.0 * size * direction;
    bool isInside = false;
    bool isClear = true;
    for (const std::vector<PairFace>* patch : { &a, &b })
    {
      for (const PairFace& face : *patch)
      {
        const RayResult result = ShootRay(p, farPoint, face);
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

/// An exact test; such patches enclose nothing.
bool LieInOnePlane(const std::vector<PairFace>& a, const std::vector<PairFace>& b)
{
  const OrientedPlane& plane = a[0].Plane;
  const auto isInPlane = [&plane](const PairFace& face)
  {
    return std::all_of(face.Corners.begin(), face.Corners.end(),
      [&plane](const Vector3& p) { return plane.SideOf(p) == 0; });
  };
  return HasArea(a[0].Corners) && std::all_of(b.begin(), b.end(), isInPlane) &&
    std::all_of(a.begin(), a.end(), isInPlane);
}
}

PairFace::PairFace(
  const HalfEdgeMesh& mesh, const Triangle& vertices, const TriangleCorners& corners)
  : PlaneTriangle(corners)
  , Vertices{ mesh.OriginalVertex(vertices[0]), mesh.OriginalVertex(vertices[1]),
    mesh.OriginalVertex(vertices[2]) }
  , Low(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]))
  , High(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]))
{
}

//------------------------------------------------------------------------------
/// mm^2, between the boxes.
double SquaredDistance(const PairFace& a, const PairFace& b)
{
  return (a.Low - b.High).cwiseMax(b.Low - a.High).cwiseMax(0.0).squaredNorm();
}

//------------------------------------------------------------------------------
Vector3 MinOf(const std::vector<PairFace>& faces)
{
  Vector3 low = faces[0].Low;
  for (const PairFace& face : faces)
  {
    low = low.cwiseMin(face.Low);
  }
  return low;
}
//------------------------------------------------------------------------------
Vector3 MaxOf(const std::vector<PairFace>& faces)
{
  Vector3 high = faces[0].High;
  for (const PairFace& face : faces)
  {
    high = high.cwiseMax(face.High);
  }
  return high;
}

//------------------------------------------------------------------------------
bool MeetMore(std::vector<PairFace>& before, std::vector<PairFace>& after,
  std::vector<PairFace>& near, const WrittenPositions& written)
{
  Meetings allowed;
  bool isMore = false;
  CountMeetings(after, near, written,
    [&](const Meetings& count)
    {
      if (count.Pairs == 1) // the count before is rarely needed
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
/// A face that meets neither the old nor the new faces lies between them as a whole or not at all.
/// So one corner that does not lie on them decides.
bool JumpOver(const std::vector<PairFace>& before, const std::vector<PairFace>& after,
  const std::vector<PairFace>& left)
{
  const Vector3 low = MinOf(before).cwiseMin(MinOf(after));
  const Vector3 high = MaxOf(before).cwiseMax(MaxOf(after));
  const double size = (high - low).sum();
  const auto isOfPatch = [&](Index vertex)
  {
    return std::any_of(before.begin(), before.end(),
      [&](const PairFace& old) { return HasCorner(old.Vertices, vertex); });
  };
  const auto isBetween = [&](const PairFace& face)
  {
    Between found = Between::No;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector3& p = face.Corners[i];
      if (!isOfPatch(face.Vertices[i]))
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
