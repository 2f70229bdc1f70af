// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpaceTimeTree.h
 * @brief Finds boxes that exist between two edits of a journal by box and time.
 *
 * A binary tree over the boxes as they come, which should lie near each other in that order.
 */
#ifndef BoneDecimate_Core_Intersections_SpaceTimeTree_h
#define BoneDecimate_Core_Intersections_SpaceTimeTree_h

#include "FloatBox.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace bonedecimate
{
/// It exists after the edit Made and before the edit Replaced.
struct TimedBox
{
  FloatBox Box;
  Index Made;
  Index Replaced;

  /// Whether it meets the other one while both exist. One that is made and replaced by the same edit exists just before it.
  bool MeetsWhile(const TimedBox& other) const
  {
    unsigned meets = static_cast<unsigned>(this->Made < other.Replaced); // without branches
    meets &= static_cast<unsigned>(this->Replaced > other.Made);
    meets &= static_cast<unsigned>(this->Box.Meets(other.Box));
    return meets != 0;
  }
};

class SpaceTimeTree
{
public:
  static constexpr Index Never = std::numeric_limits<Index>::max();

  explicit SpaceTimeTree(std::vector<TimedBox> boxes, int threads = 1);

  /// Calls visit(position) for each box that meets the given one, was made before the edit and is replaced after it.
  template <typename Visit>
  void VisitAt(const FloatBox& box, Index edit, const Visit& visit) const
  {
    this->VisitWhile({ box, edit, edit }, [&](const TimedBox&, std::size_t i) { visit(i); });
  }

  /// Whether a box meets the given one while both exist.
  bool HasWhile(const TimedBox& box) const
  {
    bool has = false;
    this->Descend([&](const TimedBox& node) { return node.MeetsWhile(box); },
      [&](std::size_t) { return !(has = true); });
    return has;
  }

  /// Calls visit(timed box, position) for each box that meets the given one while both exist.
  template <typename Visit>
  void VisitWhile(const TimedBox& box, const Visit& visit) const
  {
    this->Descend([&](const TimedBox& node) { return node.MeetsWhile(box); },
      [&](std::size_t i)
      {
        visit(this->Boxes[i], i);
        return true;
      });
  }

private:
  static constexpr std::size_t OfLeaf = 8; // boxes

  /// Calls visit(position) for each box that is chosen, until it is false. A node that holds such a box is chosen, too.
  template <typename IsChosen, typename Visit>
  void Descend(const IsChosen& isChosen, const Visit& visit) const
  {
    std::array<std::size_t, 64> stack;
    std::size_t size = 0;
    stack[size++] = 1;
    while (size > 0)
    {
      const std::size_t at = stack[--size];
      if (at >= this->Nodes.size() || !isChosen(this->Nodes[at]))
      {
        continue;
      }
      if (at < this->Leaves)
      {
        stack[size++] = 2 * at + 1;
        stack[size++] = 2 * at;
        continue;
      }
      const std::size_t first = (at - this->Leaves) * OfLeaf;
      for (std::size_t i = first; i < std::min(this->Boxes.size(), first + OfLeaf); ++i)
      {
        if (isChosen(this->Boxes[i]) && !visit(i))
        {
          return;
        }
      }
    }
  }

  std::vector<TimedBox> Boxes;
  std::size_t Leaves = 1; // a power of two
  std::vector<TimedBox>
    Nodes; // children of i: 2 i and 2 i + 1; the root is 1; without empty ones at the end
};
}

#endif
