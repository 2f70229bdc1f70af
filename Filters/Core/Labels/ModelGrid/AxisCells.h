// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AxisCells.h
 * @brief The coarsest uniform cells along an axis that explain between which layers labels change.
 *
 * Position x is in layers: layer i has its center at i. Boundaries of cells lie at
 *
 *     t(k) = Boundary + k Length        Length > 1
 *
 * A change between the layers i - 1 and i is explained by a boundary in [i - 1, i]. Both ends are
 * allowed, so any rule of rounding is: a layer whose center lies on a boundary belongs to the cell
 * on either side. Each boundary explains one change.
 *
 *     regions := all (Boundary, Length) that explain the first change
 *     for each further change: clip each region to the strip of each boundary that can explain it
 *     candidates: lines as programs make them, and the middles of the coarsest regions
 *     result: the candidate by which random changes would be explained with the least chance,
 *       which is one of the coarsest
 *
 * Regions are convex polygons. Two boundaries that explain the same change make two regions, of
 * which the next changes leave few.
 */
#ifndef BoneDecimate_Core_Labels_ModelGrid_AxisCells_h
#define BoneDecimate_Core_Labels_ModelGrid_AxisCells_h

#include "Geometry/Surface.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
struct AxisCells
{
  double Length = 1.0;      ///< Layers per cell.
  double FirstSample = 0.0; ///< Position of the center of cell 0, in layers.
  /// The cell of each layer, ascending from 0 without gaps.
  std::vector<Index> OfLayer;
  /// Probability that as many changes at random layers would be explained by some cells.
  double Chance = 1.0;

  /// Whether cells were found; otherwise each layer is a cell.
  bool IsFound() const { return this->Length > 1.0; }
  Index Count() const { return this->OfLayer.back() + 1; }
};

/// Each layer is a cell.
AxisCells CellsOfLayers(Index layers);

struct CellLengths
{
  double Min = 1.0;
  double Max = 0.0;       ///< 0: not limited.
  double UsualStep = 0.0; ///< Models have whole multiples of this; 0: not known.
};

/**
 * @param changes Layers before which labels change, ascending, 1 to layers - 1.
 * @param layers Number of layers.
 * @return Nothing if no cells explain all changes.
 */
std::optional<AxisCells> FindAxisCells(
  const std::vector<Index>& changes, Index layers, const CellLengths& lengths);
}

#endif
