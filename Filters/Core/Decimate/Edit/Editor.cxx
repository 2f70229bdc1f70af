// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Editor.h"

#include "Mesh/ManifoldPatches.h"
#include "Proof/EditFilters/ShapeFilter.h"
#include "Proof/EditFilters/ZoneFilter.h"
#include "Proof/ErrorBound/StartProof.h"
#include "Proof/Guard/IntersectionGuard.h"
#include "RingQuadrics.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
WrittenPositions WrittenBy(const EditorSettings& settings, const CleanSurface& clean)
{
  return settings.Input == nullptr
    ? WrittenPositions()
    : WrittenPositions(*settings.Input, clean, settings.Bound->Error, settings.Bound->Rounding);
}
}

Editor::Editor(const CleanSurface& clean, const EditorSettings& settings)
  : Editor(HalfEdgeMesh(clean.Surface, settings.Threads, clean.ManifoldPatches), clean, settings)
{
}

//------------------------------------------------------------------------------
Editor::Editor(HalfEdgeMesh mesh, const CleanSurface& clean, const EditorSettings& settings,
  const Monitor& monitor)
  : CurrentMesh(std::move(mesh))
  , KeepsQuadrics(settings.KeepsQuadrics)
  , OriginalSurface(clean, settings.RecordsDistances, settings.Reference)
  , KnowsOriginalNearby(settings.Reference == nullptr || settings.EditZone)
{
  if (!settings.SmoothedPositions.empty())
  {
    this->OriginalSurface.KeepUnsmoothed(this->CurrentMesh, settings.SmoothedPositions);
    for (Index v = 0; v < this->CurrentMesh.NumberOfVertexSlots(); ++v)
    {
      this->CurrentMesh.Move(v, settings.SmoothedPositions[v]);
    }
  }
  if (settings.KeepsAreas)
  {
    this->FaceGeometry.emplace(this->CurrentMesh);
  }
  if (settings.KeepsQuadrics)
  {
    SumRingQuadrics(this->CurrentMesh, settings.Threads);
  }
  const auto shouldContinue = [&monitor] { return !monitor || monitor(0.0); };
  if (settings.RecordsDistances && shouldContinue())
  {
    this->OriginalSurface.Tree(settings.Threads, shouldContinue);
  }
  if ((settings.KeepsInitialMesh || settings.Bound) && settings.Reference == nullptr)
  {
    this->OriginalSurface.KeepInitial(this->CurrentMesh);
  }
  this->AddFilters(settings, monitor);
  const std::vector<char> others = this->NearUnproved(settings.IsConstrained);
  if (!(settings.Tolerances.empty() && others.empty()) && shouldContinue())
  {
    this->Total.ConstrainedVertices = this->ConstrainVertices(settings.Tolerances, others);
  }
  if (settings.CollapsesFeatureCurves && shouldContinue())
  {
    this->Curves = std::make_unique<PatchBoundaries>(this->CurrentMesh);
  }
}

Editor::~Editor() = default;

//------------------------------------------------------------------------------
/// The order matters, because the first filter that rejects an edit ends its check. Quick filters
/// and those that reject most come first, voxels come before an error bound that allows large
/// edits, and the recorder of accepted edits is last. Filters read the mesh before vertices are
/// constrained by tolerances.
void Editor::AddFilters(const EditorSettings& settings, const Monitor& monitor)
{
  const bool isAborted = monitor && !monitor(0.0);
  this->GuardsVoxels = settings.Voxels && !isAborted;
  const bool voxelsFirst = this->GuardsVoxels &&
    (!settings.Bound ||
      VoxelGuard::ChecksBeforeBound(settings.Voxels->Grid, settings.Bound->Error));
  const CleanSurface& clean = this->OriginalSurface.CleanInput();
  this->Fragments = std::make_shared<FragmentGuard>(
    this->CurrentMesh, clean.Surface, clean.ManifoldPatches.OriginalVertices);
  this->Filters.push_back(this->Fragments);
  if (settings.Shape.IsLimited())
  {
    this->Filters.push_back(
      std::make_shared<ShapeFilter>(settings.Shape, this->CurrentMesh, settings.Threads));
  }
  if (voxelsFirst)
  {
    this->Filters.push_back(std::make_shared<VoxelGuard>(*settings.Voxels));
  }
  if (settings.Bound && !isAborted)
  {
    this->AddErrorBound(settings);
  }
  if (this->GuardsVoxels && !voxelsFirst)
  {
    this->Filters.push_back(std::make_shared<VoxelGuard>(*settings.Voxels));
  }
  if (settings.Bound && settings.GuardsIntersections && !isAborted)
  {
    this->AddIntersectionGuard(settings, monitor);
  }
  if (settings.EditZone || settings.Neighbors.Others)
  {
    this->Filters.push_back(std::make_shared<ZoneFilter>(settings.EditZone, settings.Neighbors));
  }
  this->Filters.insert(
    this->Filters.end(), settings.MoreFilters.begin(), settings.MoreFilters.end());
  if (settings.RecordsEdits)
  {
    this->AddRecorder();
  }
  if (this->BoundFilter)
  {
    this->Total.Draft.Status = settings.RecordsEdits ? DraftStatus::EditsAreRecorded
      : settings.Requested.ProveEachEdit             ? DraftStatus::EachEditIsProved
      : settings.MoreFilters.empty()                 ? DraftStatus::NotUsed
                                                     : DraftStatus::MoreFilters;
  }
  this->NeedsSurfaceChange = std::any_of(this->Filters.begin(), this->Filters.end(),
    [](const std::shared_ptr<EditFilter>& filter) { return filter->NeedsSurfaceChange(); });
}

//------------------------------------------------------------------------------
void Editor::AddRecorder()
{
  this->Recorder = std::make_shared<EditRecorder>();
  this->Filters.push_back(this->Recorder);
  if (this->OriginalSurface.IsSmoothed())
  {
    this->Recorder->BeginPatch(this->OriginalSurface.BoundedMesh());
    this->Recorder->EndPatch(this->CurrentMesh);
  }
}

//------------------------------------------------------------------------------
void Editor::AddIntersectionGuard(const EditorSettings& settings, const Monitor& monitor)
{
  this->Guard = WithJoined(this->OriginalSurface.CleanInput(),
    [&](const Surface& joined)
    {
      Surface smoothed;
      if (this->OriginalSurface.IsSmoothed())
      {
        smoothed = joined;
        for (Index v = 0; v < this->CurrentMesh.NumberOfVertexSlots(); ++v)
        {
          smoothed.Points[v] = this->CurrentMesh.Position(v);
        }
      }
      return std::make_shared<IntersectionGuard>(this->CurrentMesh,
        this->OriginalSurface.IsSmoothed() ? smoothed : joined,
        WrittenBy(settings, this->OriginalSurface.CleanInput()), settings.Bound->Error,
        settings.GuardsGaps, settings.Threads, monitor);
    });
  this->Filters.push_back(this->Guard);
}

//------------------------------------------------------------------------------
void Editor::AddErrorBound(const EditorSettings& settings)
{
  ErrorBoundSettings bound = *settings.Bound;
  const ReferenceMesh* reference = this->OriginalSurface.Reference();
  if (reference != nullptr)
  {
    this->BoundFilter = std::make_shared<ErrorBound>(*reference, this->CurrentMesh, bound);
    this->Unproved = ProveStart(*this->BoundFilter, *reference, this->CurrentMesh,
      settings.EditZone ? &*settings.EditZone : nullptr, settings.Threads);
  }
  else
  {
    bound.Tolerances = settings.Tolerances.empty() ? nullptr : &settings.Tolerances;
    this->BoundFilter = std::make_shared<ErrorBound>(
      this->OriginalSurface.BoundedMesh(), this->OriginalSurface.Tree(settings.Threads), bound);
  }
  this->Filters.push_back(this->BoundFilter);
}

//------------------------------------------------------------------------------
Index Editor::ConstrainVertices(
  const std::vector<double>& tolerances, const std::vector<char>& others)
{
  const auto isConstrained = [&](VertexId v)
  {
    const bool isLimited = !tolerances.empty() &&
      (this->BoundFilter ? !(this->BoundFilter->LimitAt(v) > 0.0) : tolerances[v] == 0.0);
    return isLimited || (!others.empty() && others[v] != 0);
  };
  for (FaceId face = 0; face < this->CurrentMesh.NumberOfFaceSlots(); ++face)
  {
    const Triangle corners = this->CurrentMesh.Corners(face);
    if (std::any_of(corners.begin(), corners.end(), isConstrained))
    {
      std::for_each(
        corners.begin(), corners.end(), [this](VertexId v) { this->CurrentMesh.Constrain(v); });
    }
  }
  Index count = 0;
  for (VertexId v = 0; v < this->CurrentMesh.NumberOfVertexSlots(); ++v)
  {
    count += isConstrained(v) && this->CurrentMesh.OriginalVertex(v) == v ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
/// Also constrains the corners of faces that may be near an unproved triangle of the reference.
/// @param constrained For each vertex, whether it is constrained; empty: none is.
std::vector<char> Editor::NearUnproved(std::vector<char> constrained) const
{
  constrained.resize(this->Unproved.empty()
      ? constrained.size()
      : static_cast<std::size_t>(this->CurrentMesh.NumberOfVertexSlots()),
    0);
  const ReferenceMesh* reference = this->OriginalSurface.Reference();
  for (const FaceId triangle : this->Unproved)
  {
    double squaredReach = 0.0;
    Vector3 middle = Vector3::Zero();
    for (const Index corner : reference->Mesh.Corners(triangle))
    {
      middle += reference->Mesh.Position(corner) / 3.0;
    }
    for (const Index corner : reference->Mesh.Corners(triangle))
    {
      const double reach =
        (reference->Mesh.Position(corner) - middle).norm() + this->BoundFilter->LimitAt(corner);
      squaredReach = std::max(squaredReach, reach * reach);
    }
    this->OriginalSurface.Tree().VisitNear(middle, squaredReach,
      [&](Index face)
      {
        for (const Index corner : this->CurrentMesh.Corners(face))
        {
          constrained[corner] = 1;
        }
      });
  }
  return constrained;
}

//------------------------------------------------------------------------------
/// The lists of a tally keep their memory.
void Editor::Settle(Tally* tallies, std::size_t count)
{
  for (const std::shared_ptr<EditFilter>& filter : this->Filters)
  {
    filter->Settle(tallies, count);
  }
  for (Tally* tally = tallies; tally != tallies + count; ++tally)
  {
    this->CurrentMesh.CountRemovedFaces(tally->RemovedFaces);
    this->Total.Collapses += tally->Edits;
    for (std::size_t i = 0; i < NumberOfRejections; ++i)
    {
      this->Total.Rejections[i] += tally->Rejections[i];
    }
    tally->Rejections.fill(0);
    tally->Edits = 0;
    tally->RemovedFaces = 0;
  }
}

//------------------------------------------------------------------------------
bool Editor::FlipAndMove(const std::function<bool()>& edits, EditWorkspace* workspace)
{
  const bool isOuter = !std::exchange(this->IsInPass, true);
  const bool isLogged = this->Recorder && isOuter;
  if (isLogged)
  {
    this->Recorder->BeginPatch(this->CurrentMesh);
  }
  this->Fragments->DistributeBudget(this->CurrentMesh);
  const bool shouldContinue = edits();
  if (workspace != nullptr)
  {
    this->Settle(&workspace->Counts);
  }
  if (isLogged)
  {
    this->Recorder->EndPatch(this->CurrentMesh);
  }
  this->IsInPass = !isOuter;
  return shouldContinue;
}

//------------------------------------------------------------------------------
void Editor::PrepareCollapses(int threads)
{
  this->Fragments->DistributeBudget(this->CurrentMesh);
  if (this->KeepsQuadrics)
  {
    SumRingQuadrics(this->CurrentMesh, threads);
  }
}
}
