// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexQueue.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Four children fit in one cache line and halve the depth of a binary heap.
constexpr std::size_t Children = 4;
}

void VertexQueue::Put(std::size_t position, const Entry& entry)
{
  this->Heap[position] = entry;
  this->Positions[entry.Vertex] = static_cast<Index>(position);
}

void VertexQueue::Rise(std::size_t position, const Entry& entry)
{
  while (position > 0 && entry < this->Heap[(position - 1) / Children])
  {
    this->Put(position, this->Heap[(position - 1) / Children]);
    position = (position - 1) / Children;
  }
  this->Put(position, entry);
}

void VertexQueue::Sink(std::size_t position, const Entry& entry)
{
  for (;;)
  {
    const std::size_t first = Children * position + 1;
    if (first >= this->Heap.size())
    {
      break;
    }
    const auto begin = this->Heap.begin();
    const std::size_t last = std::min(first + Children, this->Heap.size());
    const auto least = std::min_element(
      begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
    if (!(*least < entry))
    {
      break;
    }
    const std::size_t child = static_cast<std::size_t>(least - begin);
    this->Put(position, *least);
    position = child;
  }
  this->Put(position, entry);
}

void VertexQueue::Set(Index vertex, double cost)
{
  const Entry entry = { cost, vertex };
  if (this->Positions[vertex] == None)
  {
    this->Heap.push_back(entry);
    this->Rise(this->Heap.size() - 1, entry);
    return;
  }
  const std::size_t position = static_cast<std::size_t>(this->Positions[vertex]);
  if (entry < this->Heap[position])
  {
    this->Rise(position, entry);
  }
  else
  {
    this->Sink(position, entry);
  }
}

void VertexQueue::Remove(Index vertex)
{
  if (this->Positions[vertex] == None)
  {
    return;
  }
  const std::size_t position = static_cast<std::size_t>(this->Positions[vertex]);
  this->Positions[vertex] = None;
  const Entry last = this->Heap.back();
  this->Heap.pop_back();
  if (last.Vertex != vertex)
  {
    this->Rise(position, last);
    this->Sink(static_cast<std::size_t>(this->Positions[last.Vertex]), last);
  }
}

Index VertexQueue::PopLowest()
{
  const Index vertex = this->Heap.front().Vertex;
  this->Remove(vertex);
  return vertex;
}
}
