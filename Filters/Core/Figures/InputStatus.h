// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputStatus.h
 * @brief Whether an input is valid, or why it was rejected.
 */
#ifndef BoneDecimate_Core_Figures_InputStatus_h
#define BoneDecimate_Core_Figures_InputStatus_h

namespace bonedecimate
{
/// Whether the input is valid, or why it was rejected.
enum class InputStatus : int
{
  Good = 0,
  Empty,                 ///< No points and no triangles: the result is empty, too.
  NoTriangles,           ///< Points, but no triangle of positive area.
  NonFinitePoints,       ///< NaN or infinite coordinates.
  HugeCoordinates,       ///< Beyond 1e30: products of areas would overflow.
  IndexOutOfRange,       ///< A triangle has a point index out of range.
  TooManyTriangles,      ///< More than 2^31 / 4 triangles.
  BadTolerances,         ///< NaN or infinite, or not one for each point.
  BadEdgeLengths,        ///< Not above 0, NaN or infinite, or not one for each point.
  UnprovableTolerances,  ///< Thesis mode proves nothing: it allows only 0 and no limit.
  ReferenceWithoutError, ///< A reference needs a largest error.
  BadReference,          ///< It has no triangle, or would be rejected as an input.
  FarFromReference,      ///< The input is farther from it than the largest error.
  EverythingPruned,      ///< No component reaches the requested size.
  /// Rounding moves points farther than the error or tolerances allow, or onto other points.
  RoundingTooCoarse,
  /// The largest error is more than a quarter of the diagonal, and AllowLargeError is off.
  ErrorBeyondSize,
  /// The largest error is less than a millionth of the diagonal: rounding alone exceeds it.
  ErrorBelowSize,
  /// The grid is not valid, labels are not one pair per triangle, or the surface is far from it.
  BadLabelMap,
  NoVoxelGrid, ///< KeepVoxels is On and no grid is known.
  /// An option that does not go with another one or with an input; Report::Conflict.
  OptionConflict,
  InvalidOption ///< A value is outside of the range of its option.
};
}

#endif
