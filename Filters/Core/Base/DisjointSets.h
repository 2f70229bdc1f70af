// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DisjointSets.h
 * @brief Disjoint sets of numbers (union-find).
 */
#ifndef BoneDecimate_Core_Base_DisjointSets_h
#define BoneDecimate_Core_Base_DisjointSets_h

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace bonedecimate
{
/// Sets of the numbers from 0 to count - 1, at first one number each. The root of a set is its
/// smallest number.
template <typename Number>
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), Number(0));
  }

  std::size_t Size() const { return this->Parents.size(); }

  /// Root of the set of the member. Shortens the paths to roots.
  Number Root(Number member)
  {
    while (this->ParentOf(member) != member)
    {
      this->ParentOf(member) = this->ParentOf(this->ParentOf(member));
      member = this->ParentOf(member);
    }
    return member;
  }

  void Join(Number a, Number b)
  {
    if (this->ParentOf(a) != this->ParentOf(b))
    {
      const Number rootA = this->Root(a);
      const Number rootB = this->Root(b);
      this->ParentOf(std::max(rootA, rootB)) = std::min(rootA, rootB);
    }
  }

  /// The root of each number; there are no sets afterwards.
  std::vector<Number> TakeRoots()
  {
    for (Number& parent : this->Parents)
    {
      parent = this->ParentOf(parent); // a smaller number, which already refers to its root
    }
    return std::move(this->Parents);
  }

private:
  Number& ParentOf(Number member) { return this->Parents[static_cast<std::size_t>(member)]; }

  std::vector<Number> Parents;
};
}

#endif
