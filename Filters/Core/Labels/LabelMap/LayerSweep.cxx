// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerSweep.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
bool HasFaceX(const CellLabels& l)
{
  return HasFacePoint(l[0], l[2], l[6], l[4]);
}

bool HasFaceY(const CellLabels& l)
{
  return HasFacePoint(l[0], l[1], l[5], l[4]);
}

bool HasFaceZ(const CellLabels& l)
{
  return HasFacePoint(l[0], l[1], l[3], l[2]);
}

/**
 * From the center of a face to the mean of the midpoints of its edges with different ends. a to d
 * are the labels around the face. If one edge has equal ends, the mean lies a sixth of the width
 * from the center, away from this edge.
 */
std::array<double, 2> OffsetOnFace(Index a, Index b, Index c, Index d)
{
  constexpr double third = 0.5 / 3.0;
  const double u = b == c ? -third : d == a ? third : 0.0;
  const double v = a == b ? third : c == d ? -third : 0.0;
  return { u, v };
}

Vector3 OffsetOnFaceX(const CellLabels& l)
{
  const auto [y, z] = OffsetOnFace(l[0], l[2], l[6], l[4]);
  return { 0.0, y, z };
}

Vector3 OffsetOnFaceY(const CellLabels& l)
{
  const auto [x, z] = OffsetOnFace(l[0], l[1], l[5], l[4]);
  return { x, 0.0, z };
}

Vector3 OffsetOnFaceZ(const CellLabels& l)
{
  const auto [x, y] = OffsetOnFace(l[0], l[1], l[3], l[2]);
  return { x, y, 0.0 };
}
}

//------------------------------------------------------------------------------
void CellSurfaces::Find(const CellLabels& labels)
{
  const auto [least, largest] = std::minmax_element(labels.begin(), labels.end());
  this->MinRank = *least;
  this->MaxRank = *largest;
  unsigned int cellCase = 0;
  unsigned int smaller = 0;
  for (unsigned int corner = 0; corner < labels.size(); ++corner)
  {
    cellCase |= (labels[corner] == this->MaxRank ? 1U : 0U) << corner;
    smaller |= (labels[corner] == this->MinRank ? 1U : 0U) << corner;
  }
  this->HasTwoLabels = (cellCase | smaller) == 255U;
  this->CurrentSurface = &this->Table[cellCase];
  if (!this->HasTwoLabels)
  {
    BuildCellSurface(labels, this->BuiltSurface);
    this->CurrentSurface = &this->BuiltSurface;
  }
}

//------------------------------------------------------------------------------
void LayerCounter::Count(Index first, Index last, LayerCounts* counts)
{
  this->Layers.Load(first, this->Lower);
  for (Index layer = first; layer < last; ++layer)
  {
    const bool hasCells = layer + 1 < this->Layers.Depth();
    if (hasCells)
    {
      this->Layers.Load(layer + 1, this->Upper);
    }
    counts[layer - first] =
      this->CountLayer(this->Lower, hasCells ? this->Upper : this->Lower, hasCells);
    std::swap(this->Lower, this->Upper);
  }
}

//------------------------------------------------------------------------------
LayerCounts LayerCounter::CountLayer(const RankLayer& lower, const RankLayer& upper, bool hasCells)
{
  LayerCounts counts;
  VisitDifferentVoxels(this->Layers, lower, upper,
    [&](const VoxelVisit& visit)
    {
      const CellLabels& l = visit.Labels;
      counts.InLayer += (l[0] != l[1]) + (l[0] != l[2]) + (HasFaceZ(l) ? 1 : 0);
      counts.Between += (l[0] != l[4]) + (HasFaceX(l) ? 1 : 0) + (HasFaceY(l) ? 1 : 0);
      if (visit.HasCell && hasCells)
      {
        this->Cells.Find(l);
        counts.Triangles += static_cast<std::int64_t>(this->Cells.Surface().NumberOfTriangles());
        counts.Inner += static_cast<std::int64_t>(this->Cells.Surface().NumberOfInnerPoints());
      }
    });
  return counts;
}

//------------------------------------------------------------------------------
LayerWriter::LayerWriter(
  const VoxelLayers& layers, const std::vector<LayerStart>& starts, LabelSurfaces& result)
  : Layers(layers)
  , Starts(starts)
  , Result(result)
  , Background(result.Source.Background())
  , IsMirrored(result.Source.Grid.Direction.determinant() < 0.0)
{
  const std::size_t size = layers.VoxelsInALayer();
  for (Layer* layer : { &this->Lower, &this->Upper })
  {
    layer->EdgeX.resize(size);
    layer->EdgeY.resize(size);
    layer->FaceZ.resize(size);
  }
  this->Between.EdgeZ.resize(size);
  this->Between.FaceX.resize(size);
  this->Between.FaceY.resize(size);
}

//------------------------------------------------------------------------------
void LayerWriter::Write(Index first, Index last)
{
  this->LoadLayer(first, true, this->Lower);
  for (Index layer = first; layer < last && layer + 1 < this->Layers.Depth(); ++layer)
  {
    this->LoadLayer(layer + 1, layer + 1 < last, this->Upper);
    this->WritePointsBetween(layer);
    this->WriteCells(layer);
    std::swap(this->Lower, this->Upper);
  }
}

//------------------------------------------------------------------------------
GridPoint LayerWriter::GridPointOf(const VoxelVisit& voxel, Index layer, const GridPoint& odd) const
{
  const Index first = this->Layers.First();
  return { 2 * (voxel.X + first) + odd[0], 2 * (voxel.Y + first) + odd[1],
    2 * (layer + this->Layers.FirstLayer()) + odd[2] };
}

//------------------------------------------------------------------------------
void LayerWriter::WritePoint(Index id, const GridPoint& center, const Vector3& offset) const
{
  const Vector3 voxels = 0.5 * Vector3(center[0], center[1], center[2]) + offset;
  const auto point = static_cast<std::size_t>(id);
  this->Result.Surface.Points[point] = this->Result.Source.Grid.ToMillimeters(voxels);
  this->Result.Source.OfPoint[point] = center;
}

//------------------------------------------------------------------------------
void LayerWriter::LoadLayer(Index index, bool writesPoints, Layer& layer) const
{
  this->Layers.Load(index, layer.Ranks);
  Index id = this->Starts[static_cast<std::size_t>(index)].InLayer;
  const auto add =
    [&](Index& entry, const VoxelVisit& voxel, const GridPoint& odd, const Vector3& offset)
  {
    entry = id++;
    if (writesPoints)
    {
      this->WritePoint(entry, this->GridPointOf(voxel, index, odd), offset);
    }
  };
  VisitDifferentVoxels(this->Layers, layer.Ranks, layer.Ranks,
    [&](const VoxelVisit& voxel)
    {
      const CellLabels& l = voxel.Labels;
      if (l[0] != l[1])
      {
        add(layer.EdgeX[voxel.Voxel], voxel, { 1, 0, 0 }, Vector3::Zero());
      }
      if (l[0] != l[2])
      {
        add(layer.EdgeY[voxel.Voxel], voxel, { 0, 1, 0 }, Vector3::Zero());
      }
      if (HasFaceZ(l))
      {
        add(layer.FaceZ[voxel.Voxel], voxel, { 1, 1, 0 }, OffsetOnFaceZ(l));
      }
    });
}

//------------------------------------------------------------------------------
void LayerWriter::WritePointsBetween(Index lower)
{
  Index id = this->Starts[static_cast<std::size_t>(lower)].Between;
  const auto add =
    [&](Index& entry, const VoxelVisit& voxel, const GridPoint& odd, const Vector3& offset)
  {
    entry = id++;
    this->WritePoint(entry, this->GridPointOf(voxel, lower, odd), offset);
  };
  this->Visits.clear();
  VisitDifferentVoxels(this->Layers, this->Lower.Ranks, this->Upper.Ranks,
    [&](const VoxelVisit& voxel)
    {
      const CellLabels& l = voxel.Labels;
      if (voxel.HasCell)
      {
        this->Visits.push_back(voxel);
      }
      if (l[0] != l[4])
      {
        add(this->Between.EdgeZ[voxel.Voxel], voxel, { 0, 0, 1 }, Vector3::Zero());
      }
      if (HasFaceX(l))
      {
        add(this->Between.FaceX[voxel.Voxel], voxel, { 0, 1, 1 }, OffsetOnFaceX(l));
      }
      if (HasFaceY(l))
      {
        add(this->Between.FaceY[voxel.Voxel], voxel, { 1, 0, 1 }, OffsetOnFaceY(l));
      }
    });
}

//------------------------------------------------------------------------------
void LayerWriter::FindIdsOfCells()
{
  const auto width = static_cast<std::size_t>(this->Layers.Width());
  const std::array<const Layer*, 2> layers = { &this->Lower, &this->Upper };
  for (std::size_t edge = 0; edge < EdgeCorners.size(); ++edge)
  {
    const auto corner = static_cast<unsigned int>(EdgeCorners[edge][0]);
    const Layer& layer = *layers[corner >> 2U & 1U];
    const LargeArray<Index>& ids = edge < 4 ? layer.EdgeX
      : edge < 8                            ? layer.EdgeY
                                            : this->Between.EdgeZ;
    this->IdsOfCells[edge] = ids.data() + (corner & 1U) + (corner >> 1U & 1U) * width;
  }
  for (std::size_t end = 0; end < 2; ++end)
  {
    const std::size_t face = FirstFacePoint + end;
    this->IdsOfCells[face] = this->Between.FaceX.data() + end;
    this->IdsOfCells[face + 2] = this->Between.FaceY.data() + end * width;
    this->IdsOfCells[face + 4] = layers[end]->FaceZ.data();
  }
}

//------------------------------------------------------------------------------
void LayerWriter::WriteCells(Index lower)
{
  this->FindIdsOfCells();
  const LayerStart& start = this->Starts[static_cast<std::size_t>(lower)];
  Index inner = start.Inner;
  Index triangle = start.Triangle;
  const Vector3 center = Vector3::Constant(0.5);
  for (const VoxelVisit& voxel : this->Visits)
  {
    this->Cells.Find(voxel.Labels);
    const CellSurface& cell = this->Cells.Surface();
    for (const CellTriangle& each : cell)
    {
      this->WriteTriangle(triangle++, each, voxel.Voxel, inner);
    }
    for (std::size_t k = 0; k < cell.NumberOfInnerPoints(); ++k)
    {
      this->WritePoint(inner++, this->GridPointOf(voxel, lower, { 1, 1, 1 }),
        cell.Position(FirstInnerPoint + static_cast<int>(k)) - center);
    }
  }
}

//------------------------------------------------------------------------------
void LayerWriter::WriteTriangle(
  Index id, const CellTriangle& triangle, std::size_t voxel, Index firstInner)
{
  Triangle corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int point = triangle.Points[k];
    corners[k] = point < FirstInnerPoint ? this->IdsOfCells[static_cast<std::size_t>(point)][voxel]
                                         : firstInner + point - FirstInnerPoint;
  }
  BoundaryLabels labels = { this->IndexOf(this->Cells.RankOf(triangle.From)),
    this->IndexOf(this->Cells.RankOf(triangle.To)) };
  if ((labels[0] > labels[1]) != this->IsMirrored)
  {
    std::swap(corners[1], corners[2]);
  }
  if (labels[0] > labels[1])
  {
    std::swap(labels[0], labels[1]);
  }
  this->Result.Surface.Triangles[static_cast<std::size_t>(id)] = corners;
  this->Result.Source.OfTriangle[static_cast<std::size_t>(id)] = labels;
}
}
