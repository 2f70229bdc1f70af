// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchSweep.h
 * @brief Collapses cheap edges of the whole mesh, where checking an edit takes much longer than
 * applying it.
 *
 *     list the vertices by bucket                                                     (VertexLists)
 *     while a list is not above the limit, and collapses are left:
 *         batch:    the next vertices, lowest lists first, of which no two have a vertex of their
 *                   closed rings in common;
 *                   the others wait for the next batch
 *         search:   at each vertex the cheapest collapse that is accepted, all at the same time
 *           (CollapseSearch)
 *         commit:   one after the other, in the order of the lists:
 *                   rejected:                   set the bucket that the search found
 *                   accepted, and what the search read has changed in this batch:  wait for the
 *                     next batch
 *                   accepted otherwise:         collapse; compute the bucket of the merged vertex
 *
 * This is optimistic parallel execution with deterministic reservations (G. Blelloch et al.,
 * Internally deterministic parallel algorithms can be fast, 2012). A search writes nothing that
 * another one of its batch reads: only witnesses of the ends of its edges, which lie in the closed
 * ring. What it reads is the mesh within Reach of the faces that change, compared by boxes, and
 * what the filters compare in StillAccepts. A batch depends on the mesh alone, so the number of
 * threads does not change the result. The fewer searches are in vain, the larger the next batch.
 */
#ifndef BoneDecimate_Core_Decimate_Schedule_BatchSweep_h
#define BoneDecimate_Core_Decimate_Schedule_BatchSweep_h

#include "Base/WorkerTeam.h"
#include "StopCriterion.h"
#include "VertexLists.h"

#include <vector>

namespace bonedecimate
{
class BatchSweep
{
public:
  BatchSweep(Editor& editor, const EdgeEvaluator& evaluate, SweepData& data, int threads);

  /// Until the end is reached, or nothing is left to collapse.
  /// @param task Its vertices are the whole mesh.
  /// @param end Reported after every collapse and before every batch.
  /// @return False if the monitor requests a stop.
  bool Run(const BlockTask& task, StopCriterion& end, const Monitor& monitor);

private:
  /// A vertex of a list.
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
  /// A vertex of the batch, and what was found there.
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
  std::vector<Candidate> Candidates; // memory of the batch
  std::size_t BatchSize = 0;         // of the batch
  std::size_t MaxBatchSize;
  std::vector<Index> List; // the lowest list, of which those before NextInList were taken
  std::size_t NextInList = 0;
  CostBucket MaxBucketOfList = NeverBucket;
  std::vector<ListedVertex> WaitingVertices,
    RetriedVertices; // for the next batch; of the one being filled
  // of each vertex, the last batch that has it in a closed ring
  std::vector<std::uint32_t> ReservedBy;
  std::uint32_t BatchNumber = 0;
  std::vector<Box> ChangedBoxes; // by the collapses of this batch
};
}

#endif
