// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Plan.h
 * @brief What all processes agree on before a change, and the figures of the phases.
 */
#ifndef Plan_h
#define Plan_h

#include "SharedPositions.h"
#include "vtkPBoneDecimate.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

struct vtkPBoneDecimate::Plan
{
  /// Ratio of MaximumError that phase 1 may use. Phase 2 has the rest, because errors of both may add up.
  static constexpr double RatioOfParts = 0.8;

  bonedecimate::Positions
    Shared;                   ///< Once points are smoothed: where those of this process are then.
  double SharedPoints = 0.0;  ///< Of all processes, each once.
  std::vector<char> IsShared; ///< Of each point of this process.
  std::vector<double>
    SmoothedPoints; ///< mm, three numbers of each point of this process; empty: not smoothed.
  bool GuardsVoxels = false; ///< Whether edits may not change a voxel.
  double VoxelSize = 0.0;    ///< mm, of the voxel grid; 0: none is known.
  vtkSmartPointer<vtkPolyData>
    Whole;                 ///< The whole input, on process 0 alone; null: not gathered yet.
  double Total = 0.0;      ///< Triangles of all processes.
  double Target = 0.0;     ///< Triangles to reach, of all processes; 0: none.
  double TargetHere = 0.0; ///< Of this process in phase 1.
  double Error = 0.0;      ///< mm, the largest allowed; 0: none.
  double Proved = 0.0;     ///< mm, of all phases so far; not a number without a proof.
  bool ReducesStrips = false;
  double StripsBefore = 0.0; ///< Triangles of the strips before and after phase 2.
  double StripsAfter = 0.0;
  std::map<std::string, double>
    Counts; ///< Of edits of all processes and phases, by their names in the report.

  /// mm, the largest error of phase 1.
  double ErrorOfParts() const
  {
    return this->ReducesStrips ? RatioOfParts * this->Error : this->Error;
  }
};

#endif
