// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IntersectionGuard.h"

#include "FragmentTree.h"
#include "GapPairs.h"
#include "GuardReach.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
double MaxReach(const std::vector<PairFace>& faces) // mm
{
  double most = 0.0;
  for (const PairFace& face : faces)
  {
    most = std::max(most, face.Reach);
  }
  return most;
}
}

IntersectionGuard::IntersectionGuard(const HalfEdgeMesh& mesh, const Surface& surface,
  const WrittenPositions& written, double error, bool guardsGaps, int threads,
  const Monitor& monitor)
  : Mesh(mesh)
  , Written(written)
  , MinCellSize(error)
  , Widths(surface, guardsGaps ? ErrorsOfGap * error : 0.0, threads, monitor)
{
}

//------------------------------------------------------------------------------
/// The least gap at the corners of a face. A moved vertex represents both ends of its edit.
Gap IntersectionGuard::MinGapOf(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, const Triangle& originals) const
{
  Gap least = this->Widths.MinOf(originals);
  const bool isMoved = change.MovedVertex != None &&
    std::find(originals.begin(), originals.end(), mesh.OriginalVertex(change.MovedVertex)) !=
      originals.end();
  if (isMoved)
  {
    least = Min(least, this->Widths.Of(mesh.OriginalVertex(change.Ends[0])));
    least = Min(least, this->Widths.Of(mesh.OriginalVertex(change.Ends[1])));
  }
  return least;
}

//------------------------------------------------------------------------------
PairFace IntersectionGuard::PairFaceOf(const HalfEdgeMesh& mesh, const SurfaceChange& change,
  const Triangle& vertices, const TriangleCorners& corners) const
{
  PairFace face(mesh, vertices, corners);
  face.MinGap = this->MinGapOf(mesh, change, face.Vertices);
  face.Reach = ReachOf(face.MinGap);
  face.Fragment = this->Widths.FragmentOf(face.Vertices[0]);
  return face;
}

//------------------------------------------------------------------------------
void IntersectionGuard::FillFaces(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const
{
  work.OldFaces.clear();
  work.NewFaces.clear();
  for (const Index id : change.OldFaces)
  {
    const Triangle v = mesh.Corners(id);
    work.OldFaces.push_back(this->PairFaceOf(mesh, change, v, CornersOf(mesh, v)));
  }
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    work.NewFaces.push_back(this->PairFaceOf(mesh, change, face.Vertices, face.Corners));
  }
}

//------------------------------------------------------------------------------
void IntersectionGuard::FindCells(Pending& work) const
{
  work.OldCells.clear();
  work.OldCellEnds.clear();
  work.Cells.clear();
  for (const PairFace& face : work.OldFaces)
  {
    this->Grid->AddCells(face.Corners, 0.0, work.OldCells);
    work.OldCellEnds.push_back(work.OldCells.size());
  }
  for (const PairFace& face : work.NewFaces)
  {
    this->Grid->AddCells(face.Corners, face.Reach + this->Written.Rounding(), work.Cells);
  }
  work.Cells.insert(work.Cells.end(), work.OldCells.begin(), work.OldCells.end());
  std::sort(work.Cells.begin(), work.Cells.end());
  work.Cells.erase(std::unique(work.Cells.begin(), work.Cells.end()), work.Cells.end());
}

//------------------------------------------------------------------------------
/// Remaining faces whose box is within the reach of a new or an old face.
void IntersectionGuard::FindNear(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const
{
  work.FaceIds.clear();
  work.NearFaces.clear();
  const std::vector<Index>& old = change.OldFaces;
  const double rounding = this->Written.Rounding();
  const double reach = std::max(MaxReach(work.NewFaces), MaxReach(work.OldFaces)) + rounding;
  work.Reach = reach;
  const Vector3 wholeLow = MinOf(work.OldFaces).cwiseMin(MinOf(work.NewFaces)).array() - reach;
  const Vector3 wholeHigh = MaxOf(work.OldFaces).cwiseMax(MaxOf(work.NewFaces)).array() + reach;
  this->Grid->AddFaces(
    work.Cells, FloatBox(TriangleCorners{ wholeLow, wholeHigh, wholeHigh }), work.FaceIds);
  std::sort(work.FaceIds.begin(), work.FaceIds.end());
  work.FaceIds.erase(std::unique(work.FaceIds.begin(), work.FaceIds.end()), work.FaceIds.end());
  for (const Index id : work.FaceIds)
  {
    const Triangle v = mesh.Corners(id);
    const TriangleCorners corners = CornersOf(mesh, v);
    const Vector3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Vector3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const bool mayBeNear =
      (wholeHigh - low).minCoeff() >= 0.0 && (high - wholeLow).minCoeff() >= 0.0;
    const auto isNear = [&](const PairFace& face)
    {
      const double within = face.Reach + rounding;
      return (face.Low - high).cwiseMax(low - face.High).cwiseMax(0.0).squaredNorm() <=
        within * within;
    };
    if (mayBeNear &&
      (std::any_of(work.NewFaces.begin(), work.NewFaces.end(), isNear) ||
        std::any_of(work.OldFaces.begin(), work.OldFaces.end(), isNear)) &&
      std::find(old.begin(), old.end(), id) == old.end())
    {
      work.NearFaces.push_back(this->PairFaceOf(mesh, change, v, corners));
    }
  }
}

//------------------------------------------------------------------------------
/// Finds remaining faces that may lie between the old and the new faces. The volume between them is
/// covered by cones from one point over all these faces. A cone is a tetrahedron, and no point of
/// it is farther from its sides than its least height.
void IntersectionGuard::FindSwept(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const
{
  work.Cells.clear();
  work.FaceIds.clear();
  work.SweptFaces.clear();
  const Vector3 apex =
    change.MovedVertex != None ? change.Requested.Position : work.NewFaces[0].Corners[0];
  for (const std::vector<PairFace>* faces : { &work.OldFaces, &work.NewFaces })
  {
    for (const PairFace& face : *faces)
    {
      this->AddCellsOfCone(face.Corners, apex, work.Cells);
    }
  }
  std::sort(work.Cells.begin(), work.Cells.end());
  work.Cells.erase(std::unique(work.Cells.begin(), work.Cells.end()), work.Cells.end());
  const Vector3 low = MinOf(work.OldFaces).cwiseMin(MinOf(work.NewFaces));
  const Vector3 high = MaxOf(work.OldFaces).cwiseMax(MaxOf(work.NewFaces));
  this->Grid->AddFaces(work.Cells, FloatBox(TriangleCorners{ low, high, high }), work.FaceIds);
  std::sort(work.FaceIds.begin(), work.FaceIds.end());
  work.FaceIds.erase(std::unique(work.FaceIds.begin(), work.FaceIds.end()), work.FaceIds.end());
  const std::vector<Index>& old = change.OldFaces;
  for (const Index face : work.FaceIds)
  {
    if (std::find(old.begin(), old.end(), face) == old.end())
    {
      const Triangle v = mesh.Corners(face);
      work.SweptFaces.emplace_back(mesh, v, CornersOf(mesh, v));
    }
  }
}

//------------------------------------------------------------------------------
void IntersectionGuard::AddCellsOfCone(
  const TriangleCorners& base, const Vector3& apex, std::vector<FaceGrid::CellKey>& cells) const
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
  return std::any_of(work.NewFaces.begin(), work.NewFaces.end(),
    [&](const PairFace& face)
    {
      return std::any_of(work.NearFaces.begin(), work.NearFaces.end(),
        [&](const PairFace& near) { return IsTooNear(this->Widths, face, near, work.OldFaces); });
    });
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> IntersectionGuard::MakePending()
{
  this->BuildGrid();
  return std::make_shared<Pending>();
}

//------------------------------------------------------------------------------
/// The first worker builds it, before any edit: every worker needs a Pending for its first one.
void IntersectionGuard::BuildGrid()
{
  const std::lock_guard<std::mutex> lock(this->BuildMutex);
  if (!this->Grid)
  {
    this->Grid = std::make_unique<FaceGrid>(this->Mesh, this->MinCellSize);
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
  // The cells of the corners alone are a quick test that finds most foreign cells.
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
  this->FillFaces(mesh, change, work);
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
    this->FillFaces(mesh, change, work);
    this->FindCells(work);
  }
  this->FindNear(mesh, change, work);
  if (MeetMore(work.OldFaces, work.NewFaces, work.NearFaces, this->Written) ||
    this->NarrowsGap(work))
  {
    return Rejection::Intersection;
  }
  this->FindSwept(mesh, change, work);
  if (!this->Grid->HoldsAll(change.Range) && !this->Grid->OwnsAll(change.Range, work.Cells))
  {
    return Decision::Defer();
  }
  const bool jumps = JumpOver(work.OldFaces, work.NewFaces, work.SweptFaces);
  return jumps ? Rejection::Intersection : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
/// The new vertex has no duplicates.
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
/// Duplicates of a vertex have one gap. An edit at one of them changes that of faces at the
/// others, which may be far away.
bool IntersectionGuard::StillAccepts(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  const Pending& work = static_cast<const Pending&>(pending);
  return std::all_of(work.NearFaces.begin(), work.NearFaces.end(),
    [&](const PairFace& near)
    { return this->MinGapOf(mesh, change, near.Vertices) == near.MinGap; });
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
      work.OldCells.begin() + static_cast<std::ptrdiff_t>(work.OldCellEnds[i]));
    this->Grid->Remove(change.OldFaces[i], work.Cells);
    from = work.OldCellEnds[i];
  }
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    work.Cells.clear();
    this->Grid->AddCells(face.Corners, 0.0, work.Cells);
    this->Grid->Insert(face.Id, face.Vertices, face.Corners, work.Cells);
  }
  if (change.MovedVertex != None)
  {
    this->Widths.Set(mesh.OriginalVertex(change.MovedVertex),
      Min(this->Widths.Of(mesh.OriginalVertex(change.Ends[0])),
        this->Widths.Of(mesh.OriginalVertex(change.Ends[1]))));
  }
}
}
