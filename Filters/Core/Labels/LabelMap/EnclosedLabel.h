// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EnclosedLabel.h
 * @brief Which label of a map a surface encloses that does not say it.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_EnclosedLabel_h
#define BoneDecimate_Core_Labels_LabelMap_EnclosedLabel_h

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
struct EnclosedLabel
{
  std::int64_t Label = 0;
  std::string Problem; ///< One sentence; empty if the label is known.
};

/**
 * @param values The values of the map, ascending.
 * @param wanted The background: the only other label of the map.
 */
EnclosedLabel FindEnclosedLabel(
  const std::vector<std::int64_t>& values, std::int64_t wanted, std::int64_t background);
}

#endif
