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
/// mm, of each vertex of the original; empty unless the error bound refers to it.
std::vector<float> LimitsOf(const Editor& editor, const HalfEdgeMesh& original)
{
  return editor.Bound() != nullptr && &original == &editor.Original().BoundedMesh()
    ? editor.Bound()->LimitsOfVertices()
    : std::vector<float>();
}
}

Refinement::Refinement(
  Editor& editor, const HalfEdgeMesh& original, double shapeWeight, int threads)
  : MeshEditor(editor)
  , Fit(original, editor.Bound() == nullptr, LimitsOf(editor, original),
      editor.LimitsEdits() ? 0.0 : shapeWeight)
  , Back(original, editor.Original().NearInitial())
  , Threads(threads)
{
}

//------------------------------------------------------------------------------
bool Refinement::Begin(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  this->IsSettled = this->Back.Restart(mesh, this->Threads, PartOf(monitor, 0.0, 0.1)) &&
    this->Fit.Distribute(mesh, this->MeshEditor.Original().CurrentOfInitial(), this->Threads,
      PartOf(monitor, 0.1, 1.0));
  return this->IsSettled;
}

//------------------------------------------------------------------------------
bool Refinement::Settle(const Monitor& monitor)
{
  this->IsSettled =
    this->IsSettled || this->Fit.Settle(this->MeshEditor.Mesh(), this->Threads, monitor);
  return this->IsSettled && monitor(1.0);
}

//------------------------------------------------------------------------------
bool Refinement::Sweep(int times, const Monitor& monitor)
{
  constexpr double settledAt = 0.06;
  constexpr double flippedAt = 0.45;
  return this->MeshEditor.FlipAndMove(
    [&]
    {
      bool goesOn = true;
      for (int i = 0; i < times && goesOn; ++i)
      {
        const Monitor sweep = PartOf(monitor, static_cast<double>(i) / times, (i + 1.0) / times);
        goesOn = this->Settle(PartOf(sweep, 0.0, settledAt)) &&
          this->FlipEdges(PartOf(sweep, settledAt, flippedAt)) &&
          this->MoveVertices(PartOf(sweep, flippedAt, 1.0));
      }
      return goesOn;
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
    return [flipper = EdgeFlipper(this->MeshEditor, this->Fit, this->Back, faceErrors, range,
              blocks.Count())](VertexId v) mutable { flipper.Improve(v); };
  };
  return this->MeshEditor.FlipAndMove([&]
    { return blocks.ForEach(this->MeshEditor.Mesh(), this->EditThreads(), monitor, makeFlipper); });
}

//------------------------------------------------------------------------------
bool Refinement::MoveVertices(const Monitor& monitor)
{
  this->IsSettled = false;
  VertexBlocks blocks(this->MeshEditor.Mesh());
  const auto makeMover = [&](VertexRange range)
  {
    return [mover = VertexMover(this->MeshEditor, this->Fit, this->Back, range, blocks.Count())](
             VertexId v) mutable { mover.Improve(v); };
  };
  return this->MeshEditor.FlipAndMove([&]
    { return blocks.ForEach(this->MeshEditor.Mesh(), this->EditThreads(), monitor, makeMover); });
}

//------------------------------------------------------------------------------
bool Refinement::CollapseTo(Index faces, int edgesOfCollapse, const Monitor& monitor)
{
  constexpr double settledAt = 0.1;
  this->MeshEditor.PrepareCollapses(this->Threads);
  return this->Settle(PartOf(monitor, 0.0, settledAt)) &&
    ErrorCollapse(this->MeshEditor, this->Fit, this->Back, edgesOfCollapse, this->Threads)
      .Run(faces, PartOf(monitor, settledAt, 1.0));
}
}
