// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeMover.h
 * @brief Restores the volume of components by moves within the error bound.
 *
 *     for each vertex:   the mean height of the samples of its faces above these faces
 *     for each component that has lost volume, vertices with the largest height first:
 *         move along the normal by the height, or by half of it, if the faces then keep within
 *         the bound                                                             (SlackMover)
 *     until the component has its volume
 *
 * Moves that only lower the largest distance remove more of convex parts than they add to concave
 * ones.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_VolumeMover_h
#define BoneDecimate_Core_Decimate_Stages_VolumeMover_h

#include "Decimate/Edit/Editor.h"
#include "SlackMover.h"

#include <vector>

namespace bonedecimate
{
class VolumeMover
{
public:
  /// @param samples Distributed over the faces.
  VolumeMover(Editor& editor, Samples& samples, OriginalHints& hints)
    : MeshEditor(editor)
    , OriginalSamples(samples)
    , Mover(editor, samples, hints)
  {
  }

  /// False if the monitor requests a stop.
  bool Run(const Monitor& monitor);

private:
  struct Candidate
  {
    double Height; // mm, absolute
    double Sign;   // direction of the move along the normal of the ring
    Index Vertex;

    bool operator<(const Candidate& other) const
    {
      return this->Height != other.Height ? this->Height > other.Height
                                          : this->Vertex < other.Vertex;
    }
  };
  /// Mean height of the samples of a face above it, weighted by their areas.
  struct Height
  {
    double Sum = 0.0;    // mm times squares of the mesh's unit
    double Weight = 0.0; // squares of the unit
  };
  std::vector<Height> SampledHeights() const;
  void MeasureLost(const std::vector<Height>& heights);
  std::vector<Candidate> FindCandidates(const std::vector<Height>& heights) const;
  Vector3 RingArea(VertexId vertex) const;
  bool MoveAll(const Monitor& monitor);
  void MoveAt(const Candidate& candidate);

  Editor& MeshEditor;
  const Samples& OriginalSamples;
  SlackMover Mover;
  EditWorkspace Workspace;
  std::vector<double> Lost; // mm^3, of each component
};
}

#endif
