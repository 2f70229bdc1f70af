// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement.h"

#include "EdgeFlipper.h"
#include "ErrorCollapse.h"
#include "VertexBlocks.h"
#include "VertexMover.h"

namespace bonedecimate
{
namespace
{
/// The limit at each vertex of the original, mm; empty unless the error bound refers to it.
std::vector<float> LimitsOf(const Editor& editor, const HalfEdgeMesh& original)
{
  return editor.Bound() != nullptr && &original == &editor.Original().BoundedMesh()
    ? editor.Bound()->LimitsOfVertices()
    : std::vector<float>();
}
}

Refinement::Refinement(
  Editor& editor, const HalfEdgeMesh& original, double shapeWeight, int threads)
  : SampledRefinement(editor,
      Samples(original, editor.Bound() == nullptr, LimitsOf(editor, original),
        editor.LimitsEdits() ? 0.0 : shapeWeight),
      original, threads)
{
}

//------------------------------------------------------------------------------
bool Refinement::Sweep(int times, const Monitor& monitor)
{
  constexpr double flippedAt = 0.41;
  return this->RepeatSweeps(times, monitor,
    [this](const Monitor& sweep)
    {
      return this->FlipEdges(PartOf(sweep, 0.0, flippedAt)) &&
        this->MoveVertices(PartOf(sweep, flippedAt, 1.0));
    });
}

//------------------------------------------------------------------------------
bool Refinement::FlipEdges(const Monitor& monitor)
{
  VertexBlocks blocks(this->MeshEditor.Mesh());
  std::vector<float> faceErrors(
    static_cast<std::size_t>(this->MeshEditor.Mesh().NumberOfFaceSlots()), -1.0F);
  const auto makeFlipper = [&](VertexRange range)
  {
    return [flipper = EdgeFlipper(this->MeshEditor, this->OriginalSamples, this->Hints, faceErrors,
              range, blocks.Count())](VertexId v) mutable { flipper.Improve(v); };
  };
  return this->MeshEditor.FlipAndMove(
    [&] { return blocks.ForEach(this->MeshEditor.Mesh(), this->Threads, monitor, makeFlipper); });
}

//------------------------------------------------------------------------------
bool Refinement::MoveVertices(const Monitor& monitor)
{
  this->IsSettled = false;
  VertexBlocks blocks(this->MeshEditor.Mesh());
  const auto makeMover = [&](VertexRange range)
  {
    return [mover = VertexMover(this->MeshEditor, this->OriginalSamples, this->Hints, range,
              blocks.Count())](VertexId v) mutable { mover.Improve(v); };
  };
  return this->MeshEditor.FlipAndMove(
    [&] { return blocks.ForEach(this->MeshEditor.Mesh(), this->Threads, monitor, makeMover); });
}

//------------------------------------------------------------------------------
bool Refinement::CollapseTo(Index faces, int edgesOfCollapse, const Monitor& monitor)
{
  this->MeshEditor.PrepareCollapses(this->Threads);
  return this->SettleSamples(PartOf(monitor, 0.0, SettledAt)) &&
    ErrorCollapse(
      this->MeshEditor, this->OriginalSamples, this->Hints, edgesOfCollapse, this->Threads)
      .Run(faces, PartOf(monitor, SettledAt, 1.0));
}
}
