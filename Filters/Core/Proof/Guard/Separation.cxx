// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Separation.h"

#include "Base/Parallel.h"
#include "Base/WorkspacePool.h"
#include "BoxTree.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Ranges up to this length are tested together, however far apart their triangles are.
constexpr Index MaxJointRange = 4;
/// Triangles that are searched around one. If there are more, the distance of the farthest of these
/// is used as a lower bound.
constexpr std::ptrdiff_t MaxNear = 500;

/// A set of triangles that grows one by one, and whether it is a disk.
class GrowingPatch
{
public:
  explicit GrowingPatch(const HalfEdgeMesh& mesh)
    : Mesh(mesh)
    , StampOfFace(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), 0)
    , StampOfVertex(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0)
    , Position(StampOfFace.size())
  {
  }

  void Clear()
  {
    ++this->Stamp;
    this->Parents.clear();
    this->Parts = 0;
    this->Euler = 0;
  }

  void Add(FaceId face)
  {
    this->StampOfFace[face] = this->Stamp;
    this->Position[face] = this->Parents.size();
    this->Parents.push_back(this->Parents.size());
    ++this->Parts;
    this->Euler += 1 - 3;
    for (Index corner = 0; corner < 3; ++corner)
    {
      const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, corner);
      Index& ofVertex = this->StampOfVertex[this->Mesh.Origin(h)];
      this->Euler += std::exchange(ofVertex, this->Stamp) != this->Stamp ? 1 : 0;
      const HalfEdgeId twin = this->Mesh.Twin(h);
      const FaceId other = twin == None ? face : HalfEdgeMesh::Face(twin);
      if (other != face && this->StampOfFace[other] == this->Stamp)
      {
        ++this->Euler;
        this->Join(this->Position[face], this->Position[other]);
      }
    }
  }

  bool IsDisk() const { return this->Parts == 1 && this->Euler == 1; }

private:
  std::size_t RootOf(std::size_t i)
  {
    while (this->Parents[i] != i)
    {
      i = this->Parents[i] = this->Parents[this->Parents[i]];
    }
    return i;
  }
  void Join(std::size_t a, std::size_t b)
  {
    a = this->RootOf(a);
    b = this->RootOf(b);
    this->Parts -= a != b ? 1 : 0;
    this->Parents[a] = b;
  }

  const HalfEdgeMesh& Mesh;
  std::vector<Index> StampOfFace, StampOfVertex;
  std::vector<std::size_t> Position; // of each face, in the patch
  std::vector<std::size_t> Parents;
  Index Stamp = 0;
  Index Parts = 0;
  Index Euler = 0; // vertices - edges + faces
};

/// A triangle by its box.
struct BoxedFace
{
  FloatBox Box;
  FaceId Face;
};

/// mm, between two triangles along the normal of the first; at least 0. A lower bound of the
/// distance, as along any direction.
double GapAlongNormal(const TriangleCorners& a, const TriangleCorners& b)
{
  const Vector3 normal = (a[1] - a[0]).cross(a[2] - a[0]).normalized();
  const auto ends = [&](const TriangleCorners& c)
  {
    return std::minmax(
      { Dot(normal, c[0] - a[0]), Dot(normal, c[1] - a[0]), Dot(normal, c[2] - a[0]) });
  };
  const auto ofA = ends(a);
  const auto ofB = ends(b);
  return std::max({ 0.0, ofB.first - ofA.second, ofA.first - ofB.second });
}

/// Finds near triangles of a mesh.
class NearTriangles
{
public:
  NearTriangles(const HalfEdgeMesh& mesh, double limit, int threads)
    : Mesh(mesh)
    , Limit(limit)
    , Tree(Boxes(mesh, threads), threads)
  {
  }

  /// Measures the triangles of a range whose separation is below the limit. Halves a range until it
  /// is one disk with its near triangles.
  /// @param near All triangles that may be near. Null: any triangle may be.
  void Measure(Index first, Index last, const std::vector<BoxedFace>* near, GrowingPatch& patch,
    std::vector<double>& distances) const
  {
    FloatBox box;
    for (Index face = first; face < last; ++face)
    {
      box.Add(this->Tree.Box(static_cast<std::size_t>(face)));
    }
    std::vector<BoxedFace> own;
    if (near != nullptr || last - first <= MaxJointRange || box.Diagonal() <= this->Limit)
    {
      patch.Clear();
      this->Gather(box, near,
        [&](const BoxedFace& one)
        {
          own.push_back(one);
          patch.Add(one.Face);
        });
      if (patch.IsDisk())
      {
        return;
      }
      near = &own;
    }
    if (last - first == 1 && !this->Mesh.IsAlive(first))
    {
      return;
    }
    if (last - first == 1)
    {
      distances[static_cast<std::size_t>(first)] = this->DistanceFrom(first, own, patch);
      return;
    }
    const Index middle = (first + last) / 2;
    this->Measure(first, middle, near, patch, distances);
    this->Measure(middle, last, near, patch, distances);
  }

private:
  struct Neighbor
  {
    double Distance; // mm, at least
    FaceId Face;
    bool operator<(const Neighbor& other) const
    {
      return std::tie(this->Distance, this->Face) < std::tie(other.Distance, other.Face);
    }
  };

  static std::vector<FloatBox> Boxes(const HalfEdgeMesh& mesh, int threads)
  {
    std::vector<FloatBox> boxes(static_cast<std::size_t>(mesh.NumberOfFaceSlots()));
    ForEachId(boxes.size(), threads,
      [&](std::size_t i)
      {
        const FaceId face = static_cast<Index>(i);
        if (mesh.IsAlive(face))
        {
          boxes[i] = FloatBox(PositionsOf(mesh, face));
        }
      });
    return boxes;
  }

  /// Calls take(boxed) for each triangle whose box is nearer than the limit.
  template <typename Take>
  void Gather(const FloatBox& box, const std::vector<BoxedFace>* near, const Take& take) const
  {
    const FloatBox grown = box.Grown(this->Limit);
    const auto look = [&](const BoxedFace& one)
    {
      if (one.Box.Meets(grown) && one.Box.DistanceTo(box) < this->Limit)
      {
        take(one);
      }
    };
    if (near != nullptr)
    {
      std::for_each(near->begin(), near->end(), look);
    }
    else
    {
      this->Tree.VisitMeeting(grown,
        [&](std::size_t i) {
          look({ this->Tree.Box(i), static_cast<Index>(i) });
        });
    }
  }

  /// Adds near triangles to the patch by distance, while they may form a disk.
  /// @return Distance of the first triangle beyond the last disk, mm.
  double DistanceFrom(FaceId face, const std::vector<BoxedFace>& near, GrowingPatch& patch) const
  {
    double limit = this->Limit; // mm
    patch.Clear();
    double distance = 0.0; // mm
    const std::vector<Neighbor> neighbors = this->NearestFirst(face, near, limit);
    for (std::size_t i = 0; i < neighbors.size() && neighbors[i].Distance < limit; ++i)
    {
      patch.Add(neighbors[i].Face);
      if (patch.IsDisk())
      {
        distance = std::min(limit, i + 1 < neighbors.size() ? neighbors[i + 1].Distance : limit);
      }
    }
    return distance < this->Limit ? distance : Infinity;
  }

  /// The nearest triangles.
  /// @param limit mm; lowered to the distance of the triangles that are left out.
  std::vector<Neighbor> NearestFirst(
    FaceId face, const std::vector<BoxedFace>& near, double& limit) const
  {
    const FloatBox& box = this->Tree.Box(static_cast<std::size_t>(face));
    std::vector<Neighbor> neighbors(near.size());
    std::transform(near.begin(), near.end(), neighbors.begin(),
      [&](const BoxedFace& one) {
        return Neighbor{ box.DistanceTo(one.Box), one.Face };
      });
    if (neighbors.size() > static_cast<std::size_t>(MaxNear))
    {
      const auto end = neighbors.begin() + MaxNear;
      std::nth_element(neighbors.begin(), end, neighbors.end());
      limit = end->Distance;
      neighbors.erase(end, neighbors.end());
    }
    const TriangleCorners corners = PositionsOf(this->Mesh, face);
    for (Neighbor& one : neighbors)
    {
      const TriangleCorners others = PositionsOf(this->Mesh, one.Face);
      one.Distance = std::max(
        { one.Distance, GapAlongNormal(corners, others), GapAlongNormal(others, corners) });
    }
    std::sort(neighbors.begin(), neighbors.end());
    return neighbors;
  }

  const HalfEdgeMesh& Mesh;
  double Limit; // mm
  BoxTree Tree;
};
}

std::optional<std::vector<double>> FindSeparations(
  const HalfEdgeMesh& mesh, double limit, int threads, const Monitor& monitor)
{
  const NearTriangles triangles(mesh, limit, threads);
  std::vector<double> ofFaces(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), Infinity);
  WorkspacePool<GrowingPatch> patches;
  const bool isDone = ForEachChunk(ofFaces.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const auto patch = patches.Borrow([&] { return std::make_unique<GrowingPatch>(mesh); });
      triangles.Measure(
        static_cast<Index>(first), static_cast<Index>(last), nullptr, *patch, ofFaces);
    });
  if (!isDone)
  {
    return std::nullopt;
  }
  std::vector<double> distances(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), Infinity);
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      for (const VertexId v : mesh.Corners(face))
      {
        distances[v] = std::min(distances[v], ofFaces[face]);
      }
    }
  }
  return distances;
}
}
