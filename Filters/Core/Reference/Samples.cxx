// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"

#include "Parallel.h"
#include "SurfaceWalk.h"
#include "Relax/Knobs.h"
#include "Geometry/BoundingTree.h"
#include <cstdio>
#include <cstdlib>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Corners 1/12 each and the middle 3/4 integrate quadratic functions over a triangle exactly.
static const double MiddleShare = Knob("SM",0.75);
static const double CornerShare = (1-MiddleShare)/3;

std::array<float, 3> Single(const Vector3& p)
{
  return { static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()) };
}

Vector3 MiddleOf(const HalfEdgeMesh& mesh, const Triangle& c)
{
  return (mesh.Position(c[0]) + mesh.Position(c[1]) + mesh.Position(c[2])) / 3.0;
}
}

Samples::Samples(const HalfEdgeMesh& original)
  : Firsts(static_cast<std::size_t>(original.NumberOfFaceSlots()), None)
{
  const Index vertices = original.NumberOfVertexSlots();
  const Index faces = original.NumberOfFaceSlots();
  const Index per = int(Knob("PER",1));
  this->All.resize(static_cast<std::size_t>(vertices) + per*faces);
  for (Index v = 0; v < vertices; ++v)
  {
    this->All[v] = { Single(original.Position(v)), 0.0F, None };
  }
  for (Index face = 0; face < faces; ++face)
  {
    const Triangle c = original.Corners(face);
    const double area =
      AreaVector(original.Position(c[0]), original.Position(c[1]), original.Position(c[2])).norm();
    for (int k=0;k<per;++k) { Vector3 q=MiddleOf(original,c); if(per==3) q=0.5*q+0.5*original.Position(c[k]);
    if(per==4&&k<3) q=0.4*q+0.6*original.Position(c[k]);
    this->All[vertices + per*face+k] = { Single(q), static_cast<float>(MiddleShare * area/per), None }; }
    for (const Index corner : c)
    {
      this->All[corner].Weight += static_cast<float>(CornerShare * area);
    }
  }
  this->Faces.resize(this->All.size(), None);
}

//------------------------------------------------------------------------------
static const HalfEdgeMesh* Dbg;
bool Samples::Distribute(const HalfEdgeMesh& original, const HalfEdgeMesh& mesh, Original& merged,
  int threads, const Monitor& monitor)
{
  Dbg=&mesh;
  const Index vertices = original.NumberOfVertexSlots();
  std::vector<Index> current(static_cast<std::size_t>(vertices));
  for (Index v = 0; v < vertices; ++v)
  {
    current[v] = merged.CurrentVertex(v);
  }
  const bool goesOn = ForEachChunk(this->All.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t s = first; s < last; ++s)
      {
        const Index sample = static_cast<Index>(s);
        const Vector3 p = this->All[s].Position();
        if (sample < vertices)
        {
          PlaceOnMesh best = WalkFromVertex(mesh, p, current[sample]);
          if (original.Kind(sample) != VertexKind::Locked)
          {
            Index tried = current[sample];
            original.VisitEdges(sample,
              [&](Index h)
              {
                const Index other = current[original.Across(h, sample)];
                if (other != current[sample] && other != tried)
                {
                  tried = other;
                  const PlaceOnMesh found = WalkFromVertex(mesh, p, other);
                  if (found.Place.SquaredDistance < best.Place.SquaredDistance) best = found;
                }
              });
          }
          this->Faces[s] = best.Face;
        }
        else
        {
          const Triangle c = original.Corners((sample - vertices)/int(Knob("PER",1)));
          PlaceOnMesh best = WalkFromVertex(mesh, p, current[c[0]]);
          for (int k = 1; k < 3; ++k)
            if (current[c[k]] != current[c[0]])
            {
              const PlaceOnMesh found = WalkFromVertex(mesh, p, current[c[k]]);
              if (found.Place.SquaredDistance < best.Place.SquaredDistance) best = found;
            }
          this->Faces[s] = best.Face;
        }
      }
    });
  if (goesOn)
  {
    this->SortByFace();
  }
  return goesOn;
}

//------------------------------------------------------------------------------
bool Samples::Settle(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor)
{
  const std::size_t slots = this->Firsts.size();
  const bool goesOn = ForEachChunk(slots, threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t face = first; face < last; ++face)
      {
        if (this->Firsts[face] == None)
        {
          continue;
        }
        const Index from = static_cast<Index>(face);
        const TriangleFrame frame = FrameOf(mesh, from);
        for (Index s = this->Firsts[face]; s != None; s = this->All[s].Next)
        {
          const Vector3 p = this->All[s].Position();
          const TriangleFrame::Place place = frame.Nearest(p);
          const bool stays = place.Clamped == 0 && frame.EdgesNearby(place) == 0;
          this->Faces[s] = stays ? from : WalkOn(mesh, p, { from, place }).Face;
        }
      }
    });
  if (goesOn)
  {
    this->SortByFace();
  }
  return goesOn;
}

//------------------------------------------------------------------------------
void Samples::SortByFace()
{
  if (getenv("CHECK") && Dbg) { double e=0,w=0,eb=0,over=0; long bad=0; Surface q; std::vector<Index> ids; for(Index f=0;f<Dbg->NumberOfFaceSlots();++f) if(Dbg->IsAlive(f)){ Triangle c=Dbg->Corners(f); Index n=q.Points.size(); for(int k=0;k<3;++k) q.Points.push_back(Dbg->Position(c[k])); q.Triangles.push_back({n,n+1,n+2}); } BoundingTree t(q); for(size_t s=0;s<All.size();++s){ Vector3 p=All[s].Position(); double d=FrameOf(*Dbg,Faces[s]).Nearest(p).SquaredDistance; double b=t.FindNearest(p).Place.SquaredDistance; e+=All[s].Weight*d; eb+=All[s].Weight*b; w+=All[s].Weight; if(d>b*1.0001+1e-12){ bad++; over=std::max(over,std::sqrt(d)-std::sqrt(b)); } } fprintf(stderr,"samples rms %.5f brute %.5f  wrong %.4f%% worst %.4f\n",std::sqrt(e/w),std::sqrt(eb/w),100.*bad/All.size(),over); }

  // Firsts becomes the end of each face's piece, then its beginning; empty faces have None.
  std::fill(this->Firsts.begin(), this->Firsts.end(), 0);
  for (const Index face : this->Faces)
  {
    ++this->Firsts[face];
  }
  Index end = 0;
  for (Index& count : this->Firsts)
  {
    end += count;
    count = count == 0 ? None : end;
  }
  this->Sorted.resize(this->All.size());
  std::vector<Index> facesOfSorted(this->All.size());
  for (std::size_t s = this->All.size(); s-- > 0;)
  {
    const Index face = this->Faces[s];
    const Index slot = --this->Firsts[face];
    this->Sorted[slot] = this->All[s];
    facesOfSorted[slot] = face;
  }
  this->All.swap(this->Sorted);
  this->Faces.swap(facesOfSorted);
  for (std::size_t s = 0; s < this->All.size(); ++s)
  {
    const bool last = s + 1 == this->All.size() || this->Faces[s + 1] != this->Faces[s];
    this->All[s].Next = last ? None : static_cast<Index>(s + 1);
  }
}
}
