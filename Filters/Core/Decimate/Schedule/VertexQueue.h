// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexQueue.h
 * @brief Vertices by cost, lowest first, equal costs by vertex id: a heap that stores the position
 * of each vertex.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_VertexQueue_h
#define BoneDecimate_Core_Decimate_Schedule_VertexQueue_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
class VertexQueue
{
public:
  explicit VertexQueue(Index numberOfVertices)
    : Positions(static_cast<std::size_t>(numberOfVertices), None)
  {
  }

  bool IsEmpty() const { return this->Heap.empty(); }

  /// Adds the vertex or changes its cost, which must not be NaN.
  void Set(Index vertex, double cost);
  void Remove(Index vertex); ///< No effect if the vertex is not in the queue.
  Index PopLowest();         ///< The queue must not be empty.

private:
  struct Entry
  {
    double Cost;
    Index Vertex;
    bool operator<(const Entry& other) const
    {
      return this->Cost != other.Cost ? this->Cost < other.Cost : this->Vertex < other.Vertex;
    }
  };
  void Put(std::size_t position, const Entry& entry);
  void Rise(std::size_t position, const Entry& entry);
  void Sink(std::size_t position, const Entry& entry);

  std::vector<Entry> Heap;
  std::vector<Index> Positions; // of each vertex in Heap
};
}

#endif
