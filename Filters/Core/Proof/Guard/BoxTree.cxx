// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoxTree.h"

#include "Base/Parallel.h"

#include <utility>

namespace bonedecimate
{
BoxTree::BoxTree(std::vector<FloatBox> boxes, int threads)
  : Boxes(std::move(boxes))
{
  while (this->Leaves * BoxesPerLeaf < this->Boxes.size())
  {
    this->Leaves *= 2;
  }
  const std::size_t used = (this->Boxes.size() + BoxesPerLeaf - 1) / BoxesPerLeaf;
  this->Nodes.resize(this->Leaves + used);
  ForEachId(used, threads, [this](std::size_t leaf) { this->FillLeaf(leaf); });
  for (std::size_t node = this->Leaves; --node > 0;)
  {
    this->Join(node);
  }
}

//------------------------------------------------------------------------------
void BoxTree::FillLeaf(std::size_t leaf)
{
  FloatBox around;
  const std::size_t end = std::min(this->Boxes.size(), (leaf + 1) * BoxesPerLeaf);
  for (std::size_t i = leaf * BoxesPerLeaf; i < end; ++i)
  {
    around.Add(this->Boxes[i]);
  }
  this->Nodes[this->Leaves + leaf] = around;
}

//------------------------------------------------------------------------------
void BoxTree::Join(std::size_t node)
{
  this->Nodes[node] = FloatBox();
  for (std::size_t child = 2 * node; child < std::min(2 * node + 2, this->Nodes.size()); ++child)
  {
    this->Nodes[node].Add(this->Nodes[child]);
  }
}

//------------------------------------------------------------------------------
void BoxTree::Set(std::size_t i, const FloatBox& box)
{
  this->Boxes[i] = box;
  this->FillLeaf(i / BoxesPerLeaf);
  for (std::size_t node = (this->Leaves + i / BoxesPerLeaf) / 2; node > 0; node /= 2)
  {
    this->Join(node);
  }
}
}
