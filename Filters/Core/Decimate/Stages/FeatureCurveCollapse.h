// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FeatureCurveCollapse.h
 * @brief Collapses the curves along which manifold patches meet, along the curve only.
 *
 *     a pass, over the removable vertices, by the deviation of the curve without the vertex:
 *         above the maximum, or next to a vertex removed in this pass:    not in this pass
 *         three curves would become a triangle:                           never
 *         otherwise, onto the nearer neighbor, else onto the other one:   collapse the same edge in
 *                                                                         every patch (Editor::Try)
 *     passes until enough vertices are removed; each removes a quarter of them at most, so that
 *     deviations are computed again
 *
 * The remaining vertices of a curve are points of the input. Curves have few vertices, so this runs
 * on one thread.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FeatureCurveCollapse_h
#define BoneDecimate_Core_Decimate_Stages_FeatureCurveCollapse_h

#include "Base/Monitor.h"
#include "Decimate/Edit/Editor.h"

namespace bonedecimate
{
class FeatureCurveCollapse
{
public:
  /// @param editor Must have feature curves.
  explicit FeatureCurveCollapse(Editor& editor)
    : MeshEditor(editor)
    , FeatureCurves(*editor.FeatureCurves())
  {
  }

  struct Targets
  {
    Index Edges = 0;           ///< Number of curve edges to reach.
    Index Faces = 0;           ///< Minimum number of faces of the mesh.
    double MaxDeviation = 0.0; ///< mm, from the initial curve.
  };
  struct Result
  {
    Index Removed = 0;      ///< Number of original vertices removed.
    bool IsLimited = false; ///< A larger deviation would allow more.
    bool IsAborted = false;
  };

  Result Run(const Targets& targets, const Monitor& monitor);

private:
  struct Candidate
  {
    double Deviation; // mm
    double Length;    // mm, of the new edge
    Index CurveIndex;
  };

  void ListCandidates(double maxDeviation, Result& result);
  Index Pass(const Targets& targets, Index most, const Monitor& monitor, Result& result);
  bool MakesTriangle(Index index);
  bool TryRemove(Index index, Index faces);
  bool CollapseOnto(VertexId gone, VertexId stays, Index faces);

  Editor& MeshEditor;
  PatchBoundaries& FeatureCurves;
  std::vector<Candidate> Candidates;
  std::vector<char> WasTouched; // for each index of a curve vertex, in this pass
  std::vector<Edit> Edits;
  std::vector<Index> BesideBefore; // original vertices
  std::vector<Index> BesideAfter;
};
}

#endif
