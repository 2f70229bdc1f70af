// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothingGraph.h
 * @brief The Laplacian L of a surface as a sparse matrix: the difference between a point and the
 * weighted mean of its neighbors.
 *
 *     (L x)_i = x_i - sum_j a_ij x_j      a_ij = w_ij m_i / sum of them over j: rows have the sum 0
 *     w_ij    = 1 / max(|e|, 0.6 median |e|)^2
 *               |e|: length of the edge in units of the displacements
 *     m_i     = 1
 *               boundary point:  0 along edges that are not of the boundary or of a junction
 *               junction point:  0.1 along edges that are not of the junction
 *
 * The row of a point on a sharp edge (SharpEdges.h) counts only the components of each difference
 * along the normals of the triangles at that edge, so that the point lies on the surfaces on both
 * sides. Along the sharp edge it counts the whole difference, unless the point is a corner:
 *
 *     (L x)_i = sum_j a_ij N_ij (x_i - x_j)      N_ij = mean of n n^T
 *
 * An edge of one triangle is a boundary edge. An edge of three or more triangles, or of two with
 * different labels, is a junction edge. So boundaries and junction curves are smoothed along
 * themselves. With the factor 0 at junctions, walls would intersect each other there.
 */
#ifndef BoneDecimate_Core_Smoothing_SmoothingGraph_h
#define BoneDecimate_Core_Smoothing_SmoothingGraph_h

#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "SharpEdges.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
enum class CurveKind : std::uint8_t
{
  Interior, ///< Inside of a surface.
  Boundary, ///< On an open boundary.
  Junction  ///< On a curve where three walls or two labels meet.
};

class SmoothingGraph
{
public:
  /// @param surface Its corners must be valid and different. Points without triangles have no
  ///   neighbors.
  /// @param labels For each triangle; empty: none.
  /// @param toUnits From millimeters.
  SmoothingGraph(const Surface& surface, const std::vector<BoundaryLabels>& labels,
    const Eigen::Matrix3d& toUnits, int threads);

  Index NumberOfPoints() const { return static_cast<Index>(this->Kinds.size()); }
  CurveKind Kind(Index point) const { return this->Kinds[point]; }

  /// Visits all neighbors in ascending order, including those with weight 0.
  template <typename Visit>
  void VisitNeighbors(Index point, const Visit& visit) const
  {
    for (std::size_t k = this->Starts[point]; k < this->Starts[point + 1]; ++k)
    {
      visit(this->Neighbors[k]);
    }
  }

  /// Row `point` of L x.
  Vector3 Row(Index point, const std::vector<Vector3>& x) const
  {
    return this->IsSharp(point)
      ? this->SharpRow(point, [&](Index neighbor) { return Vector3(x[point] - x[neighbor]); })
      : this->Apply(this->Weights, point, x);
  }
  /// Row `point` of the transpose of L times z.
  Vector3 TransposedRow(Index point, const std::vector<Vector3>& z) const
  {
    return this->IsNearSharp(point) ? this->TransposedRowNearSharp(point, z)
                                    : this->Apply(this->TransposedWeights, point, z);
  }
  /// Row `point` of L x in units, computed from differences of neighbors, without cancellation far
  /// from the origin.
  /// @param x mm.
  /// @param toUnits Converts a displacement.
  template <typename ToUnits>
  Vector3 RowOfPositions(Index point, const std::vector<Vector3>& x, const ToUnits& toUnits) const
  {
    if (this->IsSharp(point))
    {
      return this->SharpRow(point, [&](Index neighbor) { return toUnits(x[point] - x[neighbor]); });
    }
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = this->Starts[point]; k < this->Starts[point + 1]; ++k)
    {
      sum += this->Weights[k] * (x[point] - x[this->Neighbors[k]]);
    }
    return toUnits(sum);
  }

  /// Replaces the rows of points on sharp edges by those of sharp edges.
  /// @param sharp Found for SmoothEdges() and the triangles of the surface.
  /// @param toUnits From millimeters to the axes of the displacements.
  void KeepSharp(const Surface& surface, const SharpEdges& sharp, const Eigen::Matrix3d& toUnits);
  std::int64_t NumberOfSharpPoints() const;

  /// Median length of the edges, in units.
  double MedianLength() const { return this->MedianEdgeLength; }

  /// An upper bound of row `point` of the absolute values of L^T L: twice the absolute sum of a
  /// column of L.
  double ColumnBound(Index point) const;

  /// The two triangles of each edge that is neither a boundary nor a junction.
  const std::vector<std::array<Index, 2>>& SmoothEdges() const { return this->TrianglesOfEdges; }

private:
  struct Incidence
  {
    Index Neighbor;
    Index Triangle;
  };
  void FindNeighbors(const Surface& surface, const std::vector<BoundaryLabels>& labels);
  void ReadNeighbors(const std::vector<Incidence>& sorted, const std::vector<std::size_t>& starts,
    const std::vector<BoundaryLabels>& labels);
  void WeighEdges(const std::vector<Vector3>& points, const Eigen::Matrix3d& toUnits);
  void Normalize();
  double Factor(Index point, CurveKind edge) const;
  std::size_t Find(Index point, Index neighbor) const;
  bool IsSharp(Index point) const
  {
    return !this->SharpStarts.empty() && this->SharpStarts[point] != None;
  }
  bool IsNearSharp(Index point) const
  {
    return !this->NearSharpFlags.empty() && this->NearSharpFlags[point] != 0;
  }
  void MarkSharp(const Surface& surface, const std::vector<char>& isSharp);
  void AddProjections(
    const Surface& surface, const SharpEdges& sharp, const Eigen::Matrix3d& toUnits);
  void CountWholeAlong(const Surface& surface, const std::vector<char>& isSharp);
  template <typename Difference>
  Vector3 SharpRow(Index point, const Difference& toNeighbor) const
  {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = this->Starts[point]; k < this->Starts[point + 1]; ++k)
    {
      sum += this->Weights[k] * (this->Projection(point, k) * toNeighbor(this->Neighbors[k]));
    }
    return sum;
  }
  const Eigen::Matrix3d& Projection(Index point, std::size_t k) const
  {
    return this->Projections[this->SharpStarts[point] + (k - this->Starts[point])];
  }
  Vector3 TransposedRowNearSharp(Index point, const std::vector<Vector3>& z) const;
  Vector3 Apply(
    const std::vector<double>& weights, Index point, const std::vector<Vector3>& x) const
  {
    Vector3 sum = this->HasRow[point] != 0 ? x[point] : Vector3(Vector3::Zero());
    for (std::size_t k = this->Starts[point]; k < this->Starts[point + 1]; ++k)
    {
      sum -= weights[k] * x[this->Neighbors[k]];
    }
    return sum;
  }

  int Threads;
  std::vector<CurveKind> Kinds;
  std::vector<char> HasRow;              // of each point; 0: all weights are 0
  std::vector<std::size_t> Starts;       // of each point in the lists below, and the end
  std::vector<Index> Neighbors;          // ascending
  std::vector<CurveKind> EdgeKinds;      // only during construction
  std::vector<double> Weights;           // a_ij
  std::vector<double> TransposedWeights; // a_ji
  std::vector<std::array<Index, 2>> TrianglesOfEdges;
  double MedianEdgeLength = 0.0;
  // Empty without sharp edges.
  std::vector<Index> SharpStarts;   // of each point in Projections; None: not on a sharp edge
  std::vector<char> NearSharpFlags; // of each point: it or a neighbor is on one
  std::vector<Eigen::Matrix3d> Projections; // N of each neighbor of each point on a sharp edge
};
}

#endif
