// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexQueue.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Four children share a cache line and make the heap half as deep as two.
constexpr std::size_t Children = 4;
}

void VertexQueue::Put(std::size_t place, const Entry& entry)
{
  this->Heap[place] = entry;
  this->Places[entry.Vertex] = static_cast<Index>(place);
}

void VertexQueue::Rise(std::size_t place, const Entry& entry)
{
  while (place > 0 && entry < this->Heap[(place - 1) / Children])
  {
    this->Put(place, this->Heap[(place - 1) / Children]);
    place = (place - 1) / Children;
  }
  this->Put(place, entry);
}

void VertexQueue::Sink(std::size_t place, const Entry& entry)
{
  for (;;)
  {
    const std::size_t first = Children * place + 1;
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
    this->Put(place, *least);
    place = child;
  }
  this->Put(place, entry);
}

void VertexQueue::Set(Index vertex, double cost)
{
  const Entry entry = { cost, vertex };
  if (this->Places[vertex] == None)
  {
    this->Heap.push_back(entry);
    this->Rise(this->Heap.size() - 1, entry);
    return;
  }
  const std::size_t place = static_cast<std::size_t>(this->Places[vertex]);
  if (entry < this->Heap[place])
  {
    this->Rise(place, entry);
  }
  else
  {
    this->Sink(place, entry);
  }
}

void VertexQueue::Remove(Index vertex)
{
  if (this->Places[vertex] == None)
  {
    return;
  }
  const std::size_t place = static_cast<std::size_t>(this->Places[vertex]);
  this->Places[vertex] = None;
  const Entry last = this->Heap.back();
  this->Heap.pop_back();
  if (last.Vertex != vertex)
  {
    this->Rise(place, last);
    this->Sink(static_cast<std::size_t>(this->Places[last.Vertex]), last);
  }
}

Index VertexQueue::PopLowest()
{
  const Index vertex = this->Heap.front().Vertex;
  this->Remove(vertex);
  return vertex;
}
}
