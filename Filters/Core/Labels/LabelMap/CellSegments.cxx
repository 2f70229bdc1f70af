// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSegments.h"

#include <numeric>

namespace bonedecimate
{
namespace
{
/// Adds the segments of one face.
class FaceSegments
{
public:
  FaceSegments(const CellLabels& labels, int face, CellSurface& surface, Segments& segments)
    : Face(face)
    , Edges(FaceEdges[static_cast<std::size_t>(face)])
    , Surface(surface)
    , Output(segments)
  {
    const auto& corners = FaceCorners[static_cast<std::size_t>(face)];
    for (std::size_t k = 0; k < 4; ++k)
    {
      this->CornerLabels[k] = labels[static_cast<std::size_t>(corners[k])];
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (this->CornerLabels[k] != this->CornerLabels[(k + 1) % 4])
      {
        this->Changes[this->Count++] = k;
      }
    }
  }

  void Add()
  {
    const auto& [a, b, c, d] = this->CornerLabels;
    if (this->Count == 2)
    {
      const std::size_t first = this->Changes[0];
      const std::size_t second = this->Changes[1];
      this->Output.Add({ this->Edges[first], this->Edges[second], this->CornerLabels[first],
        this->CornerLabels[second] });
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
    this->Output.Add({ this->Edges[(corner + 3) % 4], this->Edges[corner],
      this->CornerLabels[(corner + 1) % 4], this->CornerLabels[corner] });
  }

  void AddFacePoint()
  {
    Vector3 mean = Vector3::Zero();
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const std::size_t k = this->Changes[i];
      const int edge = this->Edges[k];
      mean += MiddleOfEdge(edge) / static_cast<double>(this->Count);
      this->Output.Add({ FirstFacePoint + this->Face, edge, this->CornerLabels[(k + 1) % 4],
        this->CornerLabels[k] });
    }
    this->Surface.SetFacePoint(FirstFacePoint + this->Face, mean);
  }

  int Face;
  const std::array<int, 4>& Edges;
  CellSurface& Surface;
  Segments& Output;
  std::array<Index, 4> CornerLabels = {};
  std::array<std::size_t, 4> Changes = {}; ///< Edges whose ends have different labels.
  std::size_t Count = 0;
};
}

//------------------------------------------------------------------------------
Segments FindSegments(const CellLabels& labels, CellSurface& surface)
{
  Segments segments;
  for (int face = 0; face < NumberOfCellFaces; ++face)
  {
    FaceSegments(labels, face, surface, segments).Add();
  }
  return segments;
}

//------------------------------------------------------------------------------
SegmentParts::SegmentParts(const Segments& segments)
  : AllSegments(segments)
{
  std::iota(this->Parents.begin(), this->Parents.end(), 0);
  for (const Segment& segment : segments)
  {
    const int a = this->RootOf(segment.First);
    const int b = this->RootOf(segment.Second);
    this->Parents[static_cast<std::size_t>(std::min(a, b))] = std::max(a, b);
  }
  for (std::size_t point = this->Parents.size(); point-- > 0;)
  {
    this->Parents[point] = this->RootOf(static_cast<int>(point)); // a single step from now on
  }
  for (const Segment& segment : segments)
  {
    ++this->Sizes[static_cast<std::size_t>(this->RootOf(segment.First))];
  }
}

//------------------------------------------------------------------------------
int SegmentParts::RootOf(int point) const
{
  while (this->Parents[static_cast<std::size_t>(point)] != point)
  {
    point = this->Parents[static_cast<std::size_t>(point)];
  }
  return point;
}

//------------------------------------------------------------------------------
Segments SegmentParts::PartOf(int point) const
{
  Segments part;
  for (const Segment& segment : this->AllSegments)
  {
    if (this->RootOf(segment.First) == point)
    {
      part.Add(segment);
    }
  }
  return part;
}
}
