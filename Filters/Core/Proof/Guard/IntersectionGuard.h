// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IntersectionGuard.h
 * @brief No edit makes triangles intersect that did not intersect before, nor narrows a gap to less
 * than half of its initial width.
 *
 *     near    = faces of the current mesh near the new ones                            (FaceGrid)
 *     meet:     pairs of a new face with a near one, or of two new ones, that intersect
 *               rejected if there are more than with the old faces                     (PairFace)
 *     gap:      a pair that faces each other, or of two fragments, without a common corner
 *               rejected if it is nearer than half the initial gap at its corners
 *               and nearer than the old faces were                                     (GapRule)
 *     jump:     rejected if a corner of a remaining face lies between the old and the
 *               new faces                                                              (PairFace)
 *
 * The edits of a draft are checked together, in the mesh that they leave (StateCheck.h).
 */
#ifndef BoneDecimate_Core_Proof_Guard_IntersectionGuard_h
#define BoneDecimate_Core_Proof_Guard_IntersectionGuard_h

#include "FaceGrid.h"
#include "GapRule.h"
#include "PairFace.h"
#include "Proof/EditFilters/EditJournal.h"
#include "StateCheck.h"

#include <memory>
#include <mutex>
#include <vector>

namespace bonedecimate
{
class IntersectionGuard : public EditFilter
{
public:
  /// @param mesh Must outlive this object.
  /// @param surface The surface from which the mesh was made, with its manifold patches joined.
  /// @param error mm, by which the surface may move.
  /// @param written Intersections are decided at these positions.
  /// @param guardsGaps Whether gaps are measured; otherwise only intersections are rejected.
  IntersectionGuard(const HalfEdgeMesh& mesh, const Surface& surface,
    const WrittenPositions& written, double error, bool guardsGaps, int threads,
    const Monitor& monitor);

  std::shared_ptr<EditFilter::Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }
  /// Defers an edit near cells of the grid that belong to another worker.
  Decision Screen(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  double Reach(const EditFilter::Pending& pending) const override;
  /// Whether no gap that the check read has changed.
  bool StillAccepts(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  void Adopt(VertexId made, VertexId like) override;
  void Commit(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending,
    Tally& tally) override;

  /// The check of a draft; to be made before its first edit. Guard and journal must outlive it.
  StateCheck MakeStateCheck(const EditJournal& journal) const
  {
    return { this->Mesh, this->Widths, this->Written, journal };
  }
  /// Continues with the mesh that the edits of a draft left.
  void TakeDraft(const EditJournal& journal);

private:
  struct Pending : public EditFilter::Pending
  {
    std::vector<FaceGrid::CellKey> OldCells, Cells;
    std::vector<std::size_t> OldCellEnds; // of each old face, the end of its cells
    std::vector<Index> FaceIds;
    std::vector<PairFace> OldFaces, NewFaces, NearFaces, SweptFaces;
    double Reach = 0.0;      // mm, within which near faces were searched
    bool KnowsCells = false; // whether Screen has found the cells
  };
  void BuildGrid();
  Gap MinGapOf(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, const Triangle& originals) const;
  PairFace PairFaceOf(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    const Triangle& vertices, const TriangleCorners& corners) const;
  void FillFaces(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  void FindCells(Pending& work) const;
  void FindNear(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  void FindSwept(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  void AddCellsOfCone(
    const TriangleCorners& base, const Vector3& apex, std::vector<FaceGrid::CellKey>& cells) const;
  bool NarrowsGap(const Pending& work) const;

  const HalfEdgeMesh& Mesh;
  WrittenPositions Written;
  double MinCellSize; // mm, of the grid
  std::unique_ptr<FaceGrid> Grid;
  std::mutex BuildMutex; // of the grid
  GapRule Widths;
};
}

#endif
