// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Below this reduction a triangle gets three samples: faces with fewer than about eight samples
/// are overfitted.
constexpr Index ManyTriangles = 12;
/// Fraction of the area of a triangle that its inner samples represent; its corners represent the
/// rest.
constexpr double AreaRatioOfOne = 0.75; // with the corners exact for quadratic functions
constexpr double AreaRatioOfThree = 0.9;
/// A sample farther away than this multiple of the root mean square may be on the wrong side of a
/// thin part.
constexpr double FarAway = 2.0;

std::array<float, 3> Single(const Vector3& p)
{
  return { static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()) };
}

double AreaOf(const HalfEdgeMesh& mesh, FaceId face)
{
  const Triangle c = mesh.Corners(face);
  return AreaVector(mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2])).norm();
}
}

Samples::Samples(
  const HalfEdgeMesh& original, bool mayBeThree, std::vector<float> limits, double shapeWeight)
  : OriginalMesh(original)
  , Unit(original.Unit())
  , MayBeThree(mayBeThree)
  , Limits(std::move(limits))
  , FirstSamples(static_cast<std::size_t>(original.NumberOfFaceSlots()), None)
{
  this->Means.ShapeWeight = shapeWeight;
  float largest = 0.0F;
  for (const float limit : this->Limits)
  {
    largest = std::isfinite(limit) ? std::max(largest, limit) : largest;
  }
  // Not below the limit in double precision.
  this->MaxFiniteLimit = std::nextafter(largest, std::numeric_limits<float>::infinity());
}

//------------------------------------------------------------------------------
/// Samples 0 to n - 1 are the vertices. Then follow those inside triangles: the centroid, or three
/// points half way from it to the corners.
Vector3 Samples::PositionOf(Index id) const
{
  if (id < this->OriginalMesh.NumberOfVertexSlots())
  {
    return this->OriginalMesh.Position(id);
  }
  const Triangle c = this->OriginalMesh.Corners(this->TriangleOf(id));
  const Vector3 middle = (this->OriginalMesh.Position(c[0]) + this->OriginalMesh.Position(c[1]) +
                           this->OriginalMesh.Position(c[2])) /
    3.0;
  const Index which = (id - this->OriginalMesh.NumberOfVertexSlots()) % this->PerFace;
  return this->PerFace == 1 ? middle
                            : Vector3(0.5 * (middle + this->OriginalMesh.Position(c[which])));
}

//------------------------------------------------------------------------------
/// Linear on each triangle.
float Samples::LimitOf(Index id) const
{
  if (this->Limits.empty())
  {
    return std::numeric_limits<float>::infinity();
  }
  if (id < this->OriginalMesh.NumberOfVertexSlots())
  {
    return this->Limits[id];
  }
  const Triangle c = this->OriginalMesh.Corners(this->TriangleOf(id));
  const Index which = (id - this->OriginalMesh.NumberOfVertexSlots()) % this->PerFace;
  const float middle = (this->Limits[c[0]] + this->Limits[c[1]] + this->Limits[c[2]]) / 3.0F;
  return this->PerFace == 1 ? middle : 0.5F * (middle + this->Limits[c[which]]);
}

//------------------------------------------------------------------------------
/// The area that each sample represents, in squares of the unit.
/// @param all Receives the sum.
std::vector<float> Samples::Weights(double& all) const
{
  const Index vertices = this->OriginalMesh.NumberOfVertexSlots();
  const double inside = this->PerFace == 1 ? AreaRatioOfOne : AreaRatioOfThree;
  std::vector<float> weights(this->FacesOfSamples.size(), 0.0F);
  all = 0.0;
  for (Index face = 0; face < this->OriginalMesh.NumberOfFaceSlots(); ++face)
  {
    const double area = AreaOf(this->OriginalMesh, face) / (this->Unit * this->Unit);
    all += area;
    for (const Index corner : this->OriginalMesh.Corners(face))
    {
      weights[corner] += static_cast<float>((1.0 - inside) / 3.0 * area);
    }
    for (Index i = 0; i < this->PerFace; ++i)
    {
      weights[vertices + this->PerFace * face + i] =
        static_cast<float>(inside / this->PerFace * area);
    }
  }
  return weights;
}

//------------------------------------------------------------------------------
bool Samples::Distribute(
  const HalfEdgeMesh& mesh, const std::vector<Index>& current, int threads, const Monitor& monitor)
{
  const Index faces = this->OriginalMesh.NumberOfFaceSlots();
  this->PerFace = this->MayBeThree && faces / ManyTriangles < mesh.NumberOfFaces() ? 3 : 1;
  this->HasSameFaces = mesh.NumberOfFaceSlots() == faces;
  this->FirstSamples.resize(static_cast<std::size_t>(std::max(faces, mesh.NumberOfFaceSlots())));
  this->SampleList.clear();
  this->FacesOfSamples.resize(current.size() + static_cast<std::size_t>(this->PerFace) * faces);
  std::fill(this->FirstSamples.begin(), this->FirstSamples.end(), None);
  constexpr double foundAt = 0.8;
  return this->FindFaces(mesh, current, threads, PartOf(monitor, 0.0, foundAt)) &&
    this->SortByFace(mesh.NumberOfFaces(), threads, PartOf(monitor, foundAt, 1.0));
}

//------------------------------------------------------------------------------
/// Finds the faces of the vertices first: samples inside triangles start at the face of a corner.
bool Samples::FindFaces(
  const HalfEdgeMesh& mesh, const CurrentVertices& current, int threads, const Monitor& monitor)
{
  constexpr double verticesAt = 0.4;
  constexpr double allAt = 0.9;
  std::vector<float> distances(this->FacesOfSamples.size()); // squared, units
  const double perSquare = 1.0 / (this->Unit * this->Unit);
  const auto forEach = [&](std::size_t begin, std::size_t end, double from, double to, auto work)
  {
    return ForEachChunk(end - begin, threads, PartOf(monitor, from, to),
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t id = begin + first; id < begin + last; ++id)
        {
          work(static_cast<Index>(id));
        }
      });
  };
  const auto find = [&](Index id)
  {
    const PointOnMesh near = this->FindNear(mesh, current, id);
    this->FacesOfSamples[id] = near.Face;
    distances[id] = static_cast<float>(perSquare * near.Point.SquaredDistance);
  };
  if (!forEach(0, current.size(), 0.0, verticesAt, find) ||
    !forEach(current.size(), this->FacesOfSamples.size(), verticesAt, allAt, find))
  {
    return false;
  }
  const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
  this->Means.Distance = this->Unit * std::sqrt(sum / static_cast<double>(distances.size()));
  const double far = FarAway * FarAway * sum / static_cast<double>(distances.size());
  return forEach(0, this->FacesOfSamples.size(), allAt, 1.0,
    [&](Index id)
    {
      if (distances[id] > far)
      {
        const PointOnMesh known = { this->FacesOfSamples[id],
          FrameOf(mesh, this->FacesOfSamples[id]).Nearest(this->PositionOf(id)) };
        this->FacesOfSamples[id] = this->FindFar(mesh, current, id, known).Face;
      }
    });
}

//------------------------------------------------------------------------------
PointOnMesh Samples::FindNear(
  const HalfEdgeMesh& mesh, const CurrentVertices& current, Index id) const
{
  if (id < this->OriginalMesh.NumberOfVertexSlots())
  {
    return WalkFromVertex(mesh, this->PositionOf(id), current[id]);
  }
  const Index triangle = this->TriangleOf(id);
  const Index start = this->HasSameFaces && mesh.IsAlive(triangle)
    ? triangle
    : this->FacesOfSamples[this->OriginalMesh.Corners(triangle)[0]];
  return WalkFrom(mesh, this->PositionOf(id), start);
}

//------------------------------------------------------------------------------
/// The best of the point found and of walks from the vertices into which neighbors or other corners
/// were merged.
PointOnMesh Samples::FindFar(const HalfEdgeMesh& mesh, const CurrentVertices& current, Index id,
  const PointOnMesh& found) const
{
  const Vector3 p = this->PositionOf(id);
  PointOnMesh best = found;
  const auto tryFan = [&](VertexId v)
  {
    const PointOnMesh other = WalkFromVertex(mesh, p, current[v]);
    best = other.Point.SquaredDistance < best.Point.SquaredDistance ? other : best;
  };
  if (id >= this->OriginalMesh.NumberOfVertexSlots())
  {
    const Triangle corners = this->OriginalMesh.Corners(this->TriangleOf(id));
    tryFan(corners[1]);
    tryFan(corners[2]);
  }
  else if (this->OriginalMesh.Constraint(id) != VertexConstraint::NonManifold)
  {
    this->OriginalMesh.VisitEdges(
      id, [&](HalfEdgeId h) { tryFan(this->OriginalMesh.OtherEnd(h, id)); });
  }
  return best;
}

//------------------------------------------------------------------------------
/// Stores the samples sorted by face.
/// @param faces Number of faces.
bool Samples::SortByFace(Index faces, int threads, const Monitor& monitor)
{
  for (const Index face : this->FacesOfSamples)
  {
    this->FirstSamples[face] += this->FirstSamples[face] == None ? 2 : 1; // None is -1
  }
  Index end = 0;
  for (Index& count : this->FirstSamples)
  {
    if (count != None)
    {
      end += count;
      count = end;
    }
  }
  for (Index id = static_cast<Index>(this->FacesOfSamples.size()); id-- > 0;)
  {
    this->FacesOfSamples[id] =
      --this->FirstSamples[this->FacesOfSamples[id]]; // becomes the index of the sample
  }
  double area = 0.0;
  const std::vector<float> weights = this->Weights(area);
  this->Means.FaceArea = area / faces;
  this->SampleList.resize(this->FacesOfSamples.size());
  const bool done = ForEachChunk(this->SampleList.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (Index id = static_cast<Index>(first); id < static_cast<Index>(last); ++id)
      {
        const Index at = this->FacesOfSamples[id];
        this->SampleList[at] = { Single(this->PositionOf(id) / this->Unit), weights[id],
          this->LimitOf(id), at + 1 };
      }
    });
  // Each list ends before the next one begins.
  for (const Index first : this->FirstSamples)
  {
    if (first > 0)
    {
      this->SampleList[first - 1].Next = None;
    }
  }
  if (!this->SampleList.empty())
  {
    this->SampleList.back().Next = None;
  }
  return done;
}

//------------------------------------------------------------------------------
bool Samples::Settle(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor)
{
  const bool done = ForEachChunk(this->FirstSamples.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (Index face = static_cast<Index>(first); face < static_cast<Index>(last); ++face)
      {
        if (this->FirstSamples[face] == None)
        {
          continue;
        }
        const TriangleFrame frame = FrameOf(mesh, face);
        for (Index s = this->FirstSamples[face]; s != None; s = this->SampleList[s].Next)
        {
          const Vector3 p = this->SamplePosition(this->SampleList[s]);
          const TriangleFrame::Point point = frame.Nearest(p);
          const bool stays = point.Clamped == 0 && frame.EdgesNearby(point) == 0;
          this->FacesOfSamples[s] = stays ? face : WalkOn(mesh, p, { face, point }).Face;
        }
      }
    });
  if (done)
  {
    std::fill(this->FirstSamples.begin(), this->FirstSamples.end(), None);
    for (Index s = this->Count(); s-- > 0;)
    {
      this->Put(s, this->FacesOfSamples[s]);
    }
  }
  return done;
}
}
