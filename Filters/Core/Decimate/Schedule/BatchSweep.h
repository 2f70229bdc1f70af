// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchSweep.h
 * @brief Collapses cheap edges of the whole mesh where checking an edit takes much longer than
 * applying it.
 *
 *     list the vertices by bucket                                                (VertexLists)
 *     while a list is not above the limit and collapses remain:
 *         batch:    the next vertices, lowest lists first, of which no two have a vertex of
 *                   their closed rings in common; the others wait for the next batch
 *         search:   at each vertex, in parallel, the cheapest accepted collapse  (CollapseSearch)
 *         commit:   one after the other, in the order of the lists:
 *                   rejected:             set the bucket that the search found
 *                   accepted:             collapse; compute the bucket of the merged vertex
 *                   accepted, but what the search read has changed in this batch:
 *                                         wait for the next batch
 *
 * This is optimistic parallel execution with deterministic reservations (G. Blelloch et al.,
 * Internally deterministic parallel algorithms can be fast, 2012). A search writes nothing that
 * another search of its batch reads: only witnesses of the ends of its edges, which lie in the
 * closed ring. It reads the mesh within Reach of the faces that change, which is compared by boxes,
 * and what the filters compare in StillAccepts. A batch depends on the mesh alone, so the number of
 * threads does not change the result. The fewer searches are wasted, the larger the next batch.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_BatchSweep_h
#define BoneDecimate_Core_Decimate_Schedule_BatchSweep_h

#include "Base/WorkerTeam.h"
#include "StopCriterion.h"
#include "VertexLists.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
class BatchSweep
{
public:
  BatchSweep(Editor& editor, const EdgeEvaluator& evaluate, SweepData& data, int threads);

  /// Runs until the end is reached or nothing is left to collapse.
  /// @param task Its vertices are the whole mesh.
  /// @param end Reports after every collapse and before every batch.
  /// @return False if the monitor requests a stop.
  bool Run(const BlockTask& task, StopCriterion& end, const Monitor& monitor);

private:
  /// A vertex of a list, or one that waits.
  struct ListedVertex
  {
    VertexId Vertex;
    CostBucket Highest = NeverBucket; ///< Highest bucket of the list.
  };
  struct Box
  {
    Vector3 Low = Vector3::Zero(); // mm
    Vector3 High = Vector3::Zero();
  };
  /// A vertex of the batch and the result of its search.
  struct Candidate
  {
    ListedVertex Listed;
    VertexEdges Edges;
    EditWorkspace Workspace;
    CollapseSearch::Result SearchResult;
    Box ChangedBox; ///< Box of the faces that an accepted collapse changes.
  };

  void FillBatch();
  void Take(const ListedVertex& listed);
  bool ReserveRing(VertexId vertex);
  void SearchAt(Candidate& candidate) const;
  void FindBox(Candidate& candidate) const;
  bool IsUpToDate(Candidate& candidate) const;
  bool Commit(Candidate& candidate);
  void Collapse(Candidate& candidate);
  void ChangeBatchSize(std::size_t collapses, std::size_t wasted);

  Editor& MeshEditor;
  const EdgeEvaluator& Evaluate;
  SweepData& Data;
  BlockTask Task;
  VertexLists Lists;
  WorkerTeam Team;
  std::vector<Candidate> Candidates; // the batch, and spare ones
  std::size_t BatchSize = 0;
  std::size_t MaxBatchSize;
  std::vector<Index> List; // the lowest list, of which those before NextInList were taken
  std::size_t NextInList = 0;
  CostBucket MaxBucketOfList = NeverBucket;
  std::vector<ListedVertex> WaitingVertices; // for the next batch
  std::vector<ListedVertex> RetriedVertices; // of the batch that is filled
  // for each vertex, the last batch with the vertex in a closed ring
  std::vector<std::uint32_t> ReservedBy;
  std::uint32_t BatchNumber = 0;
  std::vector<Box> ChangedBoxes; // of the collapses of this batch
};
}

#endif
