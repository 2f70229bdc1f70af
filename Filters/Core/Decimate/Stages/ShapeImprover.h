// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeImprover.h
 * @brief Enlarges the smallest angles of a mesh, and collapses edges that this makes collapsible.
 *
 *     Mend:      for each face below the requested angle, worst first: collapse an edge, flip an
 *                edge, move the corners; rounds while their number decreases
 *     Collapse:  flips and moves at all faces below a larger angle, then collapses of all edges,
 *                shortest first
 *
 * Rules and filters decide about every edit, so error bound, voxels and gaps are kept.
 * ShapeFilter.h keeps what was reached.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ShapeImprover_h
#define BoneDecimate_Core_Decimate_Stages_ShapeImprover_h

#include "Base/Monitor.h"
#include "Decimate/Edit/Editor.h"
#include "ShapeCollapse.h"

#include <vector>

namespace bonedecimate
{
class ShapeImprover
{
public:
  /// @param maxCosine Cosine of the requested smallest angle.
  ShapeImprover(Editor& editor, double maxCosine)
    : MeshEditor(editor)
    , MaxCosine(maxCosine)
    , Collapser(editor, maxCosine, maxCosine)
  {
  }

  /// False if the monitor requests a stop; likewise below.
  bool Mend(const Monitor& monitor);
  /// @param faces No collapse begins at that many faces or fewer.
  bool Collapse(Index faces, const Monitor& monitor);
  /// Flips and moves at all faces with an angle below 45 degrees.
  static bool Relax(Editor& editor, const Monitor& monitor);

private:
  std::vector<Index> FindBadFaces() const;
  bool IsBad(FaceId face) const;
  template <typename Improve>
  bool ForEachBadFace(const Monitor& monitor, const Improve& improve);
  bool FlipAndMove(const Monitor& monitor);
  void CollapseAt(FaceId face);

  Editor& MeshEditor;
  double MaxCosine;
  ShapeCollapse Collapser;
};
}

#endif
