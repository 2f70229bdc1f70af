// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LineCollapse.h
 * @brief Collapses the lines along which sheets meet along themselves.
 *
 *     a pass:   every site of a line that may go, by the deviation of the line without it
 *               beyond the bound, or next to one that went in this pass: not now
 *               three lines would make a triangle: never
 *               onto the nearer of its two neighbours, else onto the other: the same edge in every sheet (Editor::ApplyTogether)
 *     passes until enough are gone; each may take a quarter of what is wanted at most, so that deviations are known afresh
 *
 * What is left of a line are points of the input. One worker does it, in the order of the lines: there are few of them.
 */
#ifndef BoneDecimate_Core_Collapse_LineCollapse_h
#define BoneDecimate_Core_Collapse_LineCollapse_h

#include "Editor.h"
#include "Monitor.h"

namespace bonedecimate
{
class LineCollapse
{
public:
  /// @param editor Must have lines.
  explicit LineCollapse(Editor& editor)
    : Work(editor)
    , Lines(*editor.Lines())
  {
  }

  struct Wish
  {
    Index Edges = 0;    ///< Of lines, to come down to.
    Index Faces = 0;    ///< Of the mesh, not to fall below.
    double Bound = 0.0; ///< mm, of the deviation of a line from what it was.
  };
  struct Answer
  {
    Index Gone = 0;       ///< Sites.
    bool IsBound = false; ///< A larger bound would let more go.
    bool IsAborted = false;
  };

  Answer Run(const Wish& wish, const Monitor& monitor);

private:
  struct Candidate
  {
    double Deviation; // mm
    double Length;    // mm, of the new edge
    Index Place;
  };

  void ListCandidates(double bound, Answer& answer);
  Index Pass(const Wish& wish, Index most, const Monitor& monitor, Answer& answer);
  bool MakesTriangle(Index place);
  bool TryPlace(Index place, Index faces);
  bool CollapseOnto(Index gone, Index stays, Index faces);

  Editor& Work;
  SeamLines& Lines;
  std::vector<Candidate> Candidates;
  std::vector<char> WasTouched; // of each place, in this pass
  std::vector<Edit> Edits;
  std::vector<Index> BesideBefore; // sites
  std::vector<Index> BesideAfter;
};
}

#endif
