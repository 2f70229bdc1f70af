// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SheetDistances.h"

#include "BoxTree.h"
#include "Parallel.h"
#include "Piece.h"
#include "WorkspacePool.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Triangles that are searched around at once: they follow each other and are near each other.
constexpr std::size_t Together = 4;

/// Triangles that are added one after the other: whether they are a disk.
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

  bool AreConnected(FaceId a, FaceId b)
  {
    return this->RootOf(this->Position[a]) == this->RootOf(this->Position[b]);
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

struct Workspace
{
  explicit Workspace(const HalfEdgeMesh& mesh)
    : Patch(mesh)
  {
  }
  struct Near
  {
    double Distance; // mm, at least
    FaceId Face;
    bool operator<(const Near& other) const
    {
      return std::tie(this->Distance, this->Face) < std::tie(other.Distance, other.Face);
    }
  };
  struct Boxed
  {
    FloatBox Box;
    FaceId Face;
  };
  GrowingPatch Patch;
  std::vector<Boxed> Around; // a group
  std::vector<Near> Faces;   // around a triangle
};

/// mm, by which b lies beyond the plane of a, or 0.
double GapAlongNormal(const TriangleCorners& a, const TriangleCorners& b)
{
  const Vector3 normal = (a[1] - a[0]).cross(a[2] - a[0]).normalized();
  const std::array<double, 3> heights = { Dot(normal, b[0] - a[0]), Dot(normal, b[1] - a[0]),
    Dot(normal, b[2] - a[0]) };
  const auto ends = std::minmax_element(heights.begin(), heights.end());
  return std::max({ 0.0, *ends.first, -*ends.second });
}

/// The triangles of a mesh in a tree.
class Sheets
{
public:
  Sheets(const HalfEdgeMesh& mesh, double limit, int threads)
    : Mesh(mesh)
    , Limit(limit)
    , Tree(Boxes(mesh, threads), threads)
  {
  }

  /// Finds the triangles within the limit of one of these; whether they are a disk.
  bool GatherDisk(Index first, Index last, Workspace& work) const
  {
    FloatBox around;
    for (Index face = first; face < last; ++face)
    {
      around.Add(this->Tree.Box(static_cast<std::size_t>(face)));
    }
    work.Around.clear();
    work.Patch.Clear();
    this->Tree.VisitMeeting(around.Grown(this->Limit),
      [&](std::size_t i)
      {
        work.Around.push_back({ this->Tree.Box(i), static_cast<Index>(i) });
        work.Patch.Add(work.Around.back().Face);
      });
    return work.Patch.IsDisk();
  }

  /// mm, infinite if it is not less than the limit.  @param work Has gathered what is near.
  double DistanceAt(FaceId face, Workspace& work) const
  {
    const FloatBox& box = this->Tree.Box(static_cast<std::size_t>(face));
    const FloatBox grown = box.Grown(this->Limit);
    work.Faces.clear();
    work.Patch.Clear();
    for (const Workspace::Boxed& one : work.Around)
    {
      const double distance = one.Box.Meets(grown) ? one.Box.DistanceTo(box) : this->Limit; // mm
      if (distance < this->Limit)
      {
        work.Faces.push_back({ distance, one.Face });
        work.Patch.Add(one.Face);
      }
    }
    return work.Patch.IsDisk() ? Infinity : this->DistanceToOthers(face, work);
  }

private:
  static std::vector<FloatBox> Boxes(const HalfEdgeMesh& mesh, int threads)
  {
    std::vector<FloatBox> boxes(static_cast<std::size_t>(mesh.NumberOfFaceSlots()));
    ForEachId(boxes.size(), threads,
      [&](std::size_t i)
      {
        const FaceId face = static_cast<Index>(i);
        if (mesh.IsAlive(face))
        {
          boxes[i] = FloatBox(CornersOf(mesh, mesh.Corners(face)));
        }
      });
    return boxes;
  }

  double DistanceToOthers(FaceId face, Workspace& work) const
  {
    const auto others = std::stable_partition(work.Faces.begin(), work.Faces.end(),
      [&](const Workspace::Near& near) { return work.Patch.AreConnected(face, near.Face); });
    work.Patch.Clear();
    std::for_each(
      work.Faces.begin(), others, [&](const Workspace::Near& near) { work.Patch.Add(near.Face); });
    const double toRim =
      work.Patch.IsDisk() ? this->Limit : this->DistanceToRim(face, others, work);
    const double distance = this->LeastOf(face, others, toRim, work);
    return distance < this->Limit ? distance : Infinity;
  }

  /// Of what is connected with the face, in the order of distances, to the first triangle beyond the last disk.
  double DistanceToRim(
    FaceId face, std::vector<Workspace::Near>::iterator end, Workspace& work) const
  {
    const TriangleCorners corners = CornersOf(this->Mesh, this->Mesh.Corners(face));
    for (auto near = work.Faces.begin(); near != end; ++near)
    {
      const TriangleCorners others = CornersOf(this->Mesh, this->Mesh.Corners(near->Face));
      near->Distance = std::max(
        { near->Distance, GapAlongNormal(corners, others), GapAlongNormal(others, corners) });
    }
    std::sort(work.Faces.begin(), end);
    work.Patch.Clear();
    double distance = 0.0; // mm
    for (auto near = work.Faces.begin(); near != end && near->Distance < this->Limit; ++near)
    {
      work.Patch.Add(near->Face);
      if (work.Patch.IsDisk())
      {
        distance = near + 1 != end ? (near + 1)->Distance : this->Limit;
      }
    }
    return distance;
  }

  /// To the others, if it is less than the limit (mm).
  double LeastOf(
    FaceId face, std::vector<Workspace::Near>::iterator first, double limit, Workspace& work) const
  {
    const Triangle v = this->Mesh.Corners(face);
    Piece piece(this->Mesh, v, CornersOf(this->Mesh, v));
    for (auto near = first; near != work.Faces.end(); ++near)
    {
      if (near->Distance < limit)
      {
        const Triangle w = this->Mesh.Corners(near->Face);
        Piece other(this->Mesh, w, CornersOf(this->Mesh, w));
        limit = CountShared(piece, other) > 0 || Meet(piece, other, {})
          ? 0.0
          : std::min(limit, std::sqrt(WayBetween(piece.Corners, other.Corners).SquaredLength));
      }
    }
    return limit;
  }

  const HalfEdgeMesh& Mesh;
  double Limit; // mm
  BoxTree Tree;
};
}

std::vector<double> SheetDistances(const HalfEdgeMesh& mesh, double limit, int threads)
{
  const Sheets sheets(mesh, limit, threads);
  std::vector<double> ofFaces(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), Infinity);
  WorkspacePool<Workspace> workspaces;
  ForEachChunk(ofFaces.size(), threads, {},
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const auto work = workspaces.Borrow([&] { return std::make_unique<Workspace>(mesh); });
      for (std::size_t i = first; i < last; i += Together)
      {
        const auto end = static_cast<Index>(std::min(last, i + Together));
        const bool isDisk = sheets.GatherDisk(static_cast<Index>(i), end, *work);
        for (FaceId face = static_cast<Index>(i); face < end && !isDisk; ++face)
        {
          ofFaces[face] = mesh.IsAlive(face) ? sheets.DistanceAt(face, *work) : Infinity;
        }
      }
    });
  std::vector<double> distances(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), Infinity);
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    for (const VertexId v : mesh.Corners(face))
    {
      distances[v] = std::min(distances[v], ofFaces[face]);
    }
  }
  return distances;
}
}
