// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeMover.h"

#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MovesOfReport = 256;
}

bool VolumeMover::Run(const Monitor& monitor)
{
  return this->MeshEditor.FlipAndMove([&] { return this->MoveAll(monitor); }, &this->Workspace) &&
    monitor(1.0);
}

//------------------------------------------------------------------------------
bool VolumeMover::MoveAll(const Monitor& monitor)
{
  const std::vector<Height> heights = this->SampledHeights();
  this->MeasureLost(heights);
  std::vector<Candidate> candidates = this->FindCandidates(heights);
  std::sort(candidates.begin(), candidates.end());
  const double count = static_cast<double>(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (i % MovesOfReport == 0 && !monitor(static_cast<double>(i) / count))
    {
      return false;
    }
    this->MoveAt(candidates[i]);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Measures the lost volume of each component. For open components, which have no volume, it is the
/// volume between samples and faces.
void VolumeMover::MeasureLost(const std::vector<Height>& heights)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const FragmentGuard& components = this->MeshEditor.Components();
  this->Lost.assign(static_cast<std::size_t>(components.Count()), 0.0);
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      this->Lost[components.ComponentOf(mesh.Corners(face)[0])] +=
        heights[face].Sum * mesh.Unit() * mesh.Unit();
    }
  }
  for (Index i = 0; i < components.Count(); ++i)
  {
    const double lost = components.LostVolume(i);
    this->Lost[i] = lost != 0.0 ? lost : this->Lost[i];
  }
}

//------------------------------------------------------------------------------
/// Finds the vertices whose moves restore volume and bring the faces nearer to the samples.
std::vector<VolumeMover::Candidate> VolumeMover::FindCandidates(
  const std::vector<Height>& heights) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  std::vector<Candidate> candidates;
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    const double lost = this->Lost[this->MeshEditor.Components().ComponentOf(v)];
    if (mesh.Outgoing(v) == None || !MayMove(mesh, v) || lost == 0.0)
    {
      continue;
    }
    double sum = 0.0;
    double weight = 0.0;
    for (const HalfEdgeId h : mesh.OutgoingOf(v))
    {
      sum += heights[HalfEdgeMesh::Face(h)].Sum;
      weight += heights[HalfEdgeMesh::Face(h)].Weight;
    }
    if (sum * lost > 0.0)
    {
      candidates.push_back({ std::abs(sum / weight), lost > 0.0 ? 1.0 : -1.0, v });
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
std::vector<VolumeMover::Height> VolumeMover::SampledHeights() const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  std::vector<Height> heights(static_cast<std::size_t>(mesh.NumberOfFaceSlots()));
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (!mesh.IsAlive(face))
    {
      continue;
    }
    const TriangleFrame frame = FrameOf(mesh, face);
    this->OriginalSamples.VisitFace(face,
      [&](const Samples::Sample& sample)
      {
        const Vector3 p = this->OriginalSamples.SamplePosition(sample);
        const double height = Dot(frame.UnitNormal(), p - frame.At(frame.Nearest(p)));
        heights[face].Sum += sample.Weight * height;
        heights[face].Weight += sample.Weight;
      });
  }
  return heights;
}

//------------------------------------------------------------------------------
/// The sum of the area vectors of the ring, mm^2. A move changes the volume by a third of its
/// product with the move.
Vector3 VolumeMover::RingArea(VertexId vertex) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  Vector3 area = Vector3::Zero();
  for (const HalfEdgeId h : mesh.OutgoingOf(vertex))
  {
    area +=
      AreaVector(mesh.Position(vertex), mesh.Position(mesh.Target(h)), mesh.Position(mesh.Apex(h)));
  }
  return area;
}

//------------------------------------------------------------------------------
/// Moves by no more than restores the volume of the component.
void VolumeMover::MoveAt(const Candidate& candidate)
{
  const VertexId vertex = candidate.Vertex;
  double& lost = this->Lost[this->MeshEditor.Components().ComponentOf(vertex)];
  const Vector3 area = this->RingArea(vertex);
  const double length = area.norm();
  if (lost * candidate.Sign <= 0.0 || !(length > 0.0))
  {
    return;
  }
  constexpr int attempts = 2;
  constexpr double nextAttempt = 0.5; // of the height
  double height = candidate.Sign * std::min(candidate.Height, 3.0 * std::abs(lost) / length);
  for (int attempt = 0; attempt < attempts; ++attempt, height *= nextAttempt)
  {
    const Vector3 before = this->MeshEditor.Mesh().Position(vertex);
    const SlackMover::Proposal proposal = this->Mover.Shift(vertex, (height / length) * area);
    if (proposal.Vertex != None && this->Mover.Apply(proposal, this->Workspace))
    {
      lost -= Dot(area, this->MeshEditor.Mesh().Position(vertex) - before) / 3.0;
      return;
    }
  }
}
}
