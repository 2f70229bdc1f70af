// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of BucketSweep for edits that an error bound or voxels limit.
#include "BatchSweep.h"
#include "BucketSweep.h"

namespace bonedecimate
{
namespace
{
/// No further pass after one that removes less than one face in this many.
constexpr Index MinOfPass = 128;
}

/// The final number of faces is not known. Rejected edges wait for the next pass, which tries all
/// positions.
StopReason BucketSweep::RunProved(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!this->MakeDraft(monitor))
  {
    return StopReason::Aborted;
  }
  Index facesBefore = 0;
  for (int pass = 0; !this->End.IsReached(); ++pass)
  {
    if (pass > 1 && facesBefore - mesh.NumberOfFaces() <= facesBefore / MinOfPass)
    {
      return this->MeshEditor.Totals().MetErrorBound() ? StopReason::ErrorReached
                                                       : StopReason::NothingLeft;
    }
    facesBefore = mesh.NumberOfFaces();
    this->TriesAll = pass > 0;
    if (pass < 2)
    {
      this->Data.NoteAllChanged();
    }
    const bool isDone = this->RenewAll(monitor) &&
      (this->MeshEditor.Bound() == nullptr
          ? this->PassInRounds(monitor)
          : BatchSweep(this->MeshEditor, this->Evaluate, this->Data, this->Threads)
              .Run(this->WholeTask(LastBucket, this->Targets.Faces), this->End, monitor));
    if (!isDone)
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
/// False if the monitor requests a stop; then the whole draft is undone.
bool BucketSweep::MakeDraft(const Monitor& monitor)
{
  const auto collapse = [&]
  {
    this->TriesAll = false;
    this->Data.NoteAllChanged();
    return this->RenewAll(monitor) && this->PassInRounds(monitor);
  };
  return this->End.IsReached() ||
    this->MeshEditor.MakeDraft(
      this->Threads, collapse, [&](double) { return this->End.ReportNow(monitor); });
}

//------------------------------------------------------------------------------
/// False if the monitor requests a stop.
bool BucketSweep::PassInRounds(const Monitor& monitor)
{
  const Index half = this->MeshEditor.Mesh().NumberOfFaces() / 4; // of the vertices
  CostBucket limit = this->HasRounds() && !this->TriesAll ? this->FirstLimit(half) : LastBucket;
  bool shouldContinue = !this->HasRounds() || this->Round(limit, monitor);
  while (shouldContinue && limit < LastBucket && !this->End.IsReached())
  {
    limit = Raised(limit, MaxStep);
    shouldContinue = this->Round(limit, monitor);
  }
  return shouldContinue &&
    (this->End.IsReached() || this->SweepWhole(LastBucket, this->Targets.Faces, false, monitor));
}
}
