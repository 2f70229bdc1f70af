// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceGrid.h
 * @brief The faces of the current mesh by the cells of space they reach into, for workers that edit side by side.
 *
 *     cell:  its faces, and an interval of vertices that holds all corners of the faces that are or ever were in it
 *     a worker may look into a cell, and change it, only if its range holds the interval
 *
 * Intervals only grow, and only a worker whose range contains all of an interval extends it. So no cell changes its worker
 * during a parallel pass, and the result of each worker does not depend on the others. Cells around the surface have an
 * interval from the beginning, even empty ones; all other cells belong to a worker with the whole mesh. Cells are stored in
 * a hash table by position, so distant fragments cost no memory in between.
 */
#ifndef BoneDecimate_Core_Proof_Guard_FaceGrid_h
#define BoneDecimate_Core_Proof_Guard_FaceGrid_h

#include "FloatBox.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/VertexRange.h"

#include <atomic>
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
  using Key = std::uint64_t; ///< Names a cell.

  /// @param leastCell mm, half of the least side of a cell.
  FaceGrid(const HalfEdgeMesh& mesh, double leastCell);

  /// Adds all cells within the reach (mm) of a triangle; none is left out, a few more may be there.
  void AddCells(const TriangleCorners& corners, double reach, std::vector<Key>& cells) const;

  /// Whether the range may look into every cell there is.
  bool HoldsAll(VertexRange range) const;

  /// One of those that AddCells gives for a triangle with such a corner.
  Key CellAt(const Vector3& corner) const;

  /// Whether the range, which does not hold all, may look into the cell.
  bool Owns(VertexRange range, Key cell) const;
  bool OwnsAll(VertexRange range, const std::vector<Key>& cells) const;

  /// Adds the faces in the cells that may meet the box, each as often as it is met.
  void AddFaces(
    const std::vector<Key>& cells, const FloatBox& box, std::vector<Index>& faces) const;

  /// The cells must be those of reach 0 and be owned.
  void Insert(Index face, const Triangle& vertices, const TriangleCorners& corners,
    const std::vector<Key>& cells);
  void Remove(Index face, const std::vector<Key>& cells);

private:
  struct Cell
  {
    Key Name = Free;
    Index First = None; // node
    std::atomic<Index> Low{ std::numeric_limits<Index>::max() };
    std::atomic<Index> High{ None };
  };
  struct Node
  {
    Index Face;
    Index Next;
    FloatBox Box; // of the face
  };
  /// Nodes never move, so that others may work while more are made.
  class Nodes
  {
  public:
    Nodes();
    Node& operator[](Index node) const { return this->Chunks[node / OfChunk][node % OfChunk]; }
    Index Take();
    void Give(Index node);

  private:
    static constexpr Index OfChunk = 1 << 14;
    static constexpr Index MaxChunks = 1 << 17;
    std::mutex Mutex;
    std::unique_ptr<std::unique_ptr<Node[]>[]> Chunks;
    Index Count = 0;
    Index FirstFree = None;
  };
  static constexpr Key Free = ~Key(0);

  static double CellFor(const HalfEdgeMesh& mesh, double least);
  /// Where the search for a cell begins.
  std::size_t FirstSlotOf(Key cell) const
  {
    return static_cast<std::size_t>((cell * 0x9E3779B97F4A7C15ULL) >> 20U) &
      (this->Cells.size() - 1);
  }
  std::size_t SlotOf(Key cell) const;
  Cell& FindOrAdd(Key cell);
  void Grow();

  double Side;      // mm
  Index LastVertex; // of the mesh
  std::vector<Cell> Cells;
  std::size_t Used = 0;
  Nodes Entries;
};
}

#endif
