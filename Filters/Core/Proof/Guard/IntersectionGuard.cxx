// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IntersectionGuard.h"

#include "GapPairs.h"
#include "GuardReach.h"
#include "PartTree.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
double MaxReach(const std::vector<Piece>& pieces) // mm
{
  double most = 0.0;
  for (const Piece& piece : pieces)
  {
    most = std::max(most, piece.Reach);
  }
  return most;
}
}

IntersectionGuard::IntersectionGuard(const HalfEdgeMesh& mesh, const Surface& surface,
  const WrittenPositions& written, double error, bool guardsGaps, int threads,
  const Monitor& monitor)
  : Mesh(mesh)
  , Written(written)
  , MinCell(error)
  , Widths(surface, guardsGaps ? ErrorsOfGap * error : 0.0, threads, monitor)
{
}

//------------------------------------------------------------------------------
/// The least gap at the corners of a face, by their original vertices. A new vertex represents both
/// vertices that were merged into it.
Gap IntersectionGuard::MinGapOf(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, const Triangle& originals) const
{
  Gap least = this->Widths.MinOf(originals);
  const bool isMoved = change.Moved != None &&
    std::find(originals.begin(), originals.end(), mesh.OriginalVertex(change.Moved)) !=
      originals.end();
  if (isMoved)
  {
    least = least.And(this->Widths.Of(mesh.OriginalVertex(change.Ends[0])));
    least = least.And(this->Widths.Of(mesh.OriginalVertex(change.Ends[1])));
  }
  return least;
}

//------------------------------------------------------------------------------
Piece IntersectionGuard::PieceOf(const HalfEdgeMesh& mesh, const SurfaceChange& change,
  const Triangle& vertices, const TriangleCorners& corners) const
{
  Piece piece(mesh, vertices, corners);
  piece.MinGap = this->MinGapOf(mesh, change, piece.Vertices);
  piece.Reach = ReachOf(piece.MinGap);
  piece.Fragment = this->Widths.PartOf(piece.Vertices[0]);
  return piece;
}

//------------------------------------------------------------------------------
void IntersectionGuard::FillPieces(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const
{
  work.Old.clear();
  work.New.clear();
  for (const Index face : change.OldFaces)
  {
    const Triangle v = mesh.Corners(face);
    work.Old.push_back(this->PieceOf(mesh, change, v, CornersOf(mesh, v)));
  }
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    work.New.push_back(this->PieceOf(mesh, change, face.Vertices, face.Corners));
  }
}

//------------------------------------------------------------------------------
void IntersectionGuard::FindCells(Pending& work) const
{
  work.OldCells.clear();
  work.EndsOfOld.clear();
  work.Cells.clear();
  for (const Piece& piece : work.Old)
  {
    this->Grid->AddCells(piece.Corners, 0.0, work.OldCells);
    work.EndsOfOld.push_back(work.OldCells.size());
  }
  for (const Piece& piece : work.New)
  {
    this->Grid->AddCells(piece.Corners, piece.Reach + this->Written.Rounding(), work.Cells);
  }
  work.Cells.insert(work.Cells.end(), work.OldCells.begin(), work.OldCells.end());
  std::sort(work.Cells.begin(), work.Cells.end());
  work.Cells.erase(std::unique(work.Cells.begin(), work.Cells.end()), work.Cells.end());
}

//------------------------------------------------------------------------------
/// Remaining faces whose box is within the reach of the gap rule or meets the box of a removed
/// face.
void IntersectionGuard::FindNear(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const
{
  work.Faces.clear();
  work.Near.clear();
  const std::vector<Index>& old = change.OldFaces;
  const double rounding = this->Written.Rounding();
  const double reach = std::max(MaxReach(work.New), MaxReach(work.Old)) + rounding;
  work.Reach = reach;
  const Vector3 wholeLow = MinOf(work.Old).cwiseMin(MinOf(work.New)).array() - reach;
  const Vector3 wholeHigh = MaxOf(work.Old).cwiseMax(MaxOf(work.New)).array() + reach;
  this->Grid->AddFaces(
    work.Cells, FloatBox(TriangleCorners{ wholeLow, wholeHigh, wholeHigh }), work.Faces);
  std::sort(work.Faces.begin(), work.Faces.end());
  work.Faces.erase(std::unique(work.Faces.begin(), work.Faces.end()), work.Faces.end());
  for (const Index face : work.Faces)
  {
    const Triangle v = mesh.Corners(face);
    const TriangleCorners corners = CornersOf(mesh, v);
    const Vector3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Vector3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const bool mayBeNear =
      (wholeHigh - low).minCoeff() >= 0.0 && (high - wholeLow).minCoeff() >= 0.0;
    const auto isNear = [&](const Piece& piece)
    {
      const double within = piece.Reach + rounding;
      return (piece.Low - high).cwiseMax(low - piece.High).cwiseMax(0.0).squaredNorm() <=
        within * within;
    };
    if (mayBeNear &&
      (std::any_of(work.New.begin(), work.New.end(), isNear) ||
        std::any_of(work.Old.begin(), work.Old.end(), isNear)) &&
      std::find(old.begin(), old.end(), face) == old.end())
    {
      work.Near.push_back(this->PieceOf(mesh, change, v, corners));
    }
  }
}

//------------------------------------------------------------------------------
/// Remaining faces which may lie between the faces that go and the new ones. The volume between
/// both is within the cones from one point over all of these faces, which are tetrahedra. Each of
/// its points is no farther from one of their sides than the least height.
void IntersectionGuard::FindSwept(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const
{
  work.Cells.clear();
  work.Faces.clear();
  work.Swept.clear();
  const Vector3 apex = change.Moved != None ? change.Requested.Position : work.New[0].Corners[0];
  for (const std::vector<Piece>* pieces : { &work.Old, &work.New })
  {
    for (const Piece& piece : *pieces)
    {
      this->AddCellsOfCone(piece.Corners, apex, work.Cells);
    }
  }
  std::sort(work.Cells.begin(), work.Cells.end());
  work.Cells.erase(std::unique(work.Cells.begin(), work.Cells.end()), work.Cells.end());
  const Vector3 low = MinOf(work.Old).cwiseMin(MinOf(work.New));
  const Vector3 high = MaxOf(work.Old).cwiseMax(MaxOf(work.New));
  this->Grid->AddFaces(work.Cells, FloatBox(TriangleCorners{ low, high, high }), work.Faces);
  std::sort(work.Faces.begin(), work.Faces.end());
  work.Faces.erase(std::unique(work.Faces.begin(), work.Faces.end()), work.Faces.end());
  const std::vector<Index>& old = change.OldFaces;
  for (const Index face : work.Faces)
  {
    if (std::find(old.begin(), old.end(), face) == old.end())
    {
      const Triangle v = mesh.Corners(face);
      work.Swept.emplace_back(mesh, v, CornersOf(mesh, v));
    }
  }
}

//------------------------------------------------------------------------------
void IntersectionGuard::AddCellsOfCone(
  const TriangleCorners& base, const Vector3& apex, std::vector<FaceGrid::Key>& cells) const
{
  const std::array<TriangleCorners, 4> sides = { { base, { base[0], base[1], apex },
    { base[1], base[2], apex }, { base[2], base[0], apex } } };
  double twice = 0.0; // mm^2, of the largest area
  for (const TriangleCorners& side : sides)
  {
    twice = std::max(twice, (side[1] - side[0]).cross(side[2] - side[0]).norm());
  }
  const double volume =
    std::abs(Dot((base[1] - base[0]).cross(base[2] - base[0]), apex - base[0])); // mm^3, six times
  if (volume > 0.0)
  {
    for (const TriangleCorners& side : sides)
    {
      this->Grid->AddCells(side, volume / twice, cells);
    }
  }
}

//------------------------------------------------------------------------------
bool IntersectionGuard::NarrowsGap(const Pending& work) const
{
  return std::any_of(work.New.begin(), work.New.end(),
    [&](const Piece& piece)
    {
      return std::any_of(work.Near.begin(), work.Near.end(),
        [&](const Piece& near) { return IsTooNear(this->Widths, piece, near, work.Old); });
    });
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> IntersectionGuard::MakePending()
{
  this->BuildGrid();
  return std::make_shared<Pending>();
}

//------------------------------------------------------------------------------
/// The first worker builds it. No edit is applied before: every worker needs a Pending for its
/// first one.
void IntersectionGuard::BuildGrid()
{
  const std::lock_guard<std::mutex> lock(this->Building);
  if (!this->Grid)
  {
    this->Grid = std::make_unique<FaceGrid>(this->Mesh, this->MinCell);
  }
}

//------------------------------------------------------------------------------
void IntersectionGuard::TakeDraft(const EditJournal& journal)
{
  MergeGaps(journal, this->Mesh, this->Widths);
  this->Grid.reset();
}

//------------------------------------------------------------------------------
Decision IntersectionGuard::Screen(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  Pending& work = static_cast<Pending&>(pending);
  work.KnowsCells = false;
  if (this->Grid->HoldsAll(change.Range))
  {
    return Decision::Accept();
  }
  // Corners alone tell most of what belongs to others, and soon.
  const auto isOwned = [&](const SurfaceChange::Face& face)
  {
    return std::all_of(face.Corners.begin(), face.Corners.end(),
      [&](const Vector3& p) { return this->Grid->Owns(change.Range, this->Grid->CellAt(p)); });
  };
  if (!std::all_of(change.NewFaces.begin(), change.NewFaces.end(), isOwned))
  {
    return Decision::Defer();
  }
  work.KnowsCells = true;
  this->FillPieces(mesh, change, work);
  this->FindCells(work);
  return this->Grid->OwnsAll(change.Range, work.Cells) ? Decision::Accept() : Decision::Defer();
}

//------------------------------------------------------------------------------
Decision IntersectionGuard::Check(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  Pending& work = static_cast<Pending&>(pending);
  if (!work.KnowsCells)
  {
    this->FillPieces(mesh, change, work);
    this->FindCells(work);
  }
  this->FindNear(mesh, change, work);
  if (MeetMore(work.Old, work.New, work.Near, this->Written) || this->NarrowsGap(work))
  {
    return Rejection::Intersection;
  }
  this->FindSwept(mesh, change, work);
  if (!this->Grid->HoldsAll(change.Range) && !this->Grid->OwnsAll(change.Range, work.Cells))
  {
    return Decision::Defer();
  }
  const bool jumps = JumpOver(work.Old, work.New, work.Swept);
  return jumps ? Rejection::Intersection : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
/// No duplicate is made, and none is like it.
void IntersectionGuard::Adopt(VertexId made, VertexId like)
{
  this->Widths.Copy(this->Mesh.OriginalVertex(like), made);
}

//------------------------------------------------------------------------------
double IntersectionGuard::Reach(const EditFilter::Pending& pending) const
{
  return static_cast<const Pending&>(pending).Reach;
}

//------------------------------------------------------------------------------
/// Duplicates have one gap. An edit at one of them changes that of faces at the others, which may
/// reach far away from the edit.
bool IntersectionGuard::StillAccepts(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  const Pending& work = static_cast<const Pending&>(pending);
  return std::all_of(work.Near.begin(), work.Near.end(),
    [&](const Piece& near) { return this->MinGapOf(mesh, change, near.Vertices) == near.MinGap; });
}

//------------------------------------------------------------------------------
void IntersectionGuard::Commit(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending, Tally&)
{
  Pending& work = static_cast<Pending&>(pending);
  std::size_t from = 0;
  for (std::size_t i = 0; i < change.OldFaces.size(); ++i)
  {
    work.Cells.assign(work.OldCells.begin() + static_cast<std::ptrdiff_t>(from),
      work.OldCells.begin() + static_cast<std::ptrdiff_t>(work.EndsOfOld[i]));
    this->Grid->Remove(change.OldFaces[i], work.Cells);
    from = work.EndsOfOld[i];
  }
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    work.Cells.clear();
    this->Grid->AddCells(face.Corners, 0.0, work.Cells);
    this->Grid->Insert(face.Id, face.Vertices, face.Corners, work.Cells);
  }
  if (change.Moved != None)
  {
    this->Widths.Set(mesh.OriginalVertex(change.Moved),
      this->Widths.Of(mesh.OriginalVertex(change.Ends[0]))
        .And(this->Widths.Of(mesh.OriginalVertex(change.Ends[1]))));
  }
}
}
