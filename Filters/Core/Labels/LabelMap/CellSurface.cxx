// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSurface.h"

#include "CellSegments.h"
#include "LoopTriangulation.h"

#include <algorithm>

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
/// Adds the surface that is bounded by connected segments.
class SurfacePart
{
public:
  SurfacePart(const Segments& segments, Diagonals diagonals, CellSurface& surface)
    : PartSegments(segments)
    , DiagonalRule(diagonals)
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
    else if (this->Count == 2 && this->PartSegments.Degree(this->FacePoints[0]) == 3 &&
      this->PartSegments.Degree(this->FacePoints[1]) == 3)
    {
      this->AddThreePolygons();
    }
    else
    {
      this->AddCone();
    }
  }

private:
  /// One loop between two labels. Seen from outside of the cell, the larger label is on the left of
  /// every segment.
  void AddPolygon()
  {
    const Segment& first = *this->PartSegments.begin();
    const Index larger = std::max(first.Left, first.Right);
    std::array<int, NumberOfCellEdges> next = {};
    for (const Segment& segment : this->PartSegments)
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
    TriangulateLoop(
      loop, std::min(first.Left, first.Right), larger, this->DiagonalRule, this->Surface);
  }

  /// Walls between three labels, with a common edge between the two points on faces.
  void AddThreePolygons()
  {
    for (const Segment& first : this->PartSegments)
    {
      if (first.First == this->FacePoints[0])
      {
        TriangulateLoop(
          this->LoopAlong(first), first.Right, first.Left, this->DiagonalRule, this->Surface);
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
      last = std::find_if(this->PartSegments.begin(), this->PartSegments.end(),
        [&](const Segment& segment) { return &segment != last && segment.Has(point); });
      point = last->OtherEnd(point);
    }
    loop.Add(point);
    return loop;
  }

  void AddCone()
  {
    const int apex = this->Surface.AddInnerPoint(this->Center());
    for (const Segment& segment : this->PartSegments)
    {
      this->Surface.Add({ { apex, segment.First, segment.Second }, segment.Right, segment.Left });
    }
  }

  /// The mean of the points on faces. If there is only one, the mean of the segments, because the
  /// apex must not lie on a face.
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
    for (const Segment& segment : this->PartSegments)
    {
      sum += this->Surface.Position(segment.First) + this->Surface.Position(segment.Second);
    }
    return sum / (2.0 * static_cast<double>(this->PartSegments.Count));
  }

  const Segments& PartSegments;
  Diagonals DiagonalRule;
  CellSurface& Surface;
  std::array<int, NumberOfCellFaces> FacePoints = {};
  std::size_t Count = 0;
};

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
  const Segments segments = FindSegments(labels, surface);
  const SegmentParts parts(segments);
  const Diagonals diagonals = BestDiagonals(labels);
  for (int point = 0; point < FirstInnerPoint; ++point)
  {
    if (parts.HasPart(point))
    {
      const Segments part = parts.PartOf(point);
      SurfacePart(part, diagonals, surface).Add();
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
