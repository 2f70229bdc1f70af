// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GapRule.h
 * @brief Initial gap width at the original vertices that each vertex of the current mesh
 * represents.
 *
 *     initially:  the distance to other fragments, and to triangles of the own fragment
 *                 that face the vertex (FragmentTree.h)
 *     merged:     the smaller widths of both
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
/// Gap widths, mm; infinite where nothing is near.
struct Gap
{
  float WithinFragment = std::numeric_limits<float>::infinity();   ///< To facing triangles.
  float BetweenFragments = std::numeric_limits<float>::infinity(); ///< To other fragments.

  bool operator==(const Gap& other) const
  {
    return this->WithinFragment == other.WithinFragment &&
      this->BetweenFragments == other.BetweenFragments;
  }
};

/// The smaller widths of both.
inline Gap Min(const Gap& a, const Gap& b)
{
  return { std::min(a.WithinFragment, b.WithinFragment),
    std::min(a.BetweenFragments, b.BetweenFragments) };
}

class GapRule
{
public:
  /// @param limit mm; wider gaps count as none. 0: no gap is measured.
  /// @param monitor After an abort, the object must not be used.
  GapRule(const Surface& surface, double limit, int threads, const Monitor& monitor = {});

  Index FragmentOf(Index vertex) const { return this->Fragments.OfPoint[vertex]; }
  const Gap& Of(Index vertex) const { return this->Widths[vertex]; }
  Gap MinOf(const Triangle& vertices) const
  {
    return Min(Min(this->Of(vertices[0]), this->Of(vertices[1])), this->Of(vertices[2]));
  }
  void Set(Index vertex, const Gap& gap) { this->Widths[vertex] = gap; }
  void Copy(Index from, Index to)
  {
    this->Widths[to] = this->Widths[from];
    this->Fragments.OfPoint[to] = this->Fragments.OfPoint[from];
  }

private:
  Components Fragments;
  std::vector<Gap> Widths; // of each vertex
};

/// mm, the least distance between two fragments of a surface; infinite if there is only one.
double MinFragmentGap(const Surface& surface);
}

#endif
