// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LayerSweep.h
 * @brief Counts and writes the surfaces of a label map layer by layer, with two layers in memory.
 *
 * The points of a layer are, in this order, those in the layer, those on edges and faces between it
 * and the next layer, and those inside the cells between them; each in order of the voxel at the
 * least corner, x fastest. At one voxel the point of the edge along x is first, then those of the
 * edge along y and of the face. Between layers these are the edge along z, the face perpendicular
 * to x and the face perpendicular to y. Triangles have the order of their cells.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_LayerSweep_h
#define BoneDecimate_Core_Labels_LabelMap_LayerSweep_h

#include "LabelSurfaces.h"
#include "VoxelLayers.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// The points and triangles of one layer.
struct LayerCounts
{
  std::int64_t InLayer = 0;   ///< Points in the layer.
  std::int64_t Between = 0;   ///< Points on edges and faces between it and the next one.
  std::int64_t Inner = 0;     ///< Points inside the cells between them.
  std::int64_t Triangles = 0; ///< Between them.

  std::int64_t Points() const { return this->InLayer + this->Between + this->Inner; }
};

/// The index of the first point of each kind and of the first triangle of a layer.
struct LayerStart
{
  Index InLayer = 0;
  Index Between = 0;
  Index Inner = 0;
  Index Triangle = 0;
};

/// Looks up or builds the surface of a cell.
class CellSurfaces
{
public:
  void Find(const CellLabels& labels);
  const CellSurface& Surface() const { return *this->CurrentSurface; }
  /// The rank of a label of this surface.
  Index RankOf(Index label) const
  {
    return !this->HasTwoLabels ? label : label == 0 ? this->MinRank : this->MaxRank;
  }

private:
  const std::array<CellSurface, 256>& Table = TwoLabelSurfaces();
  const CellSurface* CurrentSurface = nullptr;
  CellSurface BuiltSurface;
  bool HasTwoLabels = true;
  Index MinRank = 0;
  Index MaxRank = 0;
};

/// Counts consecutive layers.
class LayerCounter
{
public:
  explicit LayerCounter(const VoxelLayers& layers)
    : Layers(layers)
  {
  }

  /// Writes the counts of the layers first to last, last not included.
  void Count(Index first, Index last, LayerCounts* counts);

private:
  LayerCounts CountLayer(const RankLayer& lower, const RankLayer& upper, bool hasCells);

  const VoxelLayers& Layers;
  RankLayer Lower;
  RankLayer Upper;
  CellSurfaces Cells;
};

/// Writes consecutive layers into a surface that already has its final size.
class LayerWriter
{
public:
  LayerWriter(
    const VoxelLayers& layers, const std::vector<LayerStart>& starts, LabelSurfaces& result);

  /// The layers first to last, last not included.
  void Write(Index first, Index last);

private:
  /// Ids of points; valid at the voxels that have such a point.
  struct Layer
  {
    RankLayer Ranks;
    LargeArray<Index> EdgeX, EdgeY, FaceZ;
  };
  struct IdsBetweenLayers
  {
    LargeArray<Index> EdgeZ, FaceX, FaceY;
  };

  void LoadLayer(Index index, bool writesPoints, Layer& layer) const;
  void WritePointsBetween(Index lower);
  void WriteCells(Index lower);
  void FindIdsOfCells();
  void WriteTriangle(Index id, const CellTriangle& triangle, std::size_t voxel, Index firstInner);
  void WritePoint(Index id, const GridPoint& center, const Vector3& offset) const;
  GridPoint GridPointOf(const VoxelVisit& voxel, Index layer, const GridPoint& odd) const;
  Index IndexOf(Index rank) const { return rank == 0 ? this->Background : rank - 1; }

  const VoxelLayers& Layers;
  const std::vector<LayerStart>& Starts;
  LabelSurfaces& Result;
  Index Background;
  bool IsMirrored; ///< The grid is left-handed.
  Layer Lower;
  Layer Upper;
  IdsBetweenLayers Between;
  LargeArray<VoxelVisit> Visits; ///< Cells of more than one label.
  /// For each point on an edge or face of a cell, the array of its ids by voxel.
  std::array<const Index*, FirstInnerPoint> IdsOfCells = {};
  CellSurfaces Cells;
};
}

#endif
