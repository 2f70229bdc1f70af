// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchFit.h"

#include "Decimate/Edit/FlipAndMoveRules.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr int MaxSweeps = 8;
/// A vertex whose faces have a smaller ratio does not move.
constexpr double RatioToMove = 0.9;
/// A little less than the bound, for what the samples miss.
constexpr double MaxProposedRatio = 0.99;
/// The relative gain that a sweep must reach. The excess must not be larger than what the remaining
/// sweeps gain, times a factor.
constexpr double MinGainOfSweep = 0.002;
constexpr double MaxGainsNeeded = 1.2;
}

PatchFit::PatchFit(
  const Editor& editor, const Samples& samples, const OriginalHints& hints, int rings)
  : Rings(rings)
  , Mesh(editor.Mesh())
  , Hints(hints)
  , Slack(editor, samples, hints)
{
}

//------------------------------------------------------------------------------
PatchFit::Result PatchFit::Fit(const EdgeNeighborhood& around, const SlackCandidate& candidate)
{
  this->Copy(around, candidate);
  return this->SweepUntilWithin() ? this->MakeResult(around) : Result();
}

//------------------------------------------------------------------------------
void PatchFit::Copy(const EdgeNeighborhood& around, const SlackCandidate& candidate)
{
  this->Vertices.clear();
  this->Faces.clear();
  this->Flips.clear();
  this->Vertices.push_back({ around.Start, candidate.Position, candidate.Hint, {} });
  std::vector<Corner> fan;
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    const std::size_t second = this->VertexOf(around.Ring[i]);
    fan.push_back({ this->FaceOf(HalfEdgeMesh::Face(around.Corners[i])), second,
      this->VertexOf(around.RingAfter(i)) });
  }
  this->Vertices[0].Fan = std::move(fan);
  std::size_t from = 1;
  for (int ring = 0; ring < this->Rings; ++ring)
  {
    const std::size_t end = this->Vertices.size();
    for (; from < end; ++from)
    {
      if (MayMove(this->Mesh, this->Vertices[from].Id))
      {
        this->CopyRing(this->Vertices[from].Id, around);
      }
    }
  }
  this->CopySamples(around);
}

//------------------------------------------------------------------------------
/// Copies the ring of a vertex beside the edge, as after the collapse.
void PatchFit::CopyRing(VertexId vertex, const EdgeNeighborhood& around)
{
  const auto merged = [&](VertexId v) { return v == around.End ? around.Start : v; };
  std::vector<Corner> fan;
  for (const HalfEdgeId h : this->Mesh.OutgoingOf(vertex))
  {
    const FaceId face = HalfEdgeMesh::Face(h);
    if (face != around.RemovedFaces[0] && face != around.RemovedFaces[1])
    {
      const std::size_t second = this->VertexOf(merged(this->Mesh.Target(h)));
      fan.push_back({ this->FaceOf(face), second, this->VertexOf(merged(this->Mesh.Apex(h))) });
    }
  }
  this->Vertices[this->VertexOf(vertex)].Fan = std::move(fan);
}

//------------------------------------------------------------------------------
void PatchFit::CopySamples(const EdgeNeighborhood& around)
{
  this->Slack.Clear();
  const auto copy = [&](Index from, std::size_t to)
  {
    this->Slack.Clear();
    this->Slack.AddSamples(from, 0);
    const std::vector<SlackFit::Member>& members = this->Slack.Members();
    std::vector<SlackFit::Member>& list = this->Faces[to].Members;
    list.insert(list.end(), members.begin(), members.end());
  };
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    copy(this->Faces[i].Id, i);
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    copy(around.RemovedFaces[k], this->Vertices[0].Fan[around.SlotAtApex(k)].Face);
  }
}

//------------------------------------------------------------------------------
/// The index of the face in the copy, to which it is added if it is new.
std::size_t PatchFit::FaceOf(Index id)
{
  const auto known = std::find_if(
    this->Faces.begin(), this->Faces.end(), [id](const Face& face) { return face.Id == id; });
  const std::size_t position = static_cast<std::size_t>(known - this->Faces.begin());
  if (known == this->Faces.end())
  {
    this->Faces.push_back({ id, {} });
  }
  return position;
}

//------------------------------------------------------------------------------
/// The same for a vertex.
std::size_t PatchFit::VertexOf(Index id)
{
  const auto known = std::find_if(this->Vertices.begin(), this->Vertices.end(),
    [id](const Vertex& vertex) { return vertex.Id == id; });
  const std::size_t position = static_cast<std::size_t>(known - this->Vertices.begin());
  if (known == this->Vertices.end())
  {
    this->Vertices.push_back(
      { id, this->Mesh.Position(VertexId(id)), this->Hints.Of(VertexId(id)), {} });
  }
  return position;
}

//------------------------------------------------------------------------------
SlackFit::Value PatchFit::Evaluate(const Vertex& vertex, const Vector3& position, double enough)
{
  this->Slack.Clear();
  for (std::size_t slot = 0; slot < vertex.Fan.size(); ++slot)
  {
    const Corner& corner = vertex.Fan[slot];
    this->Slack.AddFace(
      this->Vertices[corner.Second].Position, this->Vertices[corner.Third].Position);
    for (const SlackFit::Member& member : this->Faces[corner.Face].Members)
    {
      this->Slack.AddMember({ member.Sample, slot, member.IsCounted });
    }
  }
  return this->Slack.Evaluate(position, vertex.Hint, enough);
}

//------------------------------------------------------------------------------
/// Gives the samples to the faces where the last evaluation found them.
void PatchFit::HandOver(const Vertex& vertex)
{
  for (const Corner& corner : vertex.Fan)
  {
    this->Faces[corner.Face].Members.clear();
  }
  for (const SlackFit::Member& member : this->Slack.Members())
  {
    this->Faces[vertex.Fan[member.Slot].Face].Members.push_back(member);
  }
}

//------------------------------------------------------------------------------
/// The number of faces that the rules do not allow in place of those of the mesh.
Index PatchFit::NumberOfBadFaces(const Vertex& vertex) const
{
  return static_cast<Index>(std::count_if(vertex.Fan.begin(), vertex.Fan.end(),
    [&](const Corner& corner)
    {
      return CheckNewFace(this->Mesh, this->Faces[corner.Face].Id,
               { vertex.Position, this->Vertices[corner.Second].Position,
                 this->Vertices[corner.Third].Position }) != Rejection::NotRejected;
    }));
}

//------------------------------------------------------------------------------
/// Moves the vertex if this lowers the error. @return The largest ratio of its faces.
double PatchFit::Improve(Vertex& vertex)
{
  const SlackFit::Value before = this->Evaluate(vertex, vertex.Position, Infinity);
  this->HandOver(vertex);
  if (!(before.MaxRatio > RatioToMove))
  {
    return before.MaxRatio;
  }
  const Vector3 start = vertex.Position;
  const Index badBefore = this->NumberOfBadFaces(vertex);
  const SlackFit::Value after = this->Slack.TryStep(vertex.Position, before);
  if (!(after.Error < before.Error) || this->NumberOfBadFaces(vertex) > badBefore)
  {
    vertex.Position = start;
    return before.MaxRatio;
  }
  vertex.Hint = after.Hint;
  vertex.HasMoved = true;
  this->HandOver(vertex);
  return after.MaxRatio;
}

//------------------------------------------------------------------------------
/// The largest ratio of all faces; infinite if the rules do not allow a face.
double PatchFit::MaxRatio()
{
  double largest = 0.0;
  for (const Vertex& vertex : this->Vertices)
  {
    if (this->NumberOfBadFaces(vertex) > 0)
    {
      return Infinity;
    }
    largest = vertex.Fan.empty()
      ? largest
      : std::max(largest, this->Evaluate(vertex, vertex.Position, Infinity).MaxRatio);
  }
  return largest;
}

//------------------------------------------------------------------------------
/// Moves every vertex, and flips edges at those where this does not suffice.
/// @return The largest ratio.
double PatchFit::Sweep()
{
  double largest = 0.0;
  for (std::size_t i = 0; i < this->Vertices.size(); ++i)
  {
    const double ratio = this->Vertices[i].Fan.empty() ? 0.0 : this->Improve(this->Vertices[i]);
    this->FlipAround(i, ratio);
    largest = std::max(largest, ratio);
  }
  return largest;
}

//------------------------------------------------------------------------------
bool PatchFit::SweepUntilWithin()
{
  double before = Infinity;
  for (int sweep = 0; sweep < MaxSweeps; ++sweep)
  {
    const double largest = this->Sweep();
    if (largest <= MaxProposedRatio && this->MaxRatio() <= MaxProposedRatio)
    {
      return true;
    }
    const double gain = before - largest;
    const int left = MaxSweeps - 1 - sweep;
    if (!(gain > MinGainOfSweep * largest) ||
      (sweep > 0 && largest - MaxProposedRatio > MaxGainsNeeded * gain * left))
    {
      return false;
    }
    before = largest;
  }
  return false;
}

//------------------------------------------------------------------------------
PatchFit::Result PatchFit::MakeResult(const EdgeNeighborhood& around) const
{
  Result result;
  result.IsWithin = true;
  result.Position = this->Vertices[0].Position;
  result.Nearby.Flips = this->Flips;
  result.Hints.push_back({ this->Vertices[0].Id, this->Vertices[0].Hint });
  for (std::size_t i = 1; i < this->Vertices.size(); ++i)
  {
    const Vertex& vertex = this->Vertices[i];
    if (vertex.HasMoved)
    {
      result.Nearby.Moves.push_back({ vertex.Id, vertex.Position });
      result.Hints.push_back({ vertex.Id, vertex.Hint });
    }
  }
  for (const Face& face : this->Faces)
  {
    result.Faces.push_back(face.Id);
    for (const SlackFit::Member& member : face.Members)
    {
      result.Samples.push_back({ face.Id, member.Sample });
    }
  }
  result.Faces.push_back(around.RemovedFaces[0]);
  result.Faces.push_back(around.RemovedFaces[1]);
  return result;
}
}
