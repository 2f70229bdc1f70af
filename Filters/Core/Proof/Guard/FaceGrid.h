// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceGrid.h
 * @brief The faces of the current mesh by the cells of a grid that they reach, for workers that
 * edit side by side.
 *
 *     cell:  its faces, and an interval of vertices that contains all corners of the faces
 *            that are or ever were in it
 *     a worker may read and change a cell only if its range contains the interval
 *
 * Intervals only grow, and only a worker whose range contains all of an interval extends it. So no
 * cell changes its worker during a parallel pass, and the result of each worker does not depend on
 * the others.
 *
 * Cells around the surface have an interval from the beginning, even empty ones. All other cells
 * belong to a worker with the whole mesh. Cells are stored in a hash table by position, so distant
 * fragments cost no memory in between.
 */
#ifndef BoneDecimate_Core_Proof_Guard_FaceGrid_h
#define BoneDecimate_Core_Proof_Guard_FaceGrid_h

#include "FloatBox.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/VertexRange.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace bonedecimate
{
inline TriangleCorners CornersOf(const HalfEdgeMesh& mesh, const Triangle& v)
{
  return { mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2]) };
}

class FaceGrid
{
public:
  using CellKey = std::uint64_t; ///< Position of a cell.

  /// @param minCellSize mm, half of the least side of a cell.
  FaceGrid(const HalfEdgeMesh& mesh, double minCellSize);

  /// Adds all cells within the reach (mm) of a triangle, and possibly a few more.
  void AddCells(const TriangleCorners& corners, double reach, std::vector<CellKey>& cells) const;

  /// Whether the range may read every cell.
  bool HoldsAll(VertexRange range) const;

  /// The cell of a corner, one of those that AddCells finds for its triangle.
  CellKey CellAt(const Vector3& corner) const;

  /// Whether the range, which is not the whole mesh, may read the cell.
  bool Owns(VertexRange range, CellKey cell) const;
  bool OwnsAll(VertexRange range, const std::vector<CellKey>& cells) const;

  /// Adds the faces in the cells whose boxes meet the box, once for each cell.
  void AddFaces(
    const std::vector<CellKey>& cells, const FloatBox& box, std::vector<Index>& faces) const;

  /// The cells must be those of reach 0 and be owned.
  void Insert(Index face, const Triangle& vertices, const TriangleCorners& corners,
    const std::vector<CellKey>& cells);
  void Remove(Index face, const std::vector<CellKey>& cells);

private:
  struct Cell
  {
    CellKey Key = Free;
    Index FirstNode = None; // node
    std::atomic<Index> Low{ std::numeric_limits<Index>::max() };
    std::atomic<Index> High{ None };
  };
  struct Node
  {
    Index Face;
    Index Next;
    FloatBox Box; // of the face
  };
  /// Nodes never move, so workers may use them while others allocate more.
  class Nodes
  {
  public:
    Nodes();
    Node& operator[](Index node) const
    {
      return this->Chunks[node / NodesPerChunk][node % NodesPerChunk];
    }
    Index Allocate();
    void Release(Index node);

  private:
    static constexpr Index NodesPerChunk = 1 << 14;
    static constexpr Index MaxChunks = 1 << 17;
    std::mutex Mutex;
    std::unique_ptr<std::unique_ptr<Node[]>[]> Chunks;
    Index Count = 0;
    Index FirstFree = None;
  };
  static constexpr CellKey Free = ~CellKey(0);

  static double ChooseCellSize(const HalfEdgeMesh& mesh, double minSize);
  /// The slot at which the search for a cell begins.
  std::size_t FirstSlotOf(CellKey cell) const
  {
    return static_cast<std::size_t>((cell * 0x9E3779B97F4A7C15ULL) >> 20U) &
      (this->Cells.size() - 1);
  }
  std::size_t SlotOf(CellKey cell) const;
  Cell& FindOrAdd(CellKey cell);
  void Grow();

  double CellSize;  // mm
  Index LastVertex; // of the mesh
  std::vector<Cell> Cells;
  std::size_t UsedCells = 0;
  Nodes NodePool;
};
}

#endif
