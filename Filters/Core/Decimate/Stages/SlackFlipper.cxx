// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlackFlipper.h"

#include "Decimate/Edit/FlipAndMoveRules.h"

namespace bonedecimate
{
namespace
{
/// Faces below this ratio are not flipped.
constexpr double MinRatioOfFlip = 0.8;
/// The fraction to which the error must fall.
constexpr double FlipBelowError = 0.9;
constexpr Index FacesOfReport = 1024;
}

bool SlackFlipper::Run(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const double count = mesh.NumberOfFaceSlots();
  const auto flip = [&]
  {
    bool shouldContinue = true;
    for (FaceId face = 0; face < mesh.NumberOfFaceSlots() && shouldContinue; ++face)
    {
      shouldContinue = face % FacesOfReport != 0 || monitor(face / count);
      for (Index corner = 0; corner < 3 && shouldContinue && mesh.IsAlive(face); ++corner)
      {
        this->TryFlip(HalfEdgeMesh::HalfEdge(face, corner));
      }
    }
    return shouldContinue;
  };
  return this->MeshEditor.FlipAndMove(flip, &this->Workspace) && monitor(1.0);
}

//------------------------------------------------------------------------------
void SlackFlipper::TryFlip(HalfEdgeId edge)
{
  const HalfEdgeId twin = this->MeshEditor.Mesh().Twin(edge);
  if (twin != None && edge < twin && this->Improves(edge) &&
    this->MeshEditor.Try(FlipOf(edge), this->Workspace).IsAccepted())
  {
    // The samples go where the last evaluation found them.
    this->OriginalSamples.HandOver(
      { HalfEdgeMesh::Face(edge), HalfEdgeMesh::Face(twin) }, this->Slack.Members());
  }
}

//------------------------------------------------------------------------------
/// @param corners The common vertex of both faces, then their other corners in order.
/// @param faces The faces whose samples belong to them.
void SlackFlipper::Gather(const std::array<Vector3, 4>& corners, const std::array<FaceId, 2>& faces)
{
  this->Slack.Clear();
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Slack.AddFace(corners[i + 1], corners[i + 2]);
    this->Slack.AddSamples(faces[i], i);
  }
}

//------------------------------------------------------------------------------
bool SlackFlipper::Improves(HalfEdgeId edge)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const std::array<Index, 4> ids = CornersAround(mesh, edge);
  const auto [a, b, c, d] = PositionsOf(mesh, ids);
  const std::array<FaceId, 2> faces = { HalfEdgeMesh::Face(edge),
    HalfEdgeMesh::Face(mesh.Twin(edge)) };
  this->Gather({ a, d, b, c }, { faces[1], faces[0] });
  const SlackFit::Value now = this->Slack.EvaluatePair(a, this->Hints.Of(ids[0]), Infinity);
  if (!(now.MaxRatio > MinRatioOfFlip && now.MaxRatio < Infinity))
  {
    return false;
  }
  this->Gather({ c, a, d, b }, faces);
  return this->Slack.EvaluatePair(c, this->Hints.Of(ids[2]), FlipBelowError * now.Error).Error <
    FlipBelowError * now.Error;
}
}
