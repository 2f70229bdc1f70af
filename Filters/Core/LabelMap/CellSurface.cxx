// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSurface.h"

#include "LoopTriangulation.h"

#include <algorithm>
#include <numeric>

namespace bonedecimate
{
CellSurface::CellSurface()
{
  for (int edge = 0; edge < NumberOfCellEdges; ++edge)
  {
    this->Positions[static_cast<std::size_t>(edge)] = MiddleOfEdge(edge);
  }
}

//------------------------------------------------------------------------------
void CellSurface::Clear()
{
  this->Size = 0;
  this->InnerPoints = 0;
}

//------------------------------------------------------------------------------
int CellSurface::AddInnerPoint(const Vector3& position)
{
  const std::size_t point = FirstInnerPoint + this->InnerPoints++;
  this->Positions[point] = position;
  return static_cast<int>(point);
}

//------------------------------------------------------------------------------
void CellSurface::SetFacePoint(int point, const Vector3& position)
{
  this->Positions[static_cast<std::size_t>(point)] = position;
}

namespace
{
/// On a face of the cell; the labels are those on its left and right seen from outside.
struct Segment
{
  int First;
  int Second;
  Index Left;
  Index Right;

  bool Has(int point) const { return this->First == point || this->Second == point; }
  int OtherEnd(int point) const { return this->First == point ? this->Second : this->First; }
};

/// The segments of a cell, or connected ones of it.
struct Segments
{
  std::array<Segment, 24> All = {};
  std::size_t Count = 0;

  void Add(const Segment& segment) { this->All[this->Count++] = segment; }
  const Segment* begin() const { return this->All.data(); }
  const Segment* end() const { return this->All.data() + this->Count; }
  bool IsEmpty() const { return this->Count == 0; }
  auto Degree(int point) const
  {
    return std::count_if(
      this->begin(), this->end(), [&](const Segment& segment) { return segment.Has(point); });
  }
};

//------------------------------------------------------------------------------
// The segments of one face.

class FaceSegments
{
public:
  FaceSegments(const CellLabels& labels, int face, CellSurface& surface, Segments& segments)
    : Face(face)
    , Edges(FaceEdges[static_cast<std::size_t>(face)])
    , Surface(surface)
    , Result(segments)
  {
    const auto& corners = FaceCorners[static_cast<std::size_t>(face)];
    for (std::size_t k = 0; k < 4; ++k)
    {
      this->Around[k] = labels[static_cast<std::size_t>(corners[k])];
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (this->Around[k] != this->Around[(k + 1) % 4])
      {
        this->Changes[this->Count++] = k;
      }
    }
  }

  void Add()
  {
    const auto& [a, b, c, d] = this->Around;
    if (this->Count == 2)
    {
      const auto [first, second, unused, none] = this->Changes;
      this->Result.Add(
        { this->Edges[first], this->Edges[second], this->Around[first], this->Around[second] });
    }
    else if (HasFacePoint(a, b, c, d))
    {
      this->AddFacePoint();
    }
    else if (this->Count == 4)
    {
      const bool cutsOddCorners = a == c && (b != d || b > a);
      this->CutOff(cutsOddCorners ? 1 : 0);
      this->CutOff(cutsOddCorners ? 3 : 2);
    }
  }

private:
  void CutOff(std::size_t corner)
  {
    this->Result.Add({ this->Edges[(corner + 3) % 4], this->Edges[corner],
      this->Around[(corner + 1) % 4], this->Around[corner] });
  }

  void AddFacePoint()
  {
    Vector3 mean = Vector3::Zero();
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const std::size_t k = this->Changes[i];
      const int edge = this->Edges[k];
      mean += MiddleOfEdge(edge) / static_cast<double>(this->Count);
      this->Result.Add(
        { FirstFacePoint + this->Face, edge, this->Around[(k + 1) % 4], this->Around[k] });
    }
    this->Surface.SetFacePoint(FirstFacePoint + this->Face, mean);
  }

  int Face;
  const std::array<int, 4>& Edges;
  CellSurface& Surface;
  Segments& Result;
  std::array<Index, 4> Around = {};
  std::array<std::size_t, 4> Changes = {}; ///< Edges whose ends have different labels.
  std::size_t Count = 0;
};

//------------------------------------------------------------------------------
// The surface that connected segments bound.

class SurfacePart
{
public:
  SurfacePart(const Segments& segments, Diagonals best, CellSurface& surface)
    : Part(segments)
    , Best(best)
    , Surface(surface)
  {
    for (int point = FirstFacePoint; point < FirstInnerPoint; ++point)
    {
      if (segments.Degree(point) > 0)
      {
        this->FacePoints[this->Count++] = point;
      }
    }
  }

  void Add()
  {
    if (this->Count == 0)
    {
      this->AddPolygon();
    }
    else if (this->Count == 2 && this->Part.Degree(this->FacePoints[0]) == 3 &&
      this->Part.Degree(this->FacePoints[1]) == 3)
    {
      this->AddThreePolygons();
    }
    else
    {
      this->AddCone();
    }
  }

private:
  /// One loop between two labels: seen from outside of the cell, the larger one is on the left of every segment.
  void AddPolygon()
  {
    const Segment& first = *this->Part.begin();
    const Index larger = std::max(first.Left, first.Right);
    std::array<int, NumberOfCellEdges> next = {};
    for (const Segment& segment : this->Part)
    {
      const bool forward = segment.Left == larger;
      next[static_cast<std::size_t>(forward ? segment.First : segment.Second)] =
        forward ? segment.Second : segment.First;
    }
    CellLoop loop;
    int point = first.First;
    do
    {
      loop.Add(point);
      point = next[static_cast<std::size_t>(point)];
    } while (point != first.First);
    TriangulateLoop(loop, std::min(first.Left, first.Right), larger, this->Best, this->Surface);
  }

  /// Walls between three labels; the edge between the two points on faces belongs to all of them.
  void AddThreePolygons()
  {
    for (const Segment& first : this->Part)
    {
      if (first.First == this->FacePoints[0])
      {
        TriangulateLoop(this->LoopAlong(first), first.Right, first.Left, this->Best, this->Surface);
      }
    }
  }

  /// From the first point on a face to the second.
  CellLoop LoopAlong(const Segment& first) const
  {
    CellLoop loop;
    loop.Add(this->FacePoints[0]);
    int point = first.Second;
    const Segment* last = &first;
    while (point != this->FacePoints[1])
    {
      loop.Add(point);
      last = std::find_if(this->Part.begin(), this->Part.end(),
        [&](const Segment& segment) { return &segment != last && segment.Has(point); });
      point = last->OtherEnd(point);
    }
    loop.Add(point);
    return loop;
  }

  void AddCone()
  {
    const int apex = this->Surface.AddInnerPoint(this->Center());
    for (const Segment& segment : this->Part)
    {
      this->Surface.Add({ { apex, segment.First, segment.Second }, segment.Right, segment.Left });
    }
  }

  /// The mean of the points on faces; with one of them that of the segments, because it must not lie on a face.
  Vector3 Center() const
  {
    Vector3 sum = Vector3::Zero();
    if (this->Count > 1)
    {
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        sum += this->Surface.Position(this->FacePoints[i]);
      }
      return sum / static_cast<double>(this->Count);
    }
    for (const Segment& segment : this->Part)
    {
      sum += this->Surface.Position(segment.First) + this->Surface.Position(segment.Second);
    }
    return sum / (2.0 * static_cast<double>(this->Part.Count));
  }

  const Segments& Part;
  Diagonals Best;
  CellSurface& Surface;
  std::array<int, NumberOfCellFaces> FacePoints = {};
  std::size_t Count = 0;
};

//------------------------------------------------------------------------------
// Which points are connected by segments.

class Connectivity
{
public:
  explicit Connectivity(const Segments& segments)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
    for (const Segment& segment : segments)
    {
      const int a = this->RootOf(segment.First);
      const int b = this->RootOf(segment.Second);
      this->Parents[static_cast<std::size_t>(std::min(a, b))] = std::max(a, b);
    }
  }

  int RootOf(int point) const
  {
    while (this->Parents[static_cast<std::size_t>(point)] != point)
    {
      point = this->Parents[static_cast<std::size_t>(point)];
    }
    return point;
  }

private:
  std::array<int, FirstInnerPoint> Parents = {};
};

Segments SegmentsOf(const Segments& segments, const Connectivity& connectivity, int root)
{
  Segments part;
  for (const Segment& segment : segments)
  {
    if (connectivity.RootOf(segment.First) == root)
    {
      part.Add(segment);
    }
  }
  return part;
}

Diagonals BestDiagonals(const CellLabels& labels)
{
  const auto [least, largest] = std::minmax_element(labels.begin(), labels.end());
  return std::all_of(labels.begin(), labels.end(),
           [low = *least, high = *largest](Index label) { return label == low || label == high; })
    ? Diagonals::Longest
    : Diagonals::Shortest;
}

std::array<CellSurface, 256> MakeTwoLabelSurfaces()
{
  std::array<CellSurface, 256> surfaces;
  for (unsigned int cellCase = 0; cellCase < surfaces.size(); ++cellCase)
  {
    CellLabels labels = {};
    for (unsigned int corner = 0; corner < labels.size(); ++corner)
    {
      labels[corner] = static_cast<Index>(cellCase >> corner & 1U);
    }
    BuildCellSurface(labels, surfaces[cellCase]);
  }
  return surfaces;
}
}

//------------------------------------------------------------------------------
void BuildCellSurface(const CellLabels& labels, CellSurface& surface)
{
  surface.Clear();
  Segments segments;
  for (int face = 0; face < NumberOfCellFaces; ++face)
  {
    FaceSegments(labels, face, surface, segments).Add();
  }
  const Connectivity connectivity(segments);
  const Diagonals best = BestDiagonals(labels);
  for (int root = 0; root < FirstInnerPoint; ++root)
  {
    const Segments part = SegmentsOf(segments, connectivity, root);
    if (!part.IsEmpty())
    {
      SurfacePart(part, best, surface).Add();
    }
  }
}

//------------------------------------------------------------------------------
const std::array<CellSurface, 256>& TwoLabelSurfaces()
{
  static const std::array<CellSurface, 256> surfaces = MakeTwoLabelSurfaces();
  return surfaces;
}
}
