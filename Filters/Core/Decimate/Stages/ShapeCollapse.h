// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeCollapse.h
 * @brief Collapses an edge onto a position where the triangles around it have large angles.
 *
 * Candidates are the ends and the middle of the edge, and the position that RingShape finds from
 * the best of them. The latter is tried on the original, as far from it as the ends are on average,
 * and as found. The candidate with the largest smallest angle is tried first.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_ShapeCollapse_h
#define BoneDecimate_Core_Decimate_Stages_ShapeCollapse_h

#include "Decimate/Edit/Editor.h"
#include "RingShape.h"

#include <vector>

namespace bonedecimate
{
class ShapeCollapse
{
public:
  /// @param maxCosine Cosine of the requested smallest angle.
  /// @param enough Cosine of an angle that needs no improvement.
  ShapeCollapse(Editor& editor, double maxCosine, double enough)
    : MeshEditor(editor)
    , MaxCosine(maxCosine)
    , Enough(enough)
  {
  }

  /// Collapses the edge if all triangles around it then have the requested angle, or the worst of
  /// them improves.
  /// @return Whether it was collapsed.
  bool Try(HalfEdgeId edge);

private:
  struct Candidate
  {
    double Cosine;
    Edit Proposed;
  };
  double CosineBefore(const EdgeNeighborhood& around) const;
  void AddCandidates(const EdgeNeighborhood& around);
  void AddSearched(const Vector3& start, const Vector3& end);
  void Add(const Vector3& position, VertexId keep, bool stays);

  Editor& MeshEditor;
  double MaxCosine;
  double Enough;
  EditWorkspace Workspace;
  RingShape Ring;
  Edit Proposed;             // what all candidates have in common
  double MaxNewCosine = 1.0; // candidates with a larger cosine are left out
  std::vector<Candidate> Candidates;
};
}

#endif
