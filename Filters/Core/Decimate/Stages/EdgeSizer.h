// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeSizer.h
 * @brief Brings the edges of a mesh to the requested length, or each to its local one: the loop of
 * Botsch and Kobbelt, A remeshing approach to multiresolution modeling, 2004.
 *
 *     a round:      collapse short edges, shortest first
 *                   split long edges, longest first
 *                   flip and move
 *     at the end:   split edges that have become too long
 *
 * Rules and filters decide about every edit: edges stay short where the error bound does not allow
 * a collapse. ShapeFilter.h lets no collapse make a long edge.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_EdgeSizer_h
#define BoneDecimate_Core_Decimate_Stages_EdgeSizer_h

#include "Base/Monitor.h"
#include "Decimate/Edit/Editor.h"
#include "Mesh/LocalLengths.h"
#include "ShapeCollapse.h"

#include <cstdint>

namespace bonedecimate
{
class EdgeSizer
{
public:
  /// @param limits With a length and a smallest angle.
  EdgeSizer(Editor& editor, const ShapeLimits& limits, int threads);

  /// @param faces No collapse begins at that many faces or fewer, and no split makes more; 0: any
  /// number.
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
