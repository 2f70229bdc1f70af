// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StoredVoxels.h
 * @brief Voxels that lie in a file as numbers, one after the other, compressed or not; read layer
 * by layer.
 */
#ifndef BoneDecimate_Applications_StoredVoxels_h
#define BoneDecimate_Applications_StoredVoxels_h

#include "DataFile.h"
#include "ItkImage.h"
#include "Layers/LayeredVolume.h"

namespace bonedecimate::volume
{
enum class ByteOrder
{
  Little,
  Big
};

/**
 * @param header Header of a file whose size was checked: DataProblem().
 * @param data Holds numbers of the header's type and nothing else.
 */
LayeredVolume StoredLayers(const ItkHeader& header, const DataFile& data, ByteOrder order);
}

#endif
