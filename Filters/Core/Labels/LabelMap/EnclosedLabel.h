// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EnclosedLabel.h
 * @brief The label of a map that a surface without labels encloses.
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
 * @param requested A label, or the background: then the map must have one other label.
 */
EnclosedLabel FindEnclosedLabel(
  const std::vector<std::int64_t>& values, std::int64_t requested, std::int64_t background);
}

#endif
