// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OverlayCover.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate::certificate
{
namespace
{
/// Least height of T over the longer of its sides at the first corner, as a ratio of the side.
constexpr double MinHeight = 3e-2;
/// Least cosine of the angle between the direction of projection and the normal of T. If it were
/// smaller, the normal is used.
constexpr double MinCosine = 0.5;
/// With more triangles over T, cutting T is faster.
constexpr std::size_t MaxTriangles = 4096;
/// With more corners of parts that are far, all of T is covered in another way.
constexpr std::size_t MaxFarCorners = 60;
/// Relative error of a predicate and of the clipped coordinates, about 90 u.
constexpr double PredicateError = 1e-14;
constexpr double ClipMargin = 1e-14;
/// The test position, at which images are counted; any position off the images of the edges is
/// valid.
constexpr double CountedB = 0.3279;
constexpr double CountedC = 0.3391;

/// The signed area coordinate that is negative beyond this side of T.
template <typename Coordinates>
double Inside(const Coordinates& at, int side)
{
  return side == 0 ? at.B : side == 1 ? at.C : 1.0 - at.B - at.C;
}

struct Position2
{
  double B, C;
};

/// 1: p, q, r turn counterclockwise; -1: clockwise; 0: unknown because of rounding.
template <typename P, typename Q>
int Orientation(const P& p, const Q& q, Position2 r)
{
  const double left = (q.B - p.B) * (r.C - p.C);
  const double right = (q.C - p.C) * (r.B - p.B);
  const double error = PredicateError *
    ((std::abs(q.B) + std::abs(p.B)) * (std::abs(r.C) + std::abs(p.C)) +
      (std::abs(q.C) + std::abs(p.C)) * (std::abs(r.B) + std::abs(p.B)));
  return left - right > error ? 1 : left - right < -error ? -1 : 0;
}

/// Whether the line through both images may meet T.
template <typename P>
bool PassesTriangle(const P& p, const P& q)
{
  const int first = Orientation(p, q, { 0.0, 0.0 });
  return first == 0 || Orientation(p, q, { 1.0, 0.0 }) != first ||
    Orientation(p, q, { 0.0, 1.0 }) != first;
}
}

//------------------------------------------------------------------------------
OverlayCover::OverlayCover(const Simplices& surface)
  : Surface(surface)
  , Sides(*surface.Sides)
  , TriangleStamps(surface.Size(), 0)
  , PointStamps(surface.Points.size(), 0)
  , ImageIndices(surface.Points.size(), 0)
{
}

//------------------------------------------------------------------------------
bool OverlayCover::Find(const Corners& triangle, const Triangle& seeds, double limit)
{
  this->VisitedTriangles.clear();
  this->PartsTooFar.clear();
  this->FarCorners = 0;
  this->UpperOfNear = 0.0;
  this->NextStamp();
  for (const Index seed : seeds)
  {
    this->Add(seed);
  }
  if (!this->Begin(triangle, seeds))
  {
    return false;
  }
  for (std::size_t at = 0; at < this->VisitedTriangles.size(); ++at)
  {
    if (at == MaxTriangles || this->FarCorners > MaxFarCorners ||
      !this->Visit(this->VisitedTriangles[at], limit))
    {
      return false;
    }
  }
  return this->IsOdd;
}

//------------------------------------------------------------------------------
void OverlayCover::NextStamp()
{
  if (++this->Stamp == 0)
  {
    std::fill(this->TriangleStamps.begin(), this->TriangleStamps.end(), 0);
    std::fill(this->PointStamps.begin(), this->PointStamps.end(), 0);
    this->Stamp = 1;
  }
}

//------------------------------------------------------------------------------
void OverlayCover::Add(Index triangle)
{
  if (this->TriangleStamps[triangle] != this->Stamp)
  {
    this->TriangleStamps[triangle] = this->Stamp;
    this->VisitedTriangles.push_back(triangle);
  }
}

//------------------------------------------------------------------------------
/// A vector of length 1.
Vector3 OverlayCover::Normal(Index triangle) const
{
  const auto& [a, b, c] = this->Surface.Corners[triangle];
  const std::vector<Vector3>& points = this->Surface.Points;
  return AreaVector(points[a], points[b], points[c]).normalized();
}

//------------------------------------------------------------------------------
/// False if the triangle is a needle.
bool OverlayCover::Begin(const Corners& triangle, const Triangle& seeds)
{
  this->Images.clear();
  this->IsOdd = false;
  this->A = triangle[0];
  this->AB = triangle[1] - triangle[0];
  this->AC = triangle[2] - triangle[0];
  const double bb = this->AB.squaredNorm();
  const double bc = Dot(this->AB, this->AC);
  const double cc = this->AC.squaredNorm();
  const double determinant = bb * cc - bc * bc;
  const double longer = std::max(bb, cc); // squared
  if (!(determinant > MinHeight * MinHeight * longer * longer))
  {
    return false;
  }
  this->TowardB = (cc * this->AB - bc * this->AC) / determinant;
  this->TowardC = (bb * this->AC - bc * this->AB) / determinant;
  this->Incline(this->Normal(seeds[0]) + this->Normal(seeds[1]) + this->Normal(seeds[2]));
  return true;
}

//------------------------------------------------------------------------------
/// Sets the direction of projection, unless it is too far from the normal of T.
void OverlayCover::Incline(const Vector3& direction)
{
  const Vector3 normal = this->AB.cross(this->AC).normalized();
  const double cosine = Dot(normal, direction);
  if (cosine * cosine > MinCosine * MinCosine * direction.squaredNorm())
  {
    this->TowardB -= Dot(this->TowardB, direction) / cosine * normal;
    this->TowardC -= Dot(this->TowardC, direction) / cosine * normal;
  }
}

//------------------------------------------------------------------------------
/// The index of the point's image in Images.
Index OverlayCover::ImageOf(Index point)
{
  if (this->PointStamps[point] != this->Stamp)
  {
    KnownImage image;
    image.At.Point = this->Surface.Points[point];
    image.At.B = Dot(this->TowardB, image.At.Point - this->A);
    image.At.C = Dot(this->TowardC, image.At.Point - this->A);
    const double error = PredicateError * (1.0 + std::abs(image.At.B) + std::abs(image.At.C));
    image.Beyond = static_cast<std::uint8_t>((image.At.B < 0.0 ? 1 : 0) |
      (image.At.C < 0.0 ? 2 : 0) | (Inside(image.At, 2) < -error ? 4 : 0));
    this->PointStamps[point] = this->Stamp;
    this->ImageIndices[point] = static_cast<Index>(this->Images.size());
    this->Images.push_back(image);
  }
  return this->ImageIndices[point];
}

//------------------------------------------------------------------------------
/// False if the surface may end over T.
bool OverlayCover::Visit(Index triangle, double limit)
{
  const Triangle& corners = this->Surface.Corners[triangle];
  const Triangle ids = { this->ImageOf(corners[0]), this->ImageOf(corners[1]),
    this->ImageOf(corners[2]) };
  const ImageTriangle images = { &this->Images[ids[0]], &this->Images[ids[1]],
    &this->Images[ids[2]] };
  if ((images[0]->Beyond & images[1]->Beyond & images[2]->Beyond) != 0)
  {
    return true; // its image does not meet T
  }
  this->Measure(images, triangle, limit);
  return this->CountLayer(images) && this->CrossEdges(images, triangle);
}

//------------------------------------------------------------------------------
/// Counts the image if it contains the test position. False if that cannot be decided.
bool OverlayCover::CountLayer(const ImageTriangle& images)
{
  const auto& [p, q, r] = images;
  const auto [lowB, highB] = std::minmax({ p->At.B, q->At.B, r->At.B });
  const auto [lowC, highC] = std::minmax({ p->At.C, q->At.C, r->At.C });
  if (lowB > CountedB || highB < CountedB || lowC > CountedC || highC < CountedC)
  {
    return true;
  }
  int turns = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int turn = Orientation(images[k]->At, images[(k + 1) % 3]->At, { CountedB, CountedC });
    if (turn == 0)
    {
      return false;
    }
    turns += turn;
  }
  this->IsOdd = this->IsOdd != (std::abs(turns) == 3);
  return true;
}

//------------------------------------------------------------------------------
/// Adds the neighbors across edges that meet T. False if an edge does not have exactly one.
bool OverlayCover::CrossEdges(const ImageTriangle& images, Index triangle)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const KnownImage& p = *images[k];
    const KnownImage& q = *images[(k + 1) % 3];
    const bool meets =
      (p.Beyond & q.Beyond) == 0 && (p.Beyond == 0 || q.Beyond == 0 || PassesTriangle(p.At, q.At));
    if (!meets)
    {
      continue;
    }
    const Index next = this->Sides[triangle][k];
    if (next < 0)
    {
      return false;
    }
    this->Add(next);
  }
  return true;
}

//------------------------------------------------------------------------------
/// The part of a polygon on the inner side of a side of T, widened by the margin.
void OverlayCover::Clip(const Polygon& polygon, int side, double margin, Polygon& kept)
{
  kept.Count = 0;
  for (std::size_t i = 0; i < polygon.Count; ++i)
  {
    const Image& p = polygon.Corners[i];
    const Image& q = polygon.Corners[(i + 1) % polygon.Count];
    const double ofP = Inside(p, side) + margin;
    const double ofQ = Inside(q, side) + margin;
    if (ofP >= 0.0)
    {
      kept.Corners[kept.Count++] = p;
    }
    if ((ofP >= 0.0) != (ofQ >= 0.0))
    {
      const double t = ofP / (ofP - ofQ);
      kept.Corners[kept.Count++] = { p.Point + t * (q.Point - p.Point), p.B + t * (q.B - p.B),
        p.C + t * (q.C - p.C) };
    }
  }
}

//------------------------------------------------------------------------------
/// The bound of the overlay of T and an image is the largest distance at a corner.
void OverlayCover::Measure(const ImageTriangle& images, Index triangle, double limit)
{
  Polygon first, second;
  Polygon* kept = &first;
  Polygon* next = &second;
  double largest = 1.0;
  kept->Count = 0;
  for (const KnownImage* corner : images)
  {
    kept->Corners[kept->Count++] = corner->At;
    largest = std::max({ largest, std::abs(corner->At.B), std::abs(corner->At.C) });
  }
  const int beyond = images[0]->Beyond | images[1]->Beyond | images[2]->Beyond;
  for (int side = 0; side < 3; ++side)
  {
    if ((beyond & (1 << side)) != 0)
    {
      Clip(*kept, side, ClipMargin * largest, *next);
      std::swap(kept, next);
    }
  }
  double squared = 0.0; // mm^2
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < kept->Count; ++i)
  {
    const Image& at = kept->Corners[i];
    const double here = (this->InPlane(at) - at.Point).squaredNorm();
    farthest = here > squared ? i : farthest;
    squared = std::max(squared, here);
  }
  const double upper = std::sqrt(squared);
  if (upper <= limit)
  {
    this->UpperOfNear = std::max(this->UpperOfNear, upper);
    return;
  }
  Part& part = this->PartsTooFar.emplace_back();
  for (; part.Count < kept->Count; ++part.Count)
  {
    part.Corners[part.Count] = this->InPlane(kept->Corners[part.Count]);
  }
  part.Farthest = farthest;
  part.Upper = upper;
  part.Nearest = triangle;
  this->FarCorners += part.Count;
}
}
