// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditTotals.h
 * @brief Counts of what an editor has done.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_EditTotals_h
#define BoneDecimate_Core_Decimate_Edit_EditTotals_h

#include "Figures/EditFigures.h"
#include "Geometry/Surface.h"

#include <cstdint>

namespace bonedecimate
{
/// The figures of the report, and more. Rejections are those of collapses alone.
struct EditTotals : EditFigures
{
  std::int64_t Splits = 0;
  /// Vertices constrained by their tolerance. All duplicates of a point count once.
  Index ConstrainedVertices = 0;

  /// Whether a collapse was rejected because the error bound could not be proved.
  bool MetErrorBound() const
  {
    return this->Rejections[static_cast<std::size_t>(Rejection::ErrorBound)] > 0;
  }
};
}

#endif
