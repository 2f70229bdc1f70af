// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceTimeTree.h"

#include "Parallel.h"

#include <utility>

namespace bonedecimate
{
namespace
{
void Extend(TimedBox& node, const TimedBox& other)
{
  node.Box.Add(other.Box);
  node.Made = std::min(node.Made, other.Made);
  node.Replaced = std::max(node.Replaced, other.Replaced);
}
}

SpaceTimeTree::SpaceTimeTree(std::vector<TimedBox> boxes, int threads)
  : Boxes(std::move(boxes))
{
  while (this->Leaves * OfLeaf < this->Boxes.size())
  {
    this->Leaves *= 2;
  }
  const std::size_t used = (this->Boxes.size() + OfLeaf - 1) / OfLeaf;
  this->Nodes.assign(this->Leaves + used, TimedBox{ FloatBox(), Never, None });
  ForEachId(used, threads,
    [&](std::size_t leaf)
    {
      const std::size_t end = std::min(this->Boxes.size(), (leaf + 1) * OfLeaf);
      for (std::size_t i = leaf * OfLeaf; i < end; ++i)
      {
        Extend(this->Nodes[this->Leaves + leaf], this->Boxes[i]);
      }
    });
  for (std::size_t i = this->Leaves; --i > 0;)
  {
    for (std::size_t child = 2 * i; child < std::min(2 * i + 2, this->Nodes.size()); ++child)
    {
      Extend(this->Nodes[i], this->Nodes[child]);
    }
  }
}
}
