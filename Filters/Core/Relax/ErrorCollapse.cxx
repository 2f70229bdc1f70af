// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCollapse.h"

#include "ErrorWeights.h"
#include "Parallel.h"

namespace bonedecimate
{
namespace
{
/// Judged at least.
constexpr std::size_t LeastEdges = 512;
/// If the gate refused them all, that many times more the next time.
constexpr std::size_t MoreEdges = 4;
}

ErrorCollapse::ErrorCollapse(
  Editor& editor, Samples& samples, BackHints& hints, int edgesOfCollapse, int threads)
  : Work(editor)
  , Fit(samples)
  , Back(hints)
  , Penalty(editor.Mesh().Unit())
  , Own{ FanFit(editor.Mesh(), samples, hints), {} }
  , EdgesOfCollapse(static_cast<std::size_t>(edgesOfCollapse))
  , Threads(threads)
  , FaceErrors(static_cast<std::size_t>(editor.Mesh().NumberOfFaceSlots()), 0.0F)
  , VertexErrors(static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots()), 0.0F)
  , Stamps(static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots()), 0)
{
}

//------------------------------------------------------------------------------
bool ErrorCollapse::Run(Index faces, const Monitor& monitor)
{
  constexpr double measuredAt = 0.1;
  constexpr double filledAt = 0.5;
  this->Wanted = faces;
  if (!this->MeasureErrors(PartOf(monitor, 0.0, measuredAt)))
  {
    return false;
  }
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const std::size_t allEdges = 2 * static_cast<std::size_t>(mesh.NumberOfFaces());
  std::size_t edges = std::max(LeastEdges, this->EdgesOfCollapse * this->CollapsesWanted());
  double from = measuredAt;
  for (Index before = None; this->CollapsesWanted() > 0;)
  {
    if (before == mesh.NumberOfFaces() && edges >= allEdges)
    {
      break;
    }
    before = mesh.NumberOfFaces();
    if (!this->FillHeap(edges, PartOf(monitor, from, std::max(from, filledAt))) ||
      !this->EmptyHeap(PartOf(monitor, std::max(from, filledAt), 1.0)))
    {
      return false;
    }
    edges *= MoreEdges;
    from = 1.0;
  }
  return true;
}

//------------------------------------------------------------------------------
std::size_t ErrorCollapse::CollapsesWanted() const
{
  const Index tooMany = this->Work.Mesh().NumberOfFaces() - this->Wanted;
  return tooMany > 0 ? static_cast<std::size_t>((tooMany + 1) / 2) : 0;
}

//------------------------------------------------------------------------------
std::uint32_t ErrorCollapse::StampOf(Index edge) const
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  return this->Stamps[mesh.Origin(edge)] + this->Stamps[mesh.Target(edge)];
}

//------------------------------------------------------------------------------
double ErrorCollapse::FaceError(Index face) const
{
  const TriangleFrame frame = FrameOf(this->Work.Mesh(), face);
  double error = 0.0;
  this->Fit.VisitFace(face,
    [&](const Samples::Sample& sample)
    {
      error += sample.Weight *
        this->Penalty.Of(frame.Nearest(this->Fit.PositionOf(sample)).SquaredDistance);
    });
  return error;
}

//------------------------------------------------------------------------------
double ErrorCollapse::VertexError(Index vertex) const
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  double area = 0.0; // mm^2
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    area += FrameOf(mesh, HalfEdgeMesh::Face(h)).SurfaceArea();
  }
  return BackWeightOfCollapse * CornerShare * this->Penalty.InUnits(area) *
    this->Penalty.Of(this->Back.Find(mesh.Position(vertex), vertex).Place.SquaredDistance);
}

//------------------------------------------------------------------------------
bool ErrorCollapse::MeasureErrors(const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  return ForEachChunk(this->FaceErrors.size(), this->Threads, monitor,
           [&](std::size_t, std::size_t first, std::size_t last)
           {
             for (std::size_t face = first; face < last; ++face)
             {
               const Index f = static_cast<Index>(face);
               this->FaceErrors[face] =
                 mesh.IsAlive(f) ? static_cast<float>(this->FaceError(f)) : 0.0F;
             }
           }) &&
    ForEachChunk(
      this->VertexErrors.size(), this->Threads, [&](double) { return monitor(1.0); },
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t vertex = first; vertex < last; ++vertex)
        {
          const Index v = static_cast<Index>(vertex);
          const bool counts = mesh.Outgoing(v) != None && mesh.Kind(v) == VertexKind::Inside;
          this->VertexErrors[vertex] = counts ? static_cast<float>(this->VertexError(v)) : 0.0F;
        }
      });
}

//------------------------------------------------------------------------------
bool ErrorCollapse::FillHeap(std::size_t count, const Monitor& monitor)
{
  constexpr double foundAt = 0.1;
  std::vector<RatedEdge> edges;
  if (!FindCheapest(this->Work.Mesh(), count, this->Threads, PartOf(monitor, 0.0, foundAt), edges))
  {
    return false;
  }
  this->Dearest = 0.0F;
  for (const RatedEdge& edge : edges)
  {
    this->Dearest = std::max(this->Dearest, edge.Cost);
  }
  std::vector<Entry> entries(edges.size());
  std::vector<std::uint8_t> isGood(edges.size(), 0);
  const bool done = ForEachChunk(edges.size(), this->Threads, PartOf(monitor, foundAt, 1.0),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Judge judge{ FanFit(this->Work.Mesh(), this->Fit, this->Back), {} };
      for (std::size_t i = first; i < last; ++i)
      {
        isGood[i] = this->Rate(edges[i], judge, entries[i]) ? 1 : 0;
      }
    });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (isGood[i] != 0)
    {
      entries[kept++] = entries[i];
    }
  }
  entries.resize(done ? kept : 0);
  this->Heap = std::priority_queue<Entry>(std::less<Entry>(), std::move(entries));
  return done;
}

//------------------------------------------------------------------------------
bool ErrorCollapse::EmptyHeap(const Monitor& monitor)
{
  constexpr std::size_t tellEvery = 8; // edges
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const double first = static_cast<double>(this->CollapsesWanted());
  for (std::size_t turn = 1; this->CollapsesWanted() > 0 && !this->Heap.empty(); ++turn)
  {
    const Entry entry = this->Heap.top();
    this->Heap.pop();
    const bool isThere =
      mesh.Origin(entry.Edge) == entry.Start && mesh.Target(entry.Edge) == entry.End;
    if (isThere && entry.Stamp != this->StampOf(entry.Edge))
    {
      this->Push({ 0.0F, entry.Edge, entry.Place });
    }
    else if (isThere)
    {
      this->Collapse(entry);
    }
    if (turn % tellEvery == 0 &&
      !monitor(1.0 - static_cast<double>(this->CollapsesWanted()) / first))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
/// False if the edge may not be collapsed.
bool ErrorCollapse::Rate(const RatedEdge& edge, Judge& judge, Entry& entry) const
{
  if (this->Work.Examine(edge.Edge, judge.Space) != Verdict::Allowed)
  {
    return false;
  }
  const Neighbourhood& around = judge.Space.Around;
  double before = this->VertexErrors[around.Start] + this->VertexErrors[around.End] +
    this->FaceErrors[around.GoneFaces[0]] + this->FaceErrors[around.GoneFaces[1]];
  for (const Index corner : around.Corners)
  {
    before += this->FaceErrors[HalfEdgeMesh::Face(corner)];
  }
  const FanFit::Answer answer = judge.Costs.Evaluate(around, edge.Place);
  entry = { answer.Error - before, edge.Edge, around.Start, around.End, this->StampOf(edge.Edge),
    answer.Position };
  return true;
}

//------------------------------------------------------------------------------
void ErrorCollapse::Push(const RatedEdge& edge)
{
  Entry entry;
  if (this->Rate(edge, this->Own, entry))
  {
    this->Heap.push(entry);
  }
}

//------------------------------------------------------------------------------
bool ErrorCollapse::Collapse(const Entry& entry)
{
  if (this->Work.Examine(entry.Edge, this->Own.Space) != Verdict::Allowed)
  {
    return false;
  }
  const Neighbourhood around = this->Own.Space.Around;
  const FanFit::Answer answer = this->Own.Costs.Evaluate(around, entry.Place);
  Edit edit;
  edit.Edge = entry.Edge;
  edit.Keep = around.Start;
  edit.Position = answer.Position;
  const Verdict verdict = this->Work.Apply(edit, this->Own.Space, 1);
  this->Work.Settle(this->Own.Space.Counted);
  if (verdict != Verdict::Allowed)
  {
    return false;
  }
  for (const Index corner : around.Corners)
  {
    this->Fit.Take(HalfEdgeMesh::Face(corner));
  }
  this->Fit.Take(around.GoneFaces[0]);
  this->Fit.Take(around.GoneFaces[1]);
  for (const FanFit::Member& member : this->Own.Costs.Members())
  {
    this->Fit.Put(member.Sample, HalfEdgeMesh::Face(around.Corners[member.Slot]));
  }
  this->AfterCollapse(edit.Keep, answer);
  return true;
}

//------------------------------------------------------------------------------
void ErrorCollapse::AfterCollapse(Index vertex, const FanFit::Answer& answer)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  this->Back.Set(vertex, answer.Hint);
  this->VertexErrors[vertex] = static_cast<float>(answer.VertexError);
  ++this->Stamps[vertex];
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    const Index face = HalfEdgeMesh::Face(h);
    this->FaceErrors[face] = static_cast<float>(this->FaceError(face));
    ++this->Stamps[mesh.Target(h)];
  }
  this->Candidates.clear();
  RateEdges(mesh, vertex, false, this->Candidates);
  for (const RatedEdge& edge : this->Candidates)
  {
    if (edge.Cost <= this->Dearest)
    {
      this->Push(edge);
    }
  }
}
}
