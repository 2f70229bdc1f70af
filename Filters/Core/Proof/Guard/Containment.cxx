// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Containment.h"

#include "TrianglePair.h"

#include <algorithm>
#include <optional>

namespace bonedecimate
{
namespace
{
Surface TrianglesOf(const HalfEdgeMesh& mesh, std::vector<FaceId>& faces)
{
  Surface surface;
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    surface.Points.push_back(mesh.Position(v));
  }
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      surface.Triangles.push_back(mesh.Corners(face));
      faces.push_back(face);
    }
  }
  return surface;
}

/// Components that occur an odd number of times.
std::vector<Index> OddOnes(std::vector<Index> components)
{
  std::sort(components.begin(), components.end());
  std::vector<Index> odd;
  for (auto first = components.begin(); first != components.end();)
  {
    const auto next = std::upper_bound(first, components.end(), *first);
    if ((next - first) % 2 != 0)
    {
      odd.push_back(*first);
    }
    first = next;
  }
  return odd;
}

/// Searches among the faces of a mesh.
class EnclosingSearch
{
public:
  EnclosingSearch(const HalfEdgeMesh& mesh, const std::function<Index(VertexId)>& componentOf,
    const BoundingTree* tree, int threads)
    : Mesh(mesh)
    , ComponentOf(componentOf)
    , Tree(tree)
  {
    if (tree == nullptr)
    {
      this->OwnTree.emplace(TrianglesOf(mesh, this->Faces), threads);
      this->Tree = &*this->OwnTree;
    }
  }

  /// Components that a ray from the vertex meets an odd number of times. Nothing if it passes
  /// through an edge.
  std::optional<std::vector<Index>> FindAlong(
    VertexId vertex, const Vector3& direction, double length) const
  {
    const Vector3 from = this->Mesh.Position(vertex);
    const Vector3 end = from + length * direction;
    const Index own = this->ComponentOf(vertex);
    std::vector<Index> met;
    bool isClear = true;
    this->Tree->VisitAlong(from, direction, length,
      [&](Index triangle)
      {
        const FaceId face = this->Faces.empty() ? FaceId(triangle) : this->Faces[triangle];
        const Index component = this->ComponentOf(this->Mesh.Corners(face)[0]);
        if (component != own)
        {
          const RayResult result =
            ShootRay(from, end, PlaneTriangle(PositionsOf(this->Mesh, face)));
          isClear = isClear && result != RayResult::Unclear;
          if (result == RayResult::Hits)
          {
            met.push_back(component);
          }
        }
      });
    return isClear ? std::optional<std::vector<Index>>(OddOnes(met)) : std::nullopt;
  }

private:
  const HalfEdgeMesh& Mesh;
  const std::function<Index(VertexId)>& ComponentOf;
  const BoundingTree* Tree;
  std::vector<FaceId> Faces; // of the tree; empty: its triangles are the faces
  std::optional<BoundingTree> OwnTree;
};

/// Vertices of a component that are tried: one may lie on another component.
constexpr int MaxTries = 8;

/// mm, longer than the mesh.
double LengthOf(const HalfEdgeMesh& mesh)
{
  double length = 0.0;
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    length = std::max(length, 4.0 * (mesh.Position(v) - mesh.Position(0)).norm());
  }
  return length;
}
}

std::vector<std::vector<Index>> FindEnclosing(const HalfEdgeMesh& mesh, Index components,
  const std::function<Index(VertexId)>& componentOf, const BoundingTree* tree, int threads)
{
  std::vector<std::vector<Index>> enclosing(static_cast<std::size_t>(components));
  if (components < 2)
  {
    return enclosing;
  }
  const EnclosingSearch search(mesh, componentOf, tree, threads);
  const double length = LengthOf(mesh);
  std::vector<int> tries(enclosing.size(), 0);
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    const VertexId vertex = mesh.IsAlive(face) ? mesh.Corners(face)[0] : None;
    if (vertex == None || tries[componentOf(vertex)]++ >= MaxTries)
    {
      continue;
    }
    // Directions along which modeled geometry is hardly ever aligned.
    for (const Vector3& direction : { Vector3(0.61, 0.53, 0.587), Vector3(-0.37, 0.71, -0.599),
           Vector3(0.43, -0.29, 0.855), Vector3(-0.12, -0.81, 0.574) })
    {
      if (const auto found = search.FindAlong(vertex, direction.normalized(), length))
      {
        enclosing[componentOf(vertex)] = *found;
        tries[componentOf(vertex)] = MaxTries;
        break;
      }
    }
  }
  return enclosing;
}
}
