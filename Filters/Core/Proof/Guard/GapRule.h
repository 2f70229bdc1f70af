// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GapRule.h
 * @brief Initial gap width at the original vertices that each vertex of the current mesh represents.
 *
 *     at first:   the distance to the other fragments, and to what faces the vertex within its own fragment (PartTree.h)
 *     merged:     the smaller of both
 */
#ifndef BoneDecimate_Core_Proof_Guard_GapRule_h
#define BoneDecimate_Core_Proof_Guard_GapRule_h

#include "Base/Monitor.h"
#include "Mesh/Statistics.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace bonedecimate
{
/// mm; infinite where nothing is near.
struct Gap
{
  float ToOwn = std::numeric_limits<float>::infinity();   ///< To what faces it within its fragment.
  float ToOther = std::numeric_limits<float>::infinity(); ///< To other fragments.

  Gap And(const Gap& other) const
  {
    return { std::min(this->ToOwn, other.ToOwn), std::min(this->ToOther, other.ToOther) };
  }
  bool operator==(const Gap& other) const
  {
    return this->ToOwn == other.ToOwn && this->ToOther == other.ToOther;
  }
};

class GapRule
{
public:
  /// @param limit mm; wider gaps count as none. 0: no gap is measured.
  /// @param monitor If it says stop, what is there must not be used.
  GapRule(const Surface& surface, double limit, int threads, const Monitor& monitor = {});

  Index PartOf(Index vertex) const { return this->Parts.OfPoint[vertex]; }
  const Gap& Of(Index vertex) const { return this->Widths[vertex]; }
  Gap MinOf(const Triangle& vertices) const
  {
    return this->Of(vertices[0]).And(this->Of(vertices[1])).And(this->Of(vertices[2]));
  }
  void Set(Index vertex, const Gap& gap) { this->Widths[vertex] = gap; }
  void Copy(Index from, Index to)
  {
    this->Widths[to] = this->Widths[from];
    this->Parts.OfPoint[to] = this->Parts.OfPoint[from];
  }

private:
  Components Parts;
  std::vector<Gap> Widths; // of each vertex
};

/// mm, the least distance between two fragments of a surface; infinite if there is one only.
double MinFragmentGap(const Surface& surface);
}

#endif
