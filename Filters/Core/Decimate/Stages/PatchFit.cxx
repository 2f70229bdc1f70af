// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchFit.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr int MostSweeps = 8;
/// A vertex whose faces use less of the bound stays.
constexpr double RatioToMove = 0.9;
/// A little less than the bound: what the samples miss.
constexpr double Within = 0.99;
/// A sweep must gain that much of the largest ratio, and the rest must be within reach of the sweeps that are left.
constexpr double LeastGainOfSweep = 0.002;
constexpr double MostHope = 1.2;
}

PatchFit::PatchFit(const Editor& editor, const Samples& samples, const BackHints& hints)
  : Mesh(editor.Mesh())
  , Back(hints)
  , Slack(editor, samples, hints)
{
}

//------------------------------------------------------------------------------
PatchFit::Result PatchFit::Fit(const EdgeNeighborhood& around, const SlackCandidate& candidate)
{
  this->Copy(around, candidate);
  return this->SweepUntilWithin() ? this->Found(around) : Result();
}

//------------------------------------------------------------------------------
void PatchFit::Copy(const EdgeNeighborhood& around, const SlackCandidate& candidate)
{
  this->Vertices.clear();
  this->Faces.clear();
  Vertex merged = { around.Start, candidate.Position, candidate.Hint, {} };
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    merged.Fan.push_back({ this->FaceOf(HalfEdgeMesh::Face(around.Corners[i])), around.Ring[i],
      around.Ring[(i + 1) % around.Ring.size()] });
  }
  this->Vertices.push_back(merged);
  for (const VertexId v : around.Ring)
  {
    if (MayMove(this->Mesh, v))
    {
      this->CopyRing(v, around);
    }
  }
  this->CopySamples(around);
}

//------------------------------------------------------------------------------
/// Of a vertex beside the edge, as after the collapse.
void PatchFit::CopyRing(VertexId vertex, const EdgeNeighborhood& around)
{
  const auto merged = [&](VertexId v) { return v == around.End ? around.Start : v; };
  Vertex copy = { vertex, this->Mesh.Position(vertex), this->Back.Of(vertex), {} };
  for (const HalfEdgeId h : this->Mesh.OutgoingOf(vertex))
  {
    const FaceId face = HalfEdgeMesh::Face(h);
    if (face != around.GoneFaces[0] && face != around.GoneFaces[1])
    {
      copy.Fan.push_back({ this->FaceOf(face), merged(this->Mesh.Target(h)),
        merged(this->Mesh.Origin(HalfEdgeMesh::Previous(h))) });
    }
  }
  this->Vertices.push_back(copy);
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
    const std::size_t slot = SlackCandidates::SlotOfGone(around, k);
    copy(around.GoneFaces[k], this->Vertices[0].Fan[slot].Face);
  }
}

//------------------------------------------------------------------------------
/// Its position in the copy, where it is added if it is new.
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
const Vector3& PatchFit::PositionOf(Index vertex) const
{
  const auto known = std::find_if(this->Vertices.begin(), this->Vertices.end(),
    [vertex](const Vertex& other) { return other.Id == vertex; });
  return known != this->Vertices.end() ? known->Position : this->Mesh.Position(vertex);
}

//------------------------------------------------------------------------------
SlackFit::Value PatchFit::Evaluate(const Vertex& vertex, const Vector3& position, double enough)
{
  this->Slack.Clear();
  for (std::size_t slot = 0; slot < vertex.Fan.size(); ++slot)
  {
    const Corner& corner = vertex.Fan[slot];
    this->Slack.AddFace(this->PositionOf(corner.Second), this->PositionOf(corner.Third));
    for (const SlackFit::Member& member : this->Faces[corner.Face].Members)
    {
      this->Slack.AddMember({ member.Sample, slot, member.Counts });
    }
  }
  return this->Slack.Evaluate(position, vertex.Hint, enough);
}

//------------------------------------------------------------------------------
/// Gives the samples to the faces where the last evaluation found them: those of the merged vertex have other faces than before.
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
/// Moves the vertex if that helps.  @return The largest ratio of its faces.
double PatchFit::Improve(Vertex& vertex)
{
  const SlackFit::Value before =
    this->Evaluate(vertex, vertex.Position, std::numeric_limits<double>::infinity());
  this->HandOver(vertex);
  if (!(before.Largest > RatioToMove))
  {
    return before.Largest;
  }
  const SlackFit::Value after = this->Slack.TryStep(vertex.Position, before);
  if (!(after.Error < before.Error))
  {
    return before.Largest;
  }
  vertex.Hint = after.Hint;
  vertex.HasMoved = true;
  this->HandOver(vertex);
  return after.Largest;
}

//------------------------------------------------------------------------------
double PatchFit::LargestRatio()
{
  double largest = 0.0;
  for (const Vertex& vertex : this->Vertices)
  {
    largest = std::max(largest,
      this->Evaluate(vertex, vertex.Position, std::numeric_limits<double>::infinity()).Largest);
  }
  return largest;
}

//------------------------------------------------------------------------------
bool PatchFit::SweepUntilWithin()
{
  double before = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    double largest = 0.0;
    for (Vertex& vertex : this->Vertices)
    {
      largest = std::max(largest, this->Improve(vertex));
    }
    if (largest <= Within && this->LargestRatio() <= Within)
    {
      return true;
    }
    const double gain = before - largest;
    const int left = MostSweeps - 1 - sweep;
    if (!(gain > LeastGainOfSweep * largest) ||
      (sweep > 0 && largest - Within > MostHope * gain * left))
    {
      return false;
    }
    before = largest;
  }
  return false;
}

//------------------------------------------------------------------------------
PatchFit::Result PatchFit::Found(const EdgeNeighborhood& around) const
{
  Result result;
  result.IsWithin = true;
  result.Position = this->Vertices[0].Position;
  result.Hints.push_back({ this->Vertices[0].Id, this->Vertices[0].Hint });
  for (std::size_t i = 1; i < this->Vertices.size(); ++i)
  {
    const Vertex& vertex = this->Vertices[i];
    if (vertex.HasMoved)
    {
      result.Moves.push_back({ vertex.Id, vertex.Position });
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
  result.Faces.push_back(around.GoneFaces[0]);
  result.Faces.push_back(around.GoneFaces[1]);
  return result;
}
}
