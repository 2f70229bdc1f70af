// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelGridChoice.h
 * @brief The text that says whether the grid of a network is used: auto, off, or its spacing.
 */
#ifndef BoneDecimate_Core_Labels_ModelGrid_ModelGridChoice_h
#define BoneDecimate_Core_Labels_ModelGrid_ModelGridChoice_h

#include "ModelGrid.h"

#include <optional>
#include <string>

namespace bonedecimate
{
struct ModelGridChoice
{
  std::optional<ModelGridRequest> Request; ///< Nothing: off.
  std::string Problem;                     ///< Empty if the text is valid.

  /// Whether a missing grid is an error.
  bool IsRequired() const { return this->Request && this->Request->Spacing; }
};

/// @param text auto, off, or one or three numbers with commas in between, mm.
ModelGridChoice ReadModelGridChoice(const std::string& text);

/// "1.5 x 1.5 x 3", mm.
std::string SpacingText(const VoxelGrid& grid);

/// The error if a requested grid was not found.
inline constexpr const char* NoModelGridReason =
  "the label map is not a copy of one with the requested spacing";

/// The grid found, in one sentence.
std::string ModelGridSentence(const ModelGrid& found);
}

#endif
