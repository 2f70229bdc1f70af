// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelCheck.h"

#include "Base/Parallel.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
VoxelBox Union(const VoxelBox& a, const VoxelBox& b)
{
  VoxelBox box;
  for (std::size_t k = 0; k < 3; ++k)
  {
    box.First[k] = std::min(a.First[k], b.First[k]);
    box.Count[k] = std::max(a.First[k] + a.Count[k], b.First[k] + b.Count[k]) - box.First[k];
  }
  return box;
}

VoxelBox Intersection(const VoxelBox& a, const VoxelBox& b)
{
  VoxelBox box;
  for (std::size_t k = 0; k < 3; ++k)
  {
    box.First[k] = std::max(a.First[k], b.First[k]);
    box.Count[k] = std::max<std::int64_t>(
      0, std::min(a.First[k] + a.Count[k], b.First[k] + b.Count[k]) - box.First[k]);
  }
  return box;
}

VoxelBox BoxOf(const VoxelGrid& grid)
{
  const std::array<Index, 3>& size = grid.Dimensions;
  return { { 0, 0, 0 }, { size[0], size[1], size[2] } };
}

std::int64_t NumberOfVoxels(const VoxelBox& box)
{
  return box.Count[0] * box.Count[1] * box.Count[2];
}

bool Contains(const VoxelBox& box, std::size_t axis, std::int64_t index)
{
  return index >= box.First[axis] && index < box.First[axis] + box.Count[axis];
}

/// The rows of an image as indices of labels.
class ImageRows
{
public:
  ImageRows(const LabelImage& image, const std::vector<std::int64_t>& values)
    : Image(image)
    , Values(values)
  {
  }

  /// @param y,z Voxel indices.
  /// @param labels Filled with background before.
  void Row(std::int64_t y, std::int64_t z, const VoxelBox& box, std::vector<Index>& labels) const
  {
    const std::array<Index, 3>& size = this->Image.Grid.Dimensions;
    if (y < 0 || y >= size[1] || z < 0 || z >= size[2])
    {
      return;
    }
    WithLabelsOf(this->Image,
      [&](const auto* voxels)
      {
        const auto* row = voxels + size[0] * (y + size[1] * z);
        for (std::int64_t x = 0; x < size[0]; ++x)
        {
          labels[static_cast<std::size_t>(x - box.First[0])] =
            this->IndexOf(static_cast<std::int64_t>(row[x]));
        }
      });
  }

private:
  Index IndexOf(std::int64_t value) const
  {
    if (this->Values.empty())
    {
      return value != 0 ? 0 : 1;
    }
    const auto end = this->Values.end() - 1;
    const auto at = std::lower_bound(this->Values.begin(), end, value);
    return static_cast<Index>((at != end && *at == value ? at : end) - this->Values.begin());
  }

  const LabelImage& Image;
  const std::vector<std::int64_t>& Values;
};

/// Counts the changes of one slice.
class SliceSum
{
public:
  /// @param image Outside of it, voxels that are background in both are not compared.
  SliceSum(const VoxelBox& box, const VoxelBox& image, const VoxelCheckSettings& settings)
    : Box(box)
    , Image(image)
    , Background(settings.NumberOfLabels - 1)
  {
    this->Changes.OfLabel.resize(static_cast<std::size_t>(settings.NumberOfLabels));
  }

  /// @param edge Number of voxels at both ends of the row that are not compared.
  void AddRow(const std::vector<Index>& before, const std::vector<Index>& after, std::int64_t y,
    std::int64_t z, std::int64_t edge)
  {
    const bool isRowOfImage = Contains(this->Image, 1, y + this->Box.First[1]) &&
      Contains(this->Image, 2, z + this->Box.First[2]);
    for (std::int64_t x = edge; x < this->Box.Count[0] - edge; ++x)
    {
      const std::size_t i = static_cast<std::size_t>(x);
      const bool isOfImage = isRowOfImage && Contains(this->Image, 0, x + this->Box.First[0]);
      if (!isOfImage && before[i] == this->Background && after[i] == this->Background)
      {
        continue;
      }
      ++this->Changes.Compared;
      this->Count(before[i], &LabelChanges::Voxels);
      if (before[i] != after[i])
      {
        const std::array<std::int64_t, 3> voxel = { x + this->Box.First[0], y + this->Box.First[1],
          z + this->Box.First[2] };
        this->Changes.FirstChanged =
          this->Changes.Changed == 0 ? voxel : this->Changes.FirstChanged;
        ++this->Changes.Changed;
        this->Count(before[i], &LabelChanges::Lost);
        this->Count(after[i], &LabelChanges::Gained);
      }
    }
  }

  VoxelChanges Changes;

private:
  void Count(Index label, std::int64_t LabelChanges::*number)
  {
    if (label >= 0 && label <= this->Background)
    {
      ++(this->Changes.OfLabel[static_cast<std::size_t>(label)].*number);
    }
  }

  const VoxelBox& Box;
  const VoxelBox& Image;
  Index Background;
};

VoxelChanges Total(const std::vector<VoxelChanges>& slices, Index labels)
{
  VoxelChanges total;
  total.OfLabel.resize(static_cast<std::size_t>(labels));
  for (const VoxelChanges& slice : slices)
  {
    total.FirstChanged =
      total.Changed == 0 && slice.Changed > 0 ? slice.FirstChanged : total.FirstChanged;
    total.Compared += slice.Compared;
    total.Changed += slice.Changed;
    for (std::size_t i = 0; i < slice.OfLabel.size(); ++i)
    {
      total.OfLabel[i].Voxels += slice.OfLabel[i].Voxels;
      total.OfLabel[i].Lost += slice.OfLabel[i].Lost;
      total.OfLabel[i].Gained += slice.OfLabel[i].Gained;
    }
  }
  return total;
}

struct Comparison
{
  const VoxelRows& Result;
  VoxelBox Box;
  VoxelBox Image; // what is outside of the box is background in both surfaces
  bool IsOpen;
  const VoxelCheckSettings& Settings;

  /// @param makeReference Makes an object for one worker with Begin(z) and Row(y, z, labels), which
  ///   sets None in rows that cross no triangle.
  template <typename MakeReference>
  VoxelChanges Run(const MakeReference& makeReference, const Monitor& monitor) const
  {
    const std::size_t count = static_cast<std::size_t>(this->Box.Count[2]);
    std::vector<VoxelChanges> slices(count);
    const bool done = ForEachPart(count, this->Settings.Threads, monitor,
      [&](std::size_t slice)
      {
        const std::int64_t z = static_cast<std::int64_t>(slice);
        auto reference = makeReference();
        reference.Begin(z);
        slices[slice] = this->CompareSlice(reference, z);
      });
    VoxelChanges changes = Total(slices, this->Settings.NumberOfLabels);
    const std::int64_t outside = this->IsOpen
      ? 0
      : NumberOfVoxels(this->Image) - NumberOfVoxels(Intersection(this->Image, this->Box));
    changes.Compared += outside;
    changes.OfLabel.back().Voxels += outside;
    changes.IsDone = done;
    return changes;
  }

private:
  template <typename Reference>
  VoxelChanges CompareSlice(Reference& reference, std::int64_t z) const
  {
    const std::int64_t edge = this->IsOpen ? 1 : 0;
    SliceSum sum(this->Box, this->Image, this->Settings);
    VoxelRows::Slice result(this->Result, this->Box);
    result.Begin(z);
    std::vector<Index> before;
    std::vector<Index> after;
    const bool isCompared = z >= edge && z < this->Box.Count[2] - edge;
    for (std::int64_t y = edge; y < this->Box.Count[1] - edge && isCompared; ++y)
    {
      reference.Row(y, z, before);
      result.Row(y, this->IsOpen, after);
      this->FillUncrossed(before, after);
      sum.AddRow(before, after, y, z, edge);
    }
    return sum.Changes;
  }

  /// A row that crosses no triangle has one label: the background, or, at an open surface, one that
  /// is not known: then it counts as that of the other row.
  void FillUncrossed(std::vector<Index>& before, std::vector<Index>& after) const
  {
    const Index background = this->Settings.NumberOfLabels - 1;
    const std::size_t inner = before.size() > 2 ? 1 : 0;
    const auto fill = [&](std::vector<Index>& row, const std::vector<Index>& other)
    {
      const Index known = this->IsOpen && other[inner] >= 0 ? other[inner] : background;
      std::replace(row.begin(), row.end(), None, known);
    };
    if (!before.empty())
    {
      fill(before, after);
      fill(after, before);
    }
  }
};

/// The slices of a surface as a reference.
class SurfaceReference
{
public:
  SurfaceReference(const VoxelRows& rows, const VoxelBox& box, bool isOpen)
    : Rows(rows, box)
    , IsOpen(isOpen)
  {
  }
  void Begin(std::int64_t z) { this->Rows.Begin(z); }
  void Row(std::int64_t y, std::int64_t, std::vector<Index>& labels)
  {
    this->Rows.Row(y, this->IsOpen, labels);
  }

private:
  VoxelRows::Slice Rows;
  bool IsOpen;
};

class ImageReference
{
public:
  ImageReference(const ImageRows& rows, const VoxelBox& box, Index background)
    : Rows(rows)
    , Box(box)
    , Background(background)
  {
  }
  void Begin(std::int64_t) {}
  void Row(std::int64_t y, std::int64_t z, std::vector<Index>& labels)
  {
    labels.assign(static_cast<std::size_t>(this->Box.Count[0]), this->Background);
    this->Rows.Row(y + this->Box.First[1], z + this->Box.First[2], this->Box, labels);
  }

private:
  const ImageRows& Rows;
  const VoxelBox& Box;
  Index Background;
};
}

VoxelChanges CompareVoxels(const LabeledSurface& reference, const LabeledSurface& result,
  const VoxelCheckSettings& settings, const Monitor& monitor)
{
  const Index background = settings.NumberOfLabels - 1;
  const VoxelRows before(reference, settings.Grid, background, settings.Threads);
  const VoxelRows after(result, settings.Grid, background, settings.Threads);
  const VoxelBox both =
    result.Surface.Triangles.empty() ? before.Bounds() : Union(before.Bounds(), after.Bounds());
  const bool isOpen = HasBoundary(reference.Surface);
  // An open surface ends at the outermost voxel centers. Rounding must not turn these into inner
  // ones.
  const bool endsAtImage = isOpen && settings.Grid.Dimensions[0] > 0;
  const VoxelBox box = endsAtImage ? Intersection(both, BoxOf(settings.Grid)) : both;
  const VoxelBox image = settings.Grid.Dimensions[0] > 0 ? BoxOf(settings.Grid) : both;
  const Comparison comparison = { after, box, image, isOpen, settings };
  return comparison.Run([&] { return SurfaceReference(before, box, isOpen); }, monitor);
}

//------------------------------------------------------------------------------
VoxelChanges CompareVoxels(const LabelImage& image, const std::vector<std::int64_t>& values,
  const LabeledSurface& result, const VoxelCheckSettings& settings, const Monitor& monitor)
{
  const Index background = settings.NumberOfLabels - 1;
  const VoxelRows after(result, image.Grid, background, settings.Threads);
  const VoxelBox whole = BoxOf(image.Grid);
  const bool isOpen = HasBoundary(result.Surface);
  const VoxelBox box =
    result.Surface.Triangles.empty() || isOpen ? whole : Union(whole, after.Bounds());
  const ImageRows rows(image, values);
  const Comparison comparison = { after, box, whole, isOpen, settings };
  return comparison.Run([&] { return ImageReference(rows, box, background); }, monitor);
}
}
