// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DraftFilter.h"

#include "Base/Parallel.h"
#include "CommonFaceProof.h"
#include "Prover.h"
#include "VertexWalk.h"
#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Ratio of the limits that a draft uses. With a larger one, the proof that follows undoes more
/// edits than the draft gains.
constexpr double RatioOfLimit = 0.8;
/// Accumulated error, as a ratio of the limit, up to which new faces are hardly ever too far away.
constexpr double SmallAccumulatedError = 0.3;
/// Ratio of the largest limit. Smaller limits vary from triangle to triangle, so each new face is
/// proved.
constexpr double SmallLimitRatio = 0.5;
/// Ratio of the mean edge length of the original. If the limit is smaller, edges get samples, too.
constexpr double LimitForEdges = 0.3;
}

struct DraftFilter::Pending : public EditFilter::Pending
{
  struct Reassignment
  {
    Index Sample;
    FaceId Face;
  };
  CommonFaceProof Distances;
  std::vector<Reassignment> Reassigned;
  Index Nearest = None;   // original triangle nearest to the new vertex
  bool IsLimited = false; // whether a limit is small
};

DraftFilter::DraftFilter(ErrorBound& bound, const ErrorLimits& limits, const HalfEdgeMesh& mesh,
  const std::vector<Index>& current, int threads)
  : Bound(bound)
  , Limits(limits)
  , FirstSamples(static_cast<std::size_t>(mesh.NumberOfFaceSlots()), None)
{
  this->AddVertices();
  this->AddEdges();
  this->Distribute(mesh, current, threads);
}

//------------------------------------------------------------------------------
void DraftFilter::AddVertices()
{
  for (VertexId v = 0; v < this->Bound.OriginalMesh.NumberOfVertexSlots(); ++v)
  {
    this->Samples.push_back(
      { this->Bound.OriginalMesh.Position(v), RatioOfLimit * this->Limits.At(v), None });
    this->SampleVertices.push_back(v);
  }
}

//------------------------------------------------------------------------------
void DraftFilter::AddEdges()
{
  const HalfEdgeMesh& original = this->Bound.OriginalMesh;
  const double small = LimitForEdges * original.InitialEdgeLength(); // mm
  for (Index i = 0; i < 3 * original.NumberOfFaceSlots(); ++i)
  {
    const HalfEdgeId h = HalfEdgeMesh::HalfEdge(i / 3, i % 3);
    const VertexId from = original.Origin(h);
    const VertexId to = original.Target(h);
    const double limit = ErrorLimits::Interpolate(this->Limits.At(from), this->Limits.At(to), 0.5);
    if (original.Twin(h) < h && limit < small)
    {
      this->Samples.push_back(
        { 0.5 * (original.Position(from) + original.Position(to)), RatioOfLimit * limit, None });
      this->SampleVertices.push_back(from);
    }
  }
}

//------------------------------------------------------------------------------
/// Assigns each sample to the nearest face.
void DraftFilter::Distribute(
  const HalfEdgeMesh& mesh, const std::vector<Index>& current, int threads)
{
  const VertexWalk walk(mesh);
  std::vector<Index> faces(this->Samples.size());
  ForEachId(faces.size(), threads,
    [&](std::size_t i) {
      faces[i] = walk.FindNear(this->Samples[i].Position, current[this->SampleVertices[i]]).Face;
    });
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    this->Samples[i].Next = std::exchange(this->FirstSamples[faces[i]], static_cast<Index>(i));
  }
}

//------------------------------------------------------------------------------
bool DraftFilter::KeepUnproved(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor)
{
  const WalkedSurface original(this->Bound.OriginalMesh, this->Bound.OriginalTree, this->Limits);
  this->IsKept.assign(this->FirstSamples.size(), 0);
  return ForEachChunk(this->IsKept.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      const std::shared_ptr<Prover> prover = this->Bound.BorrowProver();
      for (std::size_t i = first; i < last; ++i)
      {
        const FaceId face = static_cast<Index>(i);
        const bool isProved = !mesh.IsAlive(face) ||
          prover->NewFaceProof.Prove(
            original, PositionsOf(mesh, face), this->Bound.NearTriangles[mesh.Corners(face)[0]]);
        this->IsKept[i] = isProved ? 0 : 1;
      }
    });
}

//------------------------------------------------------------------------------
bool DraftFilter::HasKeptFace(const SurfaceChange& change) const
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
    mesh.MovesFreely(change.Ends[0]) && mesh.MovesFreely(change.Ends[1]) &&
    !this->HasKeptFace(change);
  return isFree ? Rejection::NotRejected : Rejection::Boundary;
}

//------------------------------------------------------------------------------
Decision DraftFilter::Check(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  Pending& work = static_cast<Pending&>(pending);
  if (change.NewFaces.size() > CommonFaceProof::MaxCandidates - Coverage::SlotsPerElement)
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
  work.Reassigned.clear();
  work.IsLimited = false;
  for (const Index old : change.OldFaces)
  {
    for (Index s = this->FirstSamples[old]; s != None; s = this->Samples[s].Next)
    {
      const Sample& sample = this->Samples[s];
      work.IsLimited = work.IsLimited || sample.Limit < SmallLimitRatio * this->Limits.Max();
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
      work.Reassigned.push_back({ s, change.NewFaces[nearest].Id });
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool DraftFilter::NewFacesAreNear(const SurfaceChange& change, Pending& work) const
{
  const WalkedSurface original(this->Bound.OriginalMesh, this->Bound.OriginalTree, this->Limits);
  const auto isNear = [&](const Vector3& p)
  {
    const PieceCover<3>::Corner found = original.Find(p, work.Nearest);
    work.Nearest = found.Nearest;
    return found.Distance <= RatioOfLimit * original.Limit(found.Nearest);
  };
  work.Nearest = this->Bound.NearTriangles[change.MovedVertex];
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
/// Where the separation is small, limits vary from triangle to triangle, and a few points prove
/// little.
bool DraftFilter::FacesAreProved(
  const SurfaceChange& change, const WalkedSurface& original, Index nearest) const
{
  const std::shared_ptr<Prover> prover = this->Bound.BorrowProver();
  return std::all_of(change.NewFaces.begin(), change.NewFaces.end(),
    [&](const SurfaceChange::Face& face)
    { return prover->NewFaceProof.Prove(original, face.Corners, nearest); });
}

//------------------------------------------------------------------------------
void DraftFilter::Commit(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending, Tally&)
{
  const Pending& work = static_cast<const Pending&>(pending);
  this->Bound.NearTriangles[change.MovedVertex] = work.Nearest;
  for (const Index old : change.OldFaces)
  {
    this->FirstSamples[old] = None;
  }
  for (const Pending::Reassignment& sample : work.Reassigned)
  {
    this->Samples[sample.Sample].Next =
      std::exchange(this->FirstSamples[sample.Face], sample.Sample);
  }
}
}
