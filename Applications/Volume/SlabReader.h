// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlabReader.h
 * @brief A volume in slabs: consecutive layers, of which one belongs to two neighboring slabs.
 */
#ifndef BoneDecimate_Applications_SlabReader_h
#define BoneDecimate_Applications_SlabReader_h

#include "IsolatedReader.h"
#include "Volume.h"

#include <memory>
#include <vector>

namespace bonedecimate::volume
{
class SlabReader
{
public:
  explicit SlabReader(std::unique_ptr<IsolatedReader> reader)
    : Reader(std::move(reader))
  {
  }

  const VolumeHeader& GetHeader() const { return this->Reader->GetHeader(); }

  /// Whether the last slab reached the last layer.
  bool IsAtEnd() const { return this->NextLayer >= this->GetHeader().Size[2]; }

  /**
   * From the last layer of the slab before, or the first one, to the given layer. The layers are the extent of the image along
   * its third axis.
   * @param lastLayer Beyond the last layer of the slab before and less than the number of layers.
   * @throws std::bad_alloc
   */
  Volume ReadTo(std::int64_t lastLayer);

private:
  std::unique_ptr<IsolatedReader> Reader;
  std::vector<char> SharedLayer; ///< The last one of the slab before.
  std::int64_t NextLayer = 0;
};
}

#endif
