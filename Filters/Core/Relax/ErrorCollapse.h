// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorCollapse.h
 * @brief The last collapses, in the order of what they truly do to the sampled two-sided error.
 *
 *     of all edges inside, the cheapest by their quadrics, several for each collapse wanted: into a heap by
 *         cost = error of the fan after (FanFit) - error of the faces before                            
 *     while there are too many faces:
 *         take the cheapest edge; if something around it changed since it was judged, judge it afresh, put it back
 *         else collapse it, hand its samples to the faces of the fan, judge the edges of the merged vertex
 *
 * Edges at open borders and locked parts are left to the other order.
 */
#ifndef BoneDecimate_Core_Relax_ErrorCollapse_h
#define BoneDecimate_Core_Relax_ErrorCollapse_h

#include "EdgeOrder.h"
#include "FanFit.h"

#include <queue>
#include <vector>

namespace bonedecimate
{
class ErrorCollapse
{
public:
  /// @param editor Must keep quadrics, and they must be right.
  /// @param edgesOfCollapse How many edges are judged at first for each collapse that is wanted.
  ErrorCollapse(
    Editor& editor, Samples& samples, BackHints& hints, int edgesOfCollapse, int threads);

  /// Down to that many faces, or until no edge may be collapsed. False if the monitor said stop.
  bool Run(Index faces, const Monitor& monitor);

private:
  struct Entry
  {
    double Cost; //
    Index Edge;
    Index Start;
    Index End;
    std::uint32_t Stamp;
    Vector3 Place;                           // mm from the local origin
    bool operator<(const Entry& other) const // the cheapest on top, then the least edge
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost : this->Edge > other.Edge;
    }
  };
  /// What judging needs, one for each worker.
  struct Judge
  {
    FanFit Costs;
    Workspace Space;
  };
  bool MeasureErrors(const Monitor& monitor);
  bool FillHeap(std::size_t count, const Monitor& monitor);
  bool EmptyHeap(const Monitor& monitor);
  bool Rate(const RatedEdge& edge, Judge& judge, Entry& entry) const;
  void Push(const RatedEdge& edge);
  bool Collapse(const Entry& entry);
  void AfterCollapse(Index vertex, const FanFit::Answer& answer);
  double FaceError(Index face) const;
  double VertexError(Index vertex) const;
  std::uint32_t StampOf(Index edge) const;
  std::size_t CollapsesWanted() const;

  Editor& Work;
  Samples& Fit;
  BackHints& Back;
  ThreeHalves Penalty;
  Judge Own;
  std::size_t EdgesOfCollapse;
  int Threads;
  Index Wanted = 0;                  // faces
  float Dearest = 0.0F;              // of the edges worth judging
  std::vector<float> FaceErrors;     //
  std::vector<float> VertexErrors;   //
  std::vector<std::uint32_t> Stamps; // of each vertex, raised when its ring changes
  std::priority_queue<Entry> Heap;
  std::vector<RatedEdge> Candidates;
};
}

#endif
