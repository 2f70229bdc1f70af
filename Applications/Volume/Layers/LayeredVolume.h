// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LayeredVolume.h
 * @brief A volume whose voxels are read layer by layer along k, in order and once.
 */
#ifndef BoneDecimate_Applications_LayeredVolume_h
#define BoneDecimate_Applications_LayeredVolume_h

#include "Volume.h"

#include "vtkFieldData.h"

#include <cstdint>
#include <functional>

namespace bonedecimate::volume
{
/// What is known of a volume before its voxels are read.
struct VolumeHeader
{
  std::array<std::int64_t, 3> Size{ { 0, 0, 0 } };
  int ScalarType = VTK_VOID;
  VolumeGeometry Geometry;
  LayerPositions Layers;
  vtkSmartPointer<vtkFieldData> Fields = vtkSmartPointer<vtkFieldData>::New(); ///< LabelFields.h.
  bool IsReadWhole = false; ///< The format gives no single layers: its reader holds all voxels.
  std::string Problem;      ///< Why there are no voxels; empty if there are.
  std::string Note;         ///< Note of the Volume: what was left aside; may be empty.
  std::string Remark;       ///< Remark of the Volume; may be empty.

  std::size_t BytesInALayer() const;
};

struct LayeredVolume
{
  VolumeHeader Header;
  /// Writes the next layer to BytesInALayer() bytes. Returns what went wrong, or an empty text.
  std::function<std::string(void* values)> ReadLayer;
};

LayeredVolume RejectedLayers(const std::string& problem);

/// Layers of a volume that was read whole, or rejected.
LayeredVolume LayersOf(const Volume& volume);
}

#endif
