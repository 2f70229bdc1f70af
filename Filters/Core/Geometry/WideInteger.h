// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WideInteger.h
 * @brief Integers of 128 bits, for exact products of fixed-point coordinates.
 */
#ifndef BoneDecimate_Core_Geometry_WideInteger_h
#define BoneDecimate_Core_Geometry_WideInteger_h

#ifndef __SIZEOF_INT128__
#error "Exact predicates need integers of 128 bits: GCC or Clang for a 64-bit processor."
#endif

namespace bonedecimate
{
__extension__ typedef __int128 WideInteger;

/// 1, 0 or -1.
inline int SignOf(WideInteger value)
{
  return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}
}

#endif
