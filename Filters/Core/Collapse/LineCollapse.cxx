// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineCollapse.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bonedecimate
{
namespace
{
constexpr Index PassesForAll = 4;
constexpr int MostPasses = 16;
constexpr Index CandidatesBetweenWords = 256; // to the monitor

/// The half-edge of the border of v's sheet that lies between v and a copy of the other site; None if there is none.
Index BorderEdgeTo(const HalfEdgeMesh& mesh, Index v, Index site)
{
  if (mesh.IsFixed(v) || !mesh.IsOnBorder(v))
  {
    return None;
  }
  Index last = None;
  for (const Index h : mesh.OutgoingOf(v))
  {
    last = HalfEdgeMesh::Previous(h);
  }
  const Index first = mesh.Outgoing(v);
  return mesh.Site(mesh.Target(first)) == site ? first
    : mesh.Site(mesh.Origin(last)) == site     ? last
                                               : None;
}

/// Of each sheet at the site that goes its collapse onto the other. Empty where the two are not one edge in each of them.
void FindEdits(const HalfEdgeMesh& mesh, Index gone, Index stays, std::vector<Edit>& edits)
{
  edits.clear();
  Index copy = gone;
  do
  {
    const Index edge = mesh.Outgoing(copy) == None ? None : BorderEdgeTo(mesh, copy, stays);
    const Index keep = edge == None ? None : mesh.Across(edge, copy);
    const bool isTaken = std::any_of(
      edits.begin(), edits.end(), [keep](const Edit& edit) { return edit.Keep == keep; });
    if (keep == None || isTaken || mesh.IsFixed(keep))
    {
      edits.clear();
      return;
    }
    edits.push_back({ edge, keep, mesh.Position(keep), true });
    copy = mesh.NextCopy(copy);
  } while (copy != gone);
}

/// The sites next to this one on borders of sheets.
void FindBeside(const HalfEdgeMesh& mesh, Index site, std::vector<Index>& sites)
{
  sites.clear();
  Index copy = site;
  do
  {
    if (mesh.Outgoing(copy) != None)
    {
      const std::array<Index, 2> beside = BesideOnBorder(mesh, copy);
      sites.insert(sites.end(), beside.begin(), beside.end());
    }
    copy = mesh.NextCopy(copy);
  } while (copy != site);
}
}

/// Whether three lines would make a triangle: sheets between them could come to be that triangle, one upon the other.
bool LineCollapse::MakesTriangle(Index place)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  FindBeside(mesh, this->Lines.Site(this->Lines.Before(place)), this->BesideBefore);
  FindBeside(mesh, this->Lines.Site(this->Lines.After(place)), this->BesideAfter);
  return std::any_of(this->BesideBefore.begin(), this->BesideBefore.end(),
    [&](Index site)
    {
      return site != None && site != this->Lines.Site(place) &&
        std::find(this->BesideAfter.begin(), this->BesideAfter.end(), site) !=
        this->BesideAfter.end();
    });
}

//------------------------------------------------------------------------------
LineCollapse::Answer LineCollapse::Run(const Wish& wish, const Monitor& monitor)
{
  Answer answer;
  const Index most = 1 + std::max(0, this->Lines.NumberOfEdges() - wish.Edges) / PassesForAll;
  const auto isFine = [&] { return this->Lines.NumberOfEdges() > wish.Edges; };
  for (int pass = 0; pass < MostPasses && isFine(); ++pass)
  {
    const Index gone = this->Pass(wish, most, monitor, answer);
    answer.Gone += gone;
    if (gone == 0 || answer.IsAborted)
    {
      break;
    }
  }
  return answer;
}

//------------------------------------------------------------------------------
/// Cheapest first; of equal ones the shorter.
void LineCollapse::ListCandidates(double bound, Answer& answer)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const auto limit = [this](Index site) { return this->Work.LimitAt(site); };
  this->Candidates.clear();
  answer.IsBound = false;
  for (Index place = 0; place < this->Lines.NumberOfPlaces(); ++place)
  {
    if (!this->Lines.MayGo(place))
    {
      continue;
    }
    const double deviation = this->Lines.Deviation(mesh, place, limit);
    if (deviation <= bound)
    {
      const Vector3& before = mesh.Position(this->Lines.Site(this->Lines.Before(place)));
      const Vector3& after = mesh.Position(this->Lines.Site(this->Lines.After(place)));
      this->Candidates.push_back({ deviation, (after - before).norm(), place });
    }
    answer.IsBound |= deviation > bound && std::isfinite(deviation);
  }
  std::sort(this->Candidates.begin(), this->Candidates.end(),
    [](const Candidate& a, const Candidate& b) {
      return std::tie(a.Deviation, a.Length, a.Place) < std::tie(b.Deviation, b.Length, b.Place);
    });
}

//------------------------------------------------------------------------------
Index LineCollapse::Pass(const Wish& wish, Index most, const Monitor& monitor, Answer& answer)
{
  this->ListCandidates(wish.Bound, answer);
  this->WasTouched.assign(static_cast<std::size_t>(this->Lines.NumberOfPlaces()), 0);
  const Index allowed = std::min(most, this->Lines.NumberOfEdges() - wish.Edges);
  Index gone = 0;
  Index heard = 0;
  for (const Candidate& candidate : this->Candidates)
  {
    if (++heard % CandidatesBetweenWords == 0 && !monitor(0.0))
    {
      answer.IsAborted = true;
      return gone;
    }
    if (gone < allowed && this->WasTouched[candidate.Place] == 0 &&
      this->TryPlace(candidate.Place, wish.Faces))
    {
      ++gone;
    }
  }
  return gone;
}

//------------------------------------------------------------------------------
bool LineCollapse::TryPlace(Index place, Index faces)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Index before = this->Lines.Before(place);
  const Index after = this->Lines.After(place);
  const Index site = this->Lines.Site(place);
  Index near = this->Lines.Site(before);
  Index far = this->Lines.Site(after);
  const Vector3& p = mesh.Position(site);
  if ((mesh.Position(far) - p).squaredNorm() < (mesh.Position(near) - p).squaredNorm())
  {
    std::swap(near, far);
  }
  if (this->MakesTriangle(place) ||
    (!this->CollapseOnto(site, near, faces) && !this->CollapseOnto(site, far, faces)))
  {
    return false;
  }
  this->Lines.Remove(place);
  this->WasTouched[before] = this->WasTouched[after] = 1;
  return true;
}

//------------------------------------------------------------------------------
bool LineCollapse::CollapseOnto(Index gone, Index stays, Index faces)
{
  FindEdits(this->Work.Mesh(), gone, stays, this->Edits);
  const auto removed = static_cast<Index>(this->Edits.size()); // a face each
  return removed > 0 && this->Work.Mesh().NumberOfFaces() - removed >= faces &&
    this->Work.ApplyTogether(this->Edits) == Verdict::Allowed;
}
}
