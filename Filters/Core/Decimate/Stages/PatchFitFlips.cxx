// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The flips of a PatchFit.
#include "Decimate/Edit/FlipAndMoveRules.h"
#include "PatchFit.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// An edge is flipped if its faces exceed this ratio, and if the error falls to this fraction.
constexpr double RatioToFlip = 0.98;
constexpr double PartAfterFlip = 0.9;
}

PatchFit::Edge PatchFit::EdgeAt(std::size_t vertex, std::size_t slot) const
{
  const std::vector<Corner>& fan = this->Vertices[vertex].Fan;
  const Corner& left = fan[slot];
  const Corner& right = fan[(slot + fan.size() - 1) % fan.size()];
  return { vertex, left.Second, left.Third, right.Second, left.Face, right.Face };
}

//------------------------------------------------------------------------------
/// One of the vertices that the new edge connects is inside of the copy, which contains all edges
/// of this vertex.
bool PatchFit::FlipIsAllowed(const Edge& edge) const
{
  const auto isConnected = [this](std::size_t from, std::size_t to)
  {
    const std::vector<Corner>& fan = this->Vertices[from].Fan;
    return fan.empty() ||
      std::any_of(
        fan.begin(), fan.end(), [to](const Corner& corner) { return corner.Second == to; });
  };
  if (edge.C == edge.D || (isConnected(edge.C, edge.D) && isConnected(edge.D, edge.C)))
  {
    return false;
  }
  const auto isFree = [this](std::size_t vertex)
  { return !this->Mesh.IsConstrained(this->Vertices[vertex].Id); };
  const auto isGood = [this](std::size_t face, std::size_t a, std::size_t b, std::size_t c)
  {
    return CheckNewFace(this->Mesh, this->Faces[face].Id,
             { this->Vertices[a].Position, this->Vertices[b].Position,
               this->Vertices[c].Position }) == Rejection::NotRejected;
  };
  return isFree(edge.B) && isFree(edge.C) && isFree(edge.D) &&
    isGood(edge.Left, edge.D, edge.C, edge.A) && isGood(edge.Right, edge.C, edge.D, edge.B) &&
    KeepsShape({ this->Vertices[edge.A].Position, this->Vertices[edge.B].Position,
      this->Vertices[edge.C].Position, this->Vertices[edge.D].Position });
}

//------------------------------------------------------------------------------
/// @param corners The common vertex of both faces, then their other corners in order.
void PatchFit::GatherPair(
  const std::array<std::size_t, 4>& corners, const std::array<std::size_t, 2>& faces)
{
  this->Slack.Clear();
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Slack.AddFace(
      this->Vertices[corners[i + 1]].Position, this->Vertices[corners[i + 2]].Position);
  }
  for (const std::size_t from : faces)
  {
    for (const SlackFit::Member& member : this->Faces[from].Members)
    {
      this->Slack.AddMember({ member.Sample, from == faces[0] ? 0U : 1U, member.IsCounted });
    }
  }
}

//------------------------------------------------------------------------------
bool PatchFit::FlipImproves(const Edge& edge)
{
  const Vertex& a = this->Vertices[edge.A];
  const Vertex& c = this->Vertices[edge.C];
  this->GatherPair({ edge.A, edge.D, edge.B, edge.C }, { edge.Right, edge.Left });
  const SlackFit::Value now = this->Slack.EvaluatePair(a.Position, a.Hint, Infinity);
  if (!(now.MaxRatio > RatioToFlip))
  {
    return false;
  }
  const double enough = PartAfterFlip * now.Error;
  this->GatherPair({ edge.C, edge.A, edge.D, edge.B }, { edge.Left, edge.Right });
  return this->Slack.EvaluatePair(c.Position, c.Hint, enough).Error < enough;
}

//------------------------------------------------------------------------------
/// Like HalfEdgeMesh::Flip: the left face a b c becomes d c a, the right one b a d becomes c d b.
/// The samples go where the last evaluation found them.
void PatchFit::Flip(const Edge& edge)
{
  const auto find = [this](std::size_t vertex, std::size_t face)
  {
    std::vector<Corner>& fan = this->Vertices[vertex].Fan;
    return std::find_if(
      fan.begin(), fan.end(), [face](const Corner& corner) { return corner.Face == face; });
  };
  const auto join = [&](std::size_t vertex, std::size_t gone, const Corner& corner)
  {
    if (!this->Vertices[vertex].Fan.empty())
    {
      *find(vertex, corner.Face) = corner;
      this->Vertices[vertex].Fan.erase(find(vertex, gone));
    }
  };
  const auto cut = [&](
                     std::size_t vertex, std::size_t old, const Corner& first, const Corner& second)
  {
    if (!this->Vertices[vertex].Fan.empty())
    {
      const auto at = find(vertex, old);
      *at = second;
      this->Vertices[vertex].Fan.insert(at, first);
    }
  };
  join(edge.A, edge.Right, { edge.Left, edge.D, edge.C });
  join(edge.B, edge.Left, { edge.Right, edge.C, edge.D });
  cut(edge.C, edge.Left, { edge.Left, edge.A, edge.D }, { edge.Right, edge.D, edge.B });
  cut(edge.D, edge.Right, { edge.Right, edge.B, edge.C }, { edge.Left, edge.C, edge.A });
  this->Faces[edge.Left].Members.clear();
  this->Faces[edge.Right].Members.clear();
  for (const SlackFit::Member& member : this->Slack.Members())
  {
    this->Faces[member.Slot == 0 ? edge.Left : edge.Right].Members.push_back(member);
  }
  this->Flips.push_back(
    { VertexId(this->Vertices[edge.A].Id), VertexId(this->Vertices[edge.B].Id) });
}

//------------------------------------------------------------------------------
/// Flips the edges of the vertex whose other diagonal is better. @param ratio The ratio of its
/// faces.
void PatchFit::FlipAround(std::size_t vertex, double ratio)
{
  const std::vector<Corner>& fan = this->Vertices[vertex].Fan;
  for (std::size_t slot = 0; ratio > RatioToFlip && slot < fan.size(); ++slot)
  {
    const Edge edge = this->EdgeAt(vertex, slot);
    if (this->FlipIsAllowed(edge) && this->FlipImproves(edge))
    {
      this->Flip(edge);
    }
  }
}
}
