// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeSizer.h
 * @brief Brings the edges of a mesh to a length, or each to its own: the loop of Botsch and
 * Kobbelt, "A Remeshing Approach to Multiresolution Modeling" (2004).
 *
 *     a round:      collapse short edges, the shortest first; split long ones, the longest first;
 *                   flip and move
 *     at the end:   split what has become too long
 *
 * Rules and filters decide about every edit: where the error bound does not allow a collapse, edges
 * stay short. ShapeFilter.h lets no collapse make a long edge.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_EdgeSizer_h
#define BoneDecimate_Core_Decimate_Stages_EdgeSizer_h

#include "Base/Monitor.h"
#include "Decimate/Edit/Editor.h"
#include "Mesh/LocalLengths.h"
#include "ShapeCollapse.h"

namespace bonedecimate
{
class EdgeSizer
{
public:
  /// @param limits With a length and a least angle.
  EdgeSizer(Editor& editor, const ShapeLimits& limits, int threads);

  /// @param faces No collapse begins at that many faces or fewer, and no split makes more; 0: any
  ///   number.
  /// @return False if the monitor requests a stop.
  bool Run(Index faces, const Monitor& monitor);

private:
  bool Collapse(Index faces, const Monitor& monitor);
  bool Split(Index faces, const Monitor& monitor);
  bool SplitOnce(Index faces, std::int64_t& splits, const Monitor& monitor);
  bool SplitInTheMiddle(HalfEdgeId edge);
  template <typename Predicate>
  bool IsLocally(HalfEdgeId edge, const Predicate& predicate);

  Editor& MeshEditor;
  ShapeLimits Limits;
  int Threads;
  LocalLengths Lengths;
  ShapeCollapse Collapser;
  EditWorkspace Workspace;
};
}

#endif
