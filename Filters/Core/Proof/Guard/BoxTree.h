// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxTree.h
 * @brief Finds boxes that meet a box: a binary tree over the boxes in their order, in which
 * neighbors should lie near each other.
 */
#ifndef BoneDecimate_Core_Proof_Guard_BoxTree_h
#define BoneDecimate_Core_Proof_Guard_BoxTree_h

#include "FloatBox.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
class BoxTree
{
public:
  explicit BoxTree(std::vector<FloatBox> boxes, int threads = 1);

  const FloatBox& Box(std::size_t i) const { return this->Boxes[i]; }
  /// Replaces a box.
  void Set(std::size_t i, const FloatBox& box);

  /// Calls visit(position) for each box that meets the given one, in ascending order.
  template <typename Visit>
  void VisitMeeting(const FloatBox& box, const Visit& visit) const
  {
    std::array<std::size_t, 64> stack;
    std::size_t size = 0;
    stack[size++] = 1;
    while (size > 0)
    {
      const std::size_t at = stack[--size];
      if (at >= this->Nodes.size() || !this->Nodes[at].Meets(box))
      {
        continue;
      }
      if (at < this->Leaves)
      {
        stack[size++] = 2 * at + 1;
        stack[size++] = 2 * at;
        continue;
      }
      const std::size_t first = (at - this->Leaves) * BoxesPerLeaf;
      for (std::size_t i = first; i < std::min(this->Boxes.size(), first + BoxesPerLeaf); ++i)
      {
        if (this->Boxes[i].Meets(box))
        {
          visit(i);
        }
      }
    }
  }

private:
  static constexpr std::size_t BoxesPerLeaf = 8;

  void FillLeaf(std::size_t leaf);
  void Join(std::size_t node);

  std::vector<FloatBox> Boxes;
  std::size_t Leaves = 1; // a power of two
  // The children of i are 2 i and 2 i + 1; the root is 1. Empty ones at the end are left out.
  std::vector<FloatBox> Nodes;
};
}

#endif
