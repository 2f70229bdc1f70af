// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceTimeTree.h"

#include <algorithm>
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

SpaceTimeTree::SpaceTimeTree(std::vector<TimedBox> boxes)
  : Boxes(std::move(boxes))
{
  while (this->Leaves * OfLeaf < this->Boxes.size())
  {
    this->Leaves *= 2;
  }
  this->Nodes.assign(2 * this->Leaves, TimedBox{ FloatBox(), Never, None });
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    Extend(this->Nodes[this->Leaves + i / OfLeaf], this->Boxes[i]);
  }
  for (std::size_t i = this->Leaves; --i > 0;)
  {
    Extend(this->Nodes[i], this->Nodes[2 * i]);
    Extend(this->Nodes[i], this->Nodes[2 * i + 1]);
  }
}

//------------------------------------------------------------------------------
/// Nodes may hold too long a time.
void SpaceTimeTree::SetReplaced(std::size_t position, bool isThere)
{
  this->Boxes[position].Replaced = isThere ? Never : None;
  for (std::size_t at = this->Leaves + position / OfLeaf; isThere && at > 0; at /= 2)
  {
    this->Nodes[at].Replaced = Never;
  }
}
}
