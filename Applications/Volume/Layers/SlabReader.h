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

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
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
   * From the last layer of the slab before, or the first one, to the given layer. The layers are
   * the extent of the image along its third axis.
   * @param lastLayer Beyond the last layer of the slab before and less than the number of layers.
   * @throws std::bad_alloc
   */
  Volume ReadTo(std::int64_t lastLayer);

private:
  std::unique_ptr<IsolatedReader> Reader;
  std::vector<char> SharedLayer; ///< The last one of the slab before.
  std::int64_t NextLayer = 0;
};

/// Calls visit(slab) for slabs of about 64 MiB, until the last layer or a problem, which is that of
/// a slab or what visit returns.
/// @return The problem; empty if there is none. @throws std::bad_alloc
std::string VisitSlabs(SlabReader& reader, const std::function<std::string(const Volume&)>& visit);

/// Why a file that is read again cannot be: its own problem, or that it is not as it was. Empty if
/// it can.
/// @param size,bytesInALayer When it was read first.
std::string ProblemOfSecondReading(
  const VolumeHeader& header, const std::array<std::int64_t, 3>& size, std::size_t bytesInALayer);
}

#endif
