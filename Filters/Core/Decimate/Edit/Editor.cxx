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
  : Half(std::move(mesh))
  , KeepsQuadrics(settings.KeepsQuadrics)
  , Source(clean, settings.RecordsDistances, settings.Reference)
  , KnowsAround(settings.Reference == nullptr || settings.EditZone)
{
  if (!settings.SmoothedPositions.empty())
  {
    this->Source.KeepUnsmoothed(this->Half, settings.SmoothedPositions);
    for (Index v = 0; v < this->Half.NumberOfVertexSlots(); ++v)
    {
      this->Half.Move(v, settings.SmoothedPositions[v]);
    }
  }
  if (settings.KeepsAreas)
  {
    this->FaceGeometry.emplace(this->Half);
  }
  if (settings.KeepsQuadrics)
  {
    SumRingQuadrics(this->Half, settings.Threads);
  }
  const auto goesOn = [&monitor] { return !monitor || monitor(0.0); };
  if (settings.RecordsDistances && goesOn())
  {
    this->Source.Tree(settings.Threads, goesOn);
  }
  if ((settings.KeepsInitialMesh || settings.Bound) && settings.Reference == nullptr)
  {
    this->Source.KeepInitial(this->Half);
  }
  this->AddFilters(settings, monitor);
  const std::vector<char> others = this->NearUnproved(settings.IsConstrained);
  if (!(settings.Tolerances.empty() && others.empty()) && goesOn())
  {
    this->Total.ConstrainedVertices = this->ConstrainVertices(settings.Tolerances, others);
  }
  if (settings.CollapsesFeatureCurves && goesOn())
  {
    this->Curves = std::make_unique<PatchBoundaries>(this->Half);
  }
}

Editor::~Editor() = default;

//------------------------------------------------------------------------------
/// In order: an edit is rejected by the first one. What is checked quickly or rejects most comes
/// first, voxels before an error bound that allows large edits, and the recorder of accepted edits
/// last. Filters read the mesh before vertices are constrained by tolerances.
void Editor::AddFilters(const EditorSettings& settings, const Monitor& monitor)
{
  const bool isAborted = monitor && !monitor(0.0);
  this->GuardsVoxels = settings.Voxels && !isAborted;
  const bool voxelsFirst = this->GuardsVoxels &&
    (!settings.Bound ||
      VoxelGuard::ChecksBeforeBound(settings.Voxels->Grid, settings.Bound->Error));
  const CleanSurface& clean = this->Source.CleanInput();
  this->Fragments = std::make_shared<FragmentGuard>(
    this->Half, clean.Surface, clean.ManifoldPatches.OriginalVertices);
  this->Filters.push_back(this->Fragments);
  if (!settings.Shape.IsAny())
  {
    this->Filters.push_back(
      std::make_shared<ShapeFilter>(settings.Shape, this->Half, settings.Threads));
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
  if (this->Source.IsSmoothed())
  {
    this->Recorder->BeginPatch(this->Source.BoundedMesh());
    this->Recorder->EndPatch(this->Half);
  }
}

//------------------------------------------------------------------------------
void Editor::AddIntersectionGuard(const EditorSettings& settings, const Monitor& monitor)
{
  this->Guard = WithJoined(this->Source.CleanInput(),
    [&](const Surface& joined)
    {
      Surface smoothed;
      if (this->Source.IsSmoothed())
      {
        smoothed = joined;
        for (Index v = 0; v < this->Half.NumberOfVertexSlots(); ++v)
        {
          smoothed.Points[v] = this->Half.Position(v);
        }
      }
      return std::make_shared<IntersectionGuard>(this->Half,
        this->Source.IsSmoothed() ? smoothed : joined,
        WrittenBy(settings, this->Source.CleanInput()), settings.Bound->Error, settings.GuardsGaps,
        settings.Threads, monitor);
    });
  this->Filters.push_back(this->Guard);
}

//------------------------------------------------------------------------------
void Editor::AddErrorBound(const EditorSettings& settings)
{
  ErrorBoundSettings bound = *settings.Bound;
  const ReferenceMesh* reference = this->Source.Reference();
  if (reference != nullptr)
  {
    this->BoundFilter = std::make_shared<ErrorBound>(*reference, this->Half, bound);
    this->Unproved = ProveStart(*this->BoundFilter, *reference, this->Half,
      settings.EditZone ? &*settings.EditZone : nullptr, settings.Threads);
  }
  else
  {
    bound.Tolerances = settings.Tolerances.empty() ? nullptr : &settings.Tolerances;
    this->BoundFilter = std::make_shared<ErrorBound>(
      this->Source.BoundedMesh(), this->Source.Tree(settings.Threads), bound);
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
  for (FaceId face = 0; face < this->Half.NumberOfFaceSlots(); ++face)
  {
    const Triangle corners = this->Half.Corners(face);
    if (std::any_of(corners.begin(), corners.end(), isConstrained))
    {
      std::for_each(
        corners.begin(), corners.end(), [this](VertexId v) { this->Half.Constrain(v); });
    }
  }
  Index count = 0;
  for (VertexId v = 0; v < this->Half.NumberOfVertexSlots(); ++v)
  {
    count += isConstrained(v) && this->Half.OriginalVertex(v) == v ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
/// Adds the corners of faces that may be what a triangle of the reference is near to, although this
/// was not proved.
/// @param constrained For each vertex, whether it is constrained; empty: none is.
std::vector<char> Editor::NearUnproved(std::vector<char> constrained) const
{
  constrained.resize(this->Unproved.empty()
      ? constrained.size()
      : static_cast<std::size_t>(this->Half.NumberOfVertexSlots()),
    0);
  const ReferenceMesh* reference = this->Source.Reference();
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
    this->Source.Tree().VisitNear(middle, squaredReach,
      [&](Index face)
      {
        for (const Index corner : this->Half.Corners(face))
        {
          constrained[corner] = 1;
        }
      });
  }
  return constrained;
}

//------------------------------------------------------------------------------
/// Lists in a tally keep their memory.
void Editor::Settle(Tally* tallies, std::size_t count)
{
  for (const std::shared_ptr<EditFilter>& filter : this->Filters)
  {
    filter->Settle(tallies, count);
  }
  for (Tally* tally = tallies; tally != tallies + count; ++tally)
  {
    this->Half.CountRemovedFaces(tally->RemovedFaces);
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
bool Editor::FlipAndMove(const std::function<bool()>& edits, Workspace* work)
{
  const bool isOuter = !std::exchange(this->IsInPass, true);
  const bool isLogged = this->Recorder && isOuter;
  if (isLogged)
  {
    this->Recorder->BeginPatch(this->Half);
  }
  this->Fragments->DistributeBudget(this->Half);
  const bool goesOn = edits();
  if (work != nullptr)
  {
    this->Settle(&work->Counted);
  }
  if (isLogged)
  {
    this->Recorder->EndPatch(this->Half);
  }
  this->IsInPass = !isOuter;
  return goesOn;
}

//------------------------------------------------------------------------------
void Editor::PrepareCollapses(int threads)
{
  this->Fragments->DistributeBudget(this->Half);
  if (this->KeepsQuadrics)
  {
    SumRingQuadrics(this->Half, threads);
  }
}
}
