// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditTotals.h
 * @brief What an editor has done so far.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_EditTotals_h
#define BoneDecimate_Core_Decimate_Edit_EditTotals_h

#include "Figures/EditFigures.h"
#include "Geometry/Surface.h"

namespace bonedecimate
{
/// As the report has them, and more. Rejections are those of collapses alone.
struct EditTotals : EditFigures
{
  std::int64_t Splits = 0;
  /// Vertices that are constrained because of their own tolerance; duplicates count once.
  Index ConstrainedVertices = 0;

  /// Whether a collapse was rejected because it could not be proved to keep the error bound.
  bool MetErrorBound() const
  {
    return this->Rejections[static_cast<std::size_t>(Rejection::ErrorBound)] > 0;
  }
};
}

#endif
