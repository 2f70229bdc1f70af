// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClearanceGuard.h"

#include "PartTree.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Of the gap at first: what has to stay.
constexpr double ShareOfGap = 0.5;
/// Both sides may move by the error; a gap that many errors wide keeps half of its width whatever happens.
constexpr double ErrorsOfGap = 4.0;

using Piece = ClearanceGuard::Piece;

/// mm, how far from a face its gaps have to be looked after.
double ReachOf(const Gap& gap)
{
  double reach = 0.0;
  for (const float width : { gap.ToOwn, gap.ToOther })
  {
    reach = std::isfinite(width) ? std::max<double>(reach, ShareOfGap * width) : reach;
  }
  return reach;
}

bool BoxesMeet(const Piece& a, const Piece& b)
{
  return a.Low[0] <= b.High[0] && b.Low[0] <= a.High[0] && a.Low[1] <= b.High[1] &&
    b.Low[1] <= a.High[1] && a.Low[2] <= b.High[2] && b.Low[2] <= a.High[2];
}

/// mm^2, between the boxes.
double SquaredDistance(const Piece& a, const Piece& b)
{
  return (a.Low - b.High).cwiseMax(b.Low - a.High).cwiseMax(0.0).squaredNorm();
}

bool HasCorner(const Piece& piece, Index vertex)
{
  return std::find(piece.Vertices.begin(), piece.Vertices.end(), vertex) != piece.Vertices.end();
}

int CountShared(const Piece& a, const Piece& b)
{
  return static_cast<int>(std::count_if(
    a.Vertices.begin(), a.Vertices.end(), [&b](Index vertex) { return HasCorner(b, vertex); }));
}

/// The number of the first corner for which that is so.
std::size_t FindCorner(const Piece& piece, const Piece& other, bool isShared)
{
  std::size_t i = 0;
  while (i < 2 && HasCorner(other, piece.Vertices[i]) != isShared)
  {
    ++i;
  }
  return i;
}

bool Meet(const Piece& a, const Piece& b)
{
  if (!BoxesMeet(a, b))
  {
    return false;
  }
  switch (CountShared(a, b))
  {
    case 0:
      return bonedecimate::Meet(a, b);
    case 1:
      return MeetBeyondCorner(a, FindCorner(a, b, true), b, FindCorner(b, a, true));
    case 2:
      return MeetBeyondEdge(a, FindCorner(a, b, false), b.Corners[FindCorner(b, a, false)]);
    default:
      return true;
  }
}

/// Pairs of a patch with what is near it, and within it, that meet.
/// @param isEnough Asked after each with how many they are by then; true ends it.
template <typename IsEnough>
void CountMeetings(
  const std::vector<Piece>& patch, const std::vector<Piece>& near, const IsEnough& isEnough)
{
  std::size_t count = 0;
  for (auto piece = patch.begin(); piece != patch.end(); ++piece)
  {
    const auto endsIt = [&](const Piece& other)
    { return Meet(*piece, other) && isEnough(++count); };
    if (std::any_of(near.begin(), near.end(), endsIt) ||
      std::any_of(piece + 1, patch.end(), endsIt))
    {
      return;
    }
  }
}

/// Whether more pairs meet than with the faces that go.
bool MeetMore(
  const std::vector<Piece>& before, const std::vector<Piece>& after, const std::vector<Piece>& near)
{
  std::size_t allowed = 0;
  bool isMore = false;
  CountMeetings(after, near,
    [&](std::size_t count)
    {
      if (count == 1) // most edits need not know
      {
        CountMeetings(before, near,
          [&](std::size_t countBefore)
          {
            allowed = countBefore;
            return false;
          });
      }
      isMore = count > allowed;
      return isMore;
    });
  return isMore;
}

/// mm, of the box around all of them; there is one at least.
Vector3 LeastOf(const std::vector<Piece>& pieces)
{
  Vector3 low = pieces[0].Low;
  for (const Piece& piece : pieces)
  {
    low = low.cwiseMin(piece.Low);
  }
  return low;
}
Vector3 MostOf(const std::vector<Piece>& pieces)
{
  Vector3 high = pieces[0].High;
  for (const Piece& piece : pieces)
  {
    high = high.cwiseMax(piece.High);
  }
  return high;
}

double MostReach(const std::vector<Piece>& pieces) // mm
{
  double most = 0.0;
  for (const Piece& piece : pieces)
  {
    most = std::max(most, piece.Reach);
  }
  return most;
}

/// Whether p lies in what two patches with one rim enclose; in doubt it does.
/// @param size mm, longer than the box around both.
bool IsBetween(
  const Vector3& p, double size, const std::vector<Piece>& a, const std::vector<Piece>& b)
{
  // Directions that nobody models along.
  for (const Vector3& direction : { Vector3(0.61, 0.53, 0.587), Vector3(-0.37, 0.71, -0.599) })
  {
    const Vector3 farPoint = p + 2.0 * size * direction;
    bool isInside = false;
    bool isClear = true;
    for (const std::vector<Piece>* patch : { &a, &b })
    {
      for (const Piece& piece : *patch)
      {
        const RayAnswer answer = ShootRay(p, farPoint, piece);
        isInside = isInside != (answer == RayAnswer::Hits);
        isClear = isClear && answer != RayAnswer::Unclear;
      }
    }
    if (isClear)
    {
      return isInside;
    }
  }
  return true;
}
}

ClearanceGuard::ClearanceGuard(const HalfEdgeMesh& mesh, const Surface& surface, double error,
  int threads, const Monitor& monitor)
  : Grid(mesh, error)
  , Widths(surface, ErrorsOfGap * error, threads, monitor)
{
}

//------------------------------------------------------------------------------
/// A new vertex stands for both that were merged into it.
ClearanceGuard::Piece ClearanceGuard::PieceOf(const HalfEdgeMesh& mesh, const Patch& change,
  const Triangle& vertices, const TriangleCorners& corners) const
{
  Piece piece(corners);
  piece.Vertices = { mesh.Site(vertices[0]), mesh.Site(vertices[1]), mesh.Site(vertices[2]) };
  piece.Low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  piece.High = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  piece.Normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  for (const Index site : piece.Vertices)
  {
    piece.LeastGap = piece.LeastGap.And(this->Widths.Of(site));
    if (change.Moved != None && site == mesh.Site(change.Moved))
    {
      piece.LeastGap = piece.LeastGap.And(this->Widths.Of(mesh.Site(change.Ends[0])));
      piece.LeastGap = piece.LeastGap.And(this->Widths.Of(mesh.Site(change.Ends[1])));
    }
  }
  piece.Reach = ReachOf(piece.LeastGap);
  return piece;
}

//------------------------------------------------------------------------------
void ClearanceGuard::FillPieces(
  const HalfEdgeMesh& mesh, const Patch& change, Workspace& work) const
{
  work.Old.clear();
  work.New.clear();
  for (const Index face : change.OldFaces)
  {
    const Triangle v = mesh.Corners(face);
    work.Old.push_back(this->PieceOf(mesh, change, v, CornersOf(mesh, v)));
  }
  for (const Patch::Face& face : change.NewFaces)
  {
    work.New.push_back(this->PieceOf(mesh, change, face.Vertices, face.Corners));
  }
}

//------------------------------------------------------------------------------
void ClearanceGuard::FindCells(Workspace& work) const
{
  work.OldCells.clear();
  work.EndsOfOld.clear();
  work.Cells.clear();
  for (const Piece& piece : work.Old)
  {
    this->Grid.AddCells(piece.Corners, 0.0, work.OldCells);
    work.EndsOfOld.push_back(work.OldCells.size());
  }
  for (const Piece& piece : work.New)
  {
    this->Grid.AddCells(piece.Corners, piece.Reach, work.Cells);
  }
  work.Cells.insert(work.Cells.end(), work.OldCells.begin(), work.OldCells.end());
  std::sort(work.Cells.begin(), work.Cells.end());
  work.Cells.erase(std::unique(work.Cells.begin(), work.Cells.end()), work.Cells.end());
}

//------------------------------------------------------------------------------
/// Faces that stay and whose box is as near as any gap asks for, or meets that of a face that goes.
void ClearanceGuard::FindNear(const HalfEdgeMesh& mesh, const Patch& change, Workspace& work) const
{
  work.Faces.clear();
  work.Near.clear();
  this->Grid.AddFaces(work.Cells, work.Faces);
  std::sort(work.Faces.begin(), work.Faces.end());
  work.Faces.erase(std::unique(work.Faces.begin(), work.Faces.end()), work.Faces.end());
  const std::vector<Index>& old = change.OldFaces;
  const double reach = std::max(MostReach(work.New), MostReach(work.Old));
  const Vector3 wholeLow = LeastOf(work.Old).cwiseMin(LeastOf(work.New)).array() - reach;
  const Vector3 wholeHigh = MostOf(work.Old).cwiseMax(MostOf(work.New)).array() + reach;
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
      return (piece.Low - high).cwiseMax(low - piece.High).cwiseMax(0.0).squaredNorm() <=
        piece.Reach * piece.Reach;
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
/// mm, at first, where the two stand; infinite if there was none.
double ClearanceGuard::GapOf(const Piece& a, const Piece& b) const
{
  const Gap both = a.LeastGap.And(b.LeastGap);
  return this->Widths.PartOf(a.Vertices[0]) == this->Widths.PartOf(b.Vertices[0]) ? both.ToOwn
                                                                                  : both.ToOther;
}

//------------------------------------------------------------------------------
/// For the gap at first, and nearer than what it takes the place of.
bool ClearanceGuard::IsTooNear(
  const Piece& piece, const Piece& near, const std::vector<Piece>& old) const
{
  const double gap = this->GapOf(piece, near);
  const bool isOwn =
    this->Widths.PartOf(piece.Vertices[0]) == this->Widths.PartOf(near.Vertices[0]);
  const double squared = ShareOfGap * ShareOfGap * gap * gap; // mm^2
  if (!std::isfinite(gap) || SquaredDistance(piece, near) >= squared ||
    (isOwn && piece.Normal.dot(near.Normal) >= 0.0) || CountShared(piece, near) > 0)
  {
    return false;
  }
  const Way way = WayBetween(piece.Corners, near.Corners);
  if (way.SquaredLength >= squared || (isOwn && !Face(piece.Normal, near.Normal, way.FromAToB)))
  {
    return false;
  }
  return std::all_of(old.begin(), old.end(),
    [&](const Piece& gone)
    {
      return CountShared(gone, near) > 0 ||
        WayBetween(gone.Corners, near.Corners).SquaredLength > way.SquaredLength;
    });
}

//------------------------------------------------------------------------------
bool ClearanceGuard::NarrowsGap(const Workspace& work) const
{
  return std::any_of(work.New.begin(), work.New.end(),
    [&](const Piece& piece)
    {
      return std::any_of(work.Near.begin(), work.Near.end(),
        [&](const Piece& near) { return this->IsTooNear(piece, near, work.Old); });
    });
}

//------------------------------------------------------------------------------
/// What meets neither the faces that go nor the new ones lies between them as a whole or not at all.
bool ClearanceGuard::JumpsOver(const Workspace& work)
{
  const Vector3 low = LeastOf(work.Old).cwiseMin(LeastOf(work.New));
  const Vector3 high = MostOf(work.Old).cwiseMax(MostOf(work.New));
  const double size = (high - low).sum();
  return std::any_of(work.Near.begin(), work.Near.end(),
    [&](const Piece& near)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const bool isOfPatch = std::any_of(work.Old.begin(), work.Old.end(),
          [&](const Piece& old) { return HasCorner(old, near.Vertices[i]); });
        const Vector3& p = near.Corners[i];
        if (!isOfPatch)
        {
          return (p - low).minCoeff() >= 0.0 && (high - p).minCoeff() >= 0.0 &&
            IsBetween(p, size, work.Old, work.New);
        }
      }
      return false;
    });
}

//------------------------------------------------------------------------------
bool ClearanceGuard::Owns(
  const HalfEdgeMesh& mesh, const Patch& change, VertexRange range, Workspace& work) const
{
  work.KnowsCells = false;
  if (this->Grid.HoldsAll(range))
  {
    return true;
  }
  // Corners alone tell most of what belongs to others, and soon.
  const auto isOwned = [&](const Patch::Face& face)
  {
    return std::all_of(face.Corners.begin(), face.Corners.end(),
      [&](const Vector3& corner) { return this->Grid.Owns(range, this->Grid.CellAt(corner)); });
  };
  if (!std::all_of(change.NewFaces.begin(), change.NewFaces.end(), isOwned))
  {
    return false;
  }
  work.KnowsCells = true;
  this->FillPieces(mesh, change, work);
  this->FindCells(work);
  return std::all_of(work.Cells.begin(), work.Cells.end(),
    [&](FaceGrid::Key cell) { return this->Grid.Owns(range, cell); });
}

//------------------------------------------------------------------------------
Verdict ClearanceGuard::Judge(const HalfEdgeMesh& mesh, const Patch& change, Workspace& work) const
{
  if (!work.KnowsCells)
  {
    this->FillPieces(mesh, change, work);
    this->FindCells(work);
  }
  this->FindNear(mesh, change, work);
  const bool allowed =
    !MeetMore(work.Old, work.New, work.Near) && !this->NarrowsGap(work) && !JumpsOver(work);
  return allowed ? Verdict::Allowed : Verdict::Crossing;
}

//------------------------------------------------------------------------------
void ClearanceGuard::Commit(const HalfEdgeMesh& mesh, const Patch& change, Workspace& work)
{
  std::size_t from = 0;
  for (std::size_t i = 0; i < change.OldFaces.size(); ++i)
  {
    work.Cells.assign(work.OldCells.begin() + static_cast<std::ptrdiff_t>(from),
      work.OldCells.begin() + static_cast<std::ptrdiff_t>(work.EndsOfOld[i]));
    this->Grid.Remove(change.OldFaces[i], work.Cells);
    from = work.EndsOfOld[i];
  }
  for (const Patch::Face& face : change.NewFaces)
  {
    work.Cells.clear();
    this->Grid.AddCells(face.Corners, 0.0, work.Cells);
    this->Grid.Insert(face.Id, face.Vertices, work.Cells);
  }
  if (change.Moved != None)
  {
    this->Widths.Set(mesh.Site(change.Moved),
      this->Widths.Of(mesh.Site(change.Ends[0])).And(this->Widths.Of(mesh.Site(change.Ends[1]))));
  }
}
}
