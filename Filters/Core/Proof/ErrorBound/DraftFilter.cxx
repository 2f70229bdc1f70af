// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DraftFilter.h"

#include "Base/Parallel.h"
#include "CommonFaceProof.h"
#include "Prover.h"
#include "StartOfWalk.h"
#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Ratio of the limits that a draft uses. With a larger one, the proof that follows rejects more
/// edits than the draft gains.
constexpr double RatioOfLimit = 0.8;
/// Accumulated error, as a ratio of the limit, up to which new faces are hardly ever too far away.
constexpr double SmallAccumulatedError = 0.3;
/// Ratio of the largest limit below which limits change from triangle to triangle, so that each new
/// face is proved.
constexpr double MuchLess = 0.5;
/// Ratio of the mean edge length of the original: with smaller limits, errors within an edge count.
constexpr double LimitForEdges = 0.3;
}

struct DraftFilter::Pending : public EditFilter::Pending
{
  struct Held
  {
    Index Sample;
    FaceId Face;
  };
  CommonFaceProof Distances;
  std::vector<Held> Moved;
  Index Nearest = None;   // to the new vertex
  bool IsLimited = false; // to much less than the bound
};

DraftFilter::DraftFilter(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
  const std::vector<Index>& current, int threads)
  : Shared(bound)
  , Allowed(limits)
  , FirstOfFaces(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
{
  this->AddVertices();
  this->AddEdges();
  this->Distribute(mesh, current, threads);
}

//------------------------------------------------------------------------------
void DraftFilter::AddVertices()
{
  for (VertexId v = 0; v < this->Shared.Source.NumberOfVertexSlots(); ++v)
  {
    this->Samples.push_back(
      { this->Shared.Source.Position(v), RatioOfLimit * this->Allowed.At(v), None });
    this->At.push_back(v);
  }
}

//------------------------------------------------------------------------------
void DraftFilter::AddEdges()
{
  const HalfEdgeMesh& original = this->Shared.Source;
  const double small = LimitForEdges * original.LengthAtFirst(); // mm
  for (Index i = 0; i < 3 * original.NumberOfFaceSlots(); ++i)
  {
    const HalfEdgeId h = HalfEdgeMesh::HalfEdge(i / 3, i % 3);
    const VertexId from = original.Origin(h);
    const VertexId to = original.Target(h);
    const double limit = ErrorLimits::Between(this->Allowed.At(from), this->Allowed.At(to), 0.5);
    if (original.Twin(h) < h && limit < small)
    {
      this->Samples.push_back(
        { 0.5 * (original.Position(from) + original.Position(to)), RatioOfLimit * limit, None });
      this->At.push_back(from);
    }
  }
}

//------------------------------------------------------------------------------
/// To the nearest faces.
void DraftFilter::Distribute(
  const HalfEdgeMesh& mesh, const std::vector<Index>& current, int threads)
{
  const StartOfWalk starts(mesh);
  std::vector<Index> faces(this->Samples.size());
  ForEachId(faces.size(), threads,
    [&](std::size_t i)
    { faces[i] = starts.FindNear(this->Samples[i].Position, current[this->At[i]]).Face; });
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    this->Samples[i].Next = std::exchange(this->FirstOfFaces[faces[i]], static_cast<Index>(i));
  }
}

//------------------------------------------------------------------------------
void DraftFilter::KeepUnproved(const HalfEdgeMesh& mesh, int threads)
{
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Allowed);
  this->IsKept.assign(this->FirstOfFaces.size(), 0);
  ForEachChunk(this->IsKept.size(), threads, {},
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const std::shared_ptr<Prover> prover = this->Shared.BorrowProver();
      for (std::size_t i = first; i < last; ++i)
      {
        const FaceId face = static_cast<Index>(i);
        const bool isProved = !mesh.IsAlive(face) ||
          prover->Back.Prove(
            original, PositionsOf(mesh, face), this->Shared.Nearest[mesh.Corners(face)[0]]);
        this->IsKept[i] = isProved ? 0 : 1;
      }
    });
}

//------------------------------------------------------------------------------
bool DraftFilter::Keeps(const SurfaceChange& change) const
{
  return !this->IsKept.empty() &&
    std::any_of(change.OldFaces.begin(), change.OldFaces.end(),
      [this](Index face) { return this->IsKept[face] != 0; });
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> DraftFilter::MakePending()
{
  return std::make_shared<Pending>();
}

//------------------------------------------------------------------------------
Decision DraftFilter::Screen(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending&) const
{
  const bool isFree = change.Requested.Kind == EditKind::Collapse &&
    mesh.MovesFreely(change.Ends[0]) && mesh.MovesFreely(change.Ends[1]) && !this->Keeps(change);
  return isFree ? Rejection::NotRejected : Rejection::Boundary;
}

//------------------------------------------------------------------------------
Decision DraftFilter::Check(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  Pending& work = static_cast<Pending&>(pending);
  if (change.NewFaces.size() > CommonFaceProof::MaxCandidates - Coverage::SlotsPerItem)
  {
    return Rejection::ErrorBound;
  }
  work.Distances.Resize(0);
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    work.Distances.AddCandidate(face.Corners);
  }
  return this->SamplesAreNear(change, work) && this->NewFacesAreNear(change, work)
    ? Rejection::NotRejected
    : Rejection::ErrorBound;
}

//------------------------------------------------------------------------------
bool DraftFilter::SamplesAreNear(const SurfaceChange& change, Pending& work) const
{
  work.Moved.clear();
  work.IsLimited = false;
  for (const Index old : change.OldFaces)
  {
    for (Index s = this->FirstOfFaces[old]; s != None; s = this->Samples[s].Next)
    {
      const Sample& sample = this->Samples[s];
      work.IsLimited = work.IsLimited || sample.Limit < MuchLess * this->Allowed.Most();
      work.Distances.FacesNear(sample.Position, sample.Limit);
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < change.NewFaces.size(); ++i)
      {
        nearest =
          work.Distances.SquaredDistance(i) < work.Distances.SquaredDistance(nearest) ? i : nearest;
      }
      if (work.Distances.SquaredDistance(nearest) > sample.Limit * sample.Limit)
      {
        return false;
      }
      work.Moved.push_back({ s, change.NewFaces[nearest].Id });
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool DraftFilter::NewFacesAreNear(const SurfaceChange& change, Pending& work) const
{
  const WalkedSurface original(this->Shared.Source, this->Shared.Tree, this->Allowed);
  const auto isNear = [&](const Vector3& p)
  {
    const PieceCover<3>::Corner found = original.Find(p, work.Nearest);
    work.Nearest = found.Nearest;
    return found.Distance <= RatioOfLimit * original.Limit(found.Nearest);
  };
  work.Nearest = this->Shared.Nearest[change.Moved];
  if (!isNear(change.Requested.Position))
  {
    return false;
  }
  const Index nearest = work.Nearest;
  const double limit = RatioOfLimit * original.Limit(nearest);
  const bool areNear = change.AccumulatedError <= SmallAccumulatedError * limit ||
    std::all_of(change.NewFaces.begin(), change.NewFaces.end(),
      [&](const SurfaceChange::Face& face)
      {
        const std::array<Vector3, 3>& p = face.Corners; // the first is the new vertex
        return isNear((p[0] + p[1] + p[2]) / 3.0) && isNear(0.5 * (p[0] + p[1]));
      });
  work.Nearest = nearest;
  return areNear && (!work.IsLimited || this->FacesAreProved(change, original, nearest));
}

//------------------------------------------------------------------------------
/// Where the separation is small, limits change from triangle to triangle, and few points say
/// little.
bool DraftFilter::FacesAreProved(
  const SurfaceChange& change, const WalkedSurface& original, Index nearest) const
{
  const std::shared_ptr<Prover> prover = this->Shared.BorrowProver();
  return std::all_of(change.NewFaces.begin(), change.NewFaces.end(),
    [&](const SurfaceChange::Face& face)
    { return prover->Back.Prove(original, face.Corners, nearest); });
}

//------------------------------------------------------------------------------
void DraftFilter::Commit(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending, Tally&)
{
  const Pending& work = static_cast<const Pending&>(pending);
  this->Shared.Nearest[change.Moved] = work.Nearest;
  for (const Index old : change.OldFaces)
  {
    this->FirstOfFaces[old] = None;
  }
  for (const Pending::Held& held : work.Moved)
  {
    this->Samples[held.Sample].Next = std::exchange(this->FirstOfFaces[held.Face], held.Sample);
  }
}
}
