// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LayerDivision.h
 * @brief Which layers of a volume become a slab, of which two neighbors have a layer in common.
 */
#ifndef BoneDecimate_Applications_LayerDivision_h
#define BoneDecimate_Applications_LayerDivision_h

#include "Volume.h"

#include <cstdint>
#include <vector>

namespace bonedecimate::volume
{
/**
 * @param triangles About how many there are between each layer and the next one.
 * @param mostTriangles,mostLayers Limits of a slab, which has at least two layers.
 * @return The last layer of each slab.
 */
std::vector<std::int64_t> DivideLayers(
  const std::vector<std::int64_t>& triangles, std::int64_t mostTriangles, std::int64_t mostLayers);

/// The counts of a slab are added to those of the slabs before, with which it has a layer in
/// common.
void AppendCounts(const std::vector<std::int64_t>& ofSlab, std::vector<std::int64_t>& counts);

/// Counts, for each layer of a label map or slab, the pairs of neighbors with different labels, in
/// the layer and between it and the next one. A surface of all labels has about twice as many
/// triangles.
std::vector<std::int64_t> CountLabelChanges(const Volume& slab);
}

#endif
