// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeftOut.h
 * @brief What of an input is not in the surface that was proved, and what the proof's sentence says
 * of it.
 */
#ifndef BoneDecimate_Core_Figures_LeftOut_h
#define BoneDecimate_Core_Figures_LeftOut_h

#include "Geometry/Surface.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace bonedecimate
{
struct LeftOut
{
  /// One word: "triangles", "polygons", "lines", "vertices", "components", or what a reader
  /// calls it: "objects", "segments".
  std::string Kind;
  std::int64_t Count = 0;
  std::string What;  ///< The noun for this count: "polygons of fewer than three different corners".
  std::string Where; ///< The first one: "cell 12"; may be empty.
  /// mm, no point of it is farther from the result; not a number: not known.
  double Distance = std::numeric_limits<double>::quiet_NaN();
  std::int64_t FirstTriangle = -1; ///< An input triangle instead of Where; negative: none.

  /// Where, or the first triangle; empty if neither is known.
  std::string Position() const;

  /// "3 polygons of fewer than three different corners (the first is cell 12)", with the distance
  /// if it is known.
  std::string Sentence() const;
};

/// Something that was left out before the run, with its shape.
struct LeftOutShape
{
  LeftOut Entry;
  /// mm; segments and points repeat corners. Empty: the shape is not known.
  std::vector<std::array<Vector3, 3>> Triangles;
};

/**
 * "but for 3 polygons ... and 1 line ..."; empty if a proof of that bound holds without it, because
 * all that was left out is known to be within the bound.
 * @param proved mm, the bound.
 */
std::string LeftOutClause(const std::vector<LeftOut>& leftOut, double proved);
}

#endif
