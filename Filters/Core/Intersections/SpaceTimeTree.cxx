// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceTimeTree.h"

#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr float Infinity = std::numeric_limits<float>::infinity();

void Extend(TimedBox& node, const TimedBox& other)
{
  node.Box.Add(other.Box);
  node.Made = std::min(node.Made, other.Made);
  node.Replaced = std::max(node.Replaced, other.Replaced);
}
}

FloatBox::FloatBox()
{
  this->Low.fill(Infinity);
  this->High.fill(-Infinity);
}

FloatBox::FloatBox(const TriangleCorners& corners, double reach)
{
  const Vector3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]).array() - reach;
  const Vector3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]).array() + reach;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<Eigen::Index>(axis);
    this->Low[axis] = std::nextafter(static_cast<float>(low[at]), -Infinity);
    this->High[axis] = std::nextafter(static_cast<float>(high[at]), Infinity);
  }
}

//------------------------------------------------------------------------------
void FloatBox::Add(const FloatBox& other)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
    this->High[axis] = std::max(this->High[axis], other.High[axis]);
  }
}

//------------------------------------------------------------------------------
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
