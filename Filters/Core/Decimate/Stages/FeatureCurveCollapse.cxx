// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureCurveCollapse.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bonedecimate
{
namespace
{
constexpr Index PassesForAll = 4;
constexpr int MaxPasses = 16;
constexpr Index CandidatesPerReport = 256;

/// The boundary half-edge between v and a duplicate of the other original vertex; None if there is
/// none.
HalfEdgeId BoundaryEdgeTo(const HalfEdgeMesh& mesh, VertexId v, VertexId original)
{
  if (mesh.IsConstrained(v) || !mesh.IsOnBoundary(v))
  {
    return None;
  }
  HalfEdgeId last;
  for (const HalfEdgeId h : mesh.OutgoingOf(v))
  {
    last = HalfEdgeMesh::Previous(h);
  }
  const HalfEdgeId first = mesh.Outgoing(v);
  return mesh.OriginalVertex(mesh.Target(first)) == original ? first
    : mesh.OriginalVertex(mesh.Origin(last)) == original     ? last
                                                             : HalfEdgeId();
}

/// Collapses of the removed vertex onto the other one, one per patch. Empty unless the two are
/// joined by one edge in each patch.
void FindEdits(const HalfEdgeMesh& mesh, VertexId gone, VertexId stays, std::vector<Edit>& edits)
{
  edits.clear();
  Index duplicate = gone;
  do
  {
    const HalfEdgeId edge =
      mesh.Outgoing(duplicate) == None ? HalfEdgeId() : BoundaryEdgeTo(mesh, duplicate, stays);
    const VertexId keep = edge == None ? VertexId() : mesh.OtherEnd(edge, duplicate);
    const bool isTaken = std::any_of(
      edits.begin(), edits.end(), [keep](const Edit& edit) { return edit.Keep == keep; });
    if (keep == None || isTaken || mesh.IsConstrained(keep))
    {
      edits.clear();
      return;
    }
    edits.push_back({ edge, keep, mesh.Position(keep), true });
    duplicate = mesh.NextDuplicate(duplicate);
  } while (duplicate != gone);
}

/// The original vertices next to this one on patch boundaries.
void FindBeside(const HalfEdgeMesh& mesh, Index original, std::vector<Index>& originals)
{
  originals.clear();
  Index duplicate = original;
  do
  {
    if (mesh.Outgoing(duplicate) != None)
    {
      const std::array<Index, 2> beside = BoundaryNeighbors(mesh, duplicate);
      originals.insert(originals.end(), beside.begin(), beside.end());
    }
    duplicate = mesh.NextDuplicate(duplicate);
  } while (duplicate != original);
}
}

/// Whether three curves would become a triangle. The patches between them could then degenerate to
/// that triangle and coincide.
bool FeatureCurveCollapse::MakesTriangle(Index index)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  FindBeside(mesh, this->FeatureCurves.OriginalVertex(this->FeatureCurves.Before(index)),
    this->BesideBefore);
  FindBeside(
    mesh, this->FeatureCurves.OriginalVertex(this->FeatureCurves.After(index)), this->BesideAfter);
  return std::any_of(this->BesideBefore.begin(), this->BesideBefore.end(),
    [&](Index original)
    {
      return original != None && original != this->FeatureCurves.OriginalVertex(index) &&
        std::find(this->BesideAfter.begin(), this->BesideAfter.end(), original) !=
        this->BesideAfter.end();
    });
}

//------------------------------------------------------------------------------
FeatureCurveCollapse::Result FeatureCurveCollapse::Run(
  const Targets& targets, const Monitor& monitor)
{
  Result result;
  const Index most =
    1 + std::max(0, this->FeatureCurves.NumberOfEdges() - targets.Edges) / PassesForAll;
  const auto isFine = [&] { return this->FeatureCurves.NumberOfEdges() > targets.Edges; };
  for (int pass = 0; pass < MaxPasses && isFine(); ++pass)
  {
    const Index gone = this->Pass(targets, most, monitor, result);
    result.Removed += gone;
    if (gone == 0 || result.IsAborted)
    {
      break;
    }
  }
  return result;
}

//------------------------------------------------------------------------------
/// Lists candidates by deviation, equal ones by length.
void FeatureCurveCollapse::ListCandidates(double maxDeviation, Result& result)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const ErrorBound* bound = this->MeshEditor.Bound();
  const auto limit = [bound](Index original)
  { return bound != nullptr ? bound->LimitAt(original) : Infinity; };
  this->Candidates.clear();
  result.IsLimited = false;
  for (Index index = 0; index < this->FeatureCurves.NumberOfPositions(); ++index)
  {
    if (!this->FeatureCurves.IsRemovable(index))
    {
      continue;
    }
    const double deviation = this->FeatureCurves.Deviation(mesh, index, limit);
    if (deviation <= maxDeviation)
    {
      const Vector3& before =
        mesh.Position(this->FeatureCurves.OriginalVertex(this->FeatureCurves.Before(index)));
      const Vector3& after =
        mesh.Position(this->FeatureCurves.OriginalVertex(this->FeatureCurves.After(index)));
      this->Candidates.push_back({ deviation, (after - before).norm(), index });
    }
    result.IsLimited |= deviation > maxDeviation && std::isfinite(deviation);
  }
  std::sort(this->Candidates.begin(), this->Candidates.end(),
    [](const Candidate& a, const Candidate& b)
    {
      return std::tie(a.Deviation, a.Length, a.CurveIndex) <
        std::tie(b.Deviation, b.Length, b.CurveIndex);
    });
}

//------------------------------------------------------------------------------
Index FeatureCurveCollapse::Pass(
  const Targets& targets, Index most, const Monitor& monitor, Result& result)
{
  this->ListCandidates(targets.MaxDeviation, result);
  this->WasTouched.assign(static_cast<std::size_t>(this->FeatureCurves.NumberOfPositions()), 0);
  const Index allowed = std::min(most, this->FeatureCurves.NumberOfEdges() - targets.Edges);
  Index gone = 0;
  Index visited = 0;
  for (const Candidate& candidate : this->Candidates)
  {
    if (++visited % CandidatesPerReport == 0 && !monitor(0.0))
    {
      result.IsAborted = true;
      return gone;
    }
    if (gone < allowed && this->WasTouched[candidate.CurveIndex] == 0 &&
      this->TryRemove(candidate.CurveIndex, targets.Faces))
    {
      ++gone;
    }
  }
  return gone;
}

//------------------------------------------------------------------------------
bool FeatureCurveCollapse::TryRemove(Index index, Index faces)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const Index before = this->FeatureCurves.Before(index);
  const Index after = this->FeatureCurves.After(index);
  const VertexId original = this->FeatureCurves.OriginalVertex(index);
  VertexId near = this->FeatureCurves.OriginalVertex(before);
  VertexId far = this->FeatureCurves.OriginalVertex(after);
  const Vector3& p = mesh.Position(original);
  if ((mesh.Position(far) - p).squaredNorm() < (mesh.Position(near) - p).squaredNorm())
  {
    std::swap(near, far);
  }
  if (this->MakesTriangle(index) ||
    (!this->CollapseOnto(original, near, faces) && !this->CollapseOnto(original, far, faces)))
  {
    return false;
  }
  this->FeatureCurves.Remove(index);
  this->WasTouched[before] = this->WasTouched[after] = 1;
  return true;
}

//------------------------------------------------------------------------------
bool FeatureCurveCollapse::CollapseOnto(VertexId gone, VertexId stays, Index faces)
{
  FindEdits(this->MeshEditor.Mesh(), gone, stays, this->Edits);
  const auto removed = static_cast<Index>(this->Edits.size()); // each removes one face
  return removed > 0 && this->MeshEditor.Mesh().NumberOfFaces() - removed >= faces &&
    this->MeshEditor.Try(this->Edits).IsAccepted();
}
}
