// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature.h"

#include "Base/Parallel.h"
#include "Geometry/Angle.h"
#include "Geometry/TriangleGeometry.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Sums over a part of the surface.
struct Curving
{
  Eigen::Matrix3d Edges = Eigen::Matrix3d::Zero(); // mm
  double Area = 0.0;                               // mm^2
};

Vector3 AreaVectorOf(const HalfEdgeMesh& mesh, FaceId face) // mm^2
{
  const Triangle c = mesh.Corners(face);
  return AreaVector(mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2]));
}

/// The tensor of an edge of two faces.
Eigen::Matrix3d TensorOf(const HalfEdgeMesh& mesh, HalfEdgeId h)
{
  const Vector3 edge = mesh.Position(mesh.Target(h)) - mesh.Position(mesh.Origin(h));
  const Vector3 left = AreaVectorOf(mesh, HalfEdgeMesh::Face(h));
  const Vector3 right = AreaVectorOf(mesh, HalfEdgeMesh::Face(mesh.Twin(h)));
  const double length = edge.norm();
  if (!(length > 0.0) || !(left.norm() > 0.0) || !(right.norm() > 0.0))
  {
    return Eigen::Matrix3d::Zero();
  }
  const double angle = AngleBetween(left.normalized(), right.normalized());
  const double sign = Dot(right.cross(left), edge) < 0.0 ? -1.0 : 1.0;
  return sign * angle / length * edge * edge.transpose();
}

/// Each vertex gets half of each edge and a third of each face.
std::vector<Curving> CurvingOfVertices(const HalfEdgeMesh& mesh)
{
  std::vector<Curving> curving(static_cast<std::size_t>(mesh.NumberOfVertexSlots()));
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    const double area = AreaVectorOf(mesh, face).norm();
    for (Index k = 0; k < 3; ++k)
    {
      const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, k);
      curving[mesh.Origin(h)].Area += area / 3.0;
      if (mesh.Twin(h) != None && h < mesh.Twin(h))
      {
        const Eigen::Matrix3d half = 0.5 * TensorOf(mesh, h);
        curving[mesh.Origin(h)].Edges += half;
        curving[mesh.Target(h)].Edges += half;
      }
    }
  }
  return curving;
}

/// Sums over the vertices within a distance of one, found along edges.
class Neighborhoods
{
public:
  Neighborhoods(const HalfEdgeMesh& mesh, const PointGraph& graph, double radius,
    const std::vector<Curving>& curving)
    : Mesh(mesh)
    , Graph(graph)
    , SquaredRadius(radius * radius)
    , OfVertex(curving)
    , SeenFrom(curving.size(), None)
  {
  }

  Curving Around(Index vertex)
  {
    const Vector3& center = this->Mesh.Position(vertex);
    Curving sum;
    this->Found.assign(1, vertex);
    this->SeenFrom[static_cast<std::size_t>(vertex)] = vertex;
    for (std::size_t i = 0; i < this->Found.size(); ++i)
    {
      const Curving& here = this->OfVertex[static_cast<std::size_t>(this->Found[i])];
      sum.Edges += here.Edges;
      sum.Area += here.Area;
      this->Graph.VisitNeighbors(this->Found[i],
        [&](Index neighbor)
        {
          Index& seen = this->SeenFrom[static_cast<std::size_t>(neighbor)];
          if (seen != vertex &&
            (this->Mesh.Position(neighbor) - center).squaredNorm() <= this->SquaredRadius)
          {
            seen = vertex;
            this->Found.push_back(neighbor);
          }
        });
    }
    return sum;
  }

private:
  const HalfEdgeMesh& Mesh;
  const PointGraph& Graph;
  double SquaredRadius; // mm^2
  const std::vector<Curving>& OfVertex;
  std::vector<Index> SeenFrom; // for each vertex, the last vertex whose neighborhood contains it
  std::vector<Index> Found;
};

double MaxEigenvalue(const Curving& curving) // 1/mm, without its sign
{
  if (!(curving.Area > 0.0))
  {
    return 0.0;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
    curving.Edges / curving.Area, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}
}

std::vector<double> MaxCurvatures(
  const HalfEdgeMesh& mesh, const PointGraph& graph, double radius, int threads)
{
  const std::vector<Curving> curving = CurvingOfVertices(mesh);
  std::vector<double> largest(curving.size());
  ForEachBlock(curving.size(), threads,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Neighborhoods neighborhoods(mesh, graph, radius, curving);
      for (std::size_t v = first; v < last; ++v)
      {
        largest[v] = MaxEigenvalue(neighborhoods.Around(static_cast<Index>(v)));
      }
    });
  return largest;
}
}
