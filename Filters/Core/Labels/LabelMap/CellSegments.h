// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellSegments.h
 * @brief The curves in which the surface in a cell meets the faces of the cell, as segments
 * (CellSurface.h has the rules).
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_CellSegments_h
#define BoneDecimate_Core_Labels_LabelMap_CellSegments_h

#include "CellSurface.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace bonedecimate
{
/// A segment on a face of the cell. The labels are those on its left and right seen from outside.
struct Segment
{
  int First;
  int Second;
  Index Left;
  Index Right;

  bool Has(int point) const { return this->First == point || this->Second == point; }
  int OtherEnd(int point) const { return this->First == point ? this->Second : this->First; }
};

/// All segments of a cell, or connected ones.
struct Segments
{
  std::array<Segment, 24> SegmentArray; ///< Only the first Count.
  std::size_t Count = 0;

  void Add(const Segment& segment) { this->SegmentArray[this->Count++] = segment; }
  const Segment* begin() const { return this->SegmentArray.data(); }
  const Segment* end() const { return this->SegmentArray.data() + this->Count; }
  auto Degree(int point) const
  {
    return std::count_if(
      this->begin(), this->end(), [&](const Segment& segment) { return segment.Has(point); });
  }
};

/// The segments on all faces. Sets the positions of the surface's points on faces.
Segments FindSegments(const CellLabels& labels, CellSurface& surface);

/// The connected parts of the segments, numbered by their largest point.
class SegmentParts
{
public:
  explicit SegmentParts(const Segments& segments);

  /// Whether a part has this number.
  bool HasPart(int point) const { return this->Sizes[static_cast<std::size_t>(point)] > 0; }
  Segments PartOf(int point) const;

private:
  int RootOf(int point) const;

  const Segments& AllSegments;
  std::array<int, FirstInnerPoint> Parents = {};
  std::array<int, FirstInnerPoint> Sizes = {}; ///< Number of segments.
};
}

#endif
