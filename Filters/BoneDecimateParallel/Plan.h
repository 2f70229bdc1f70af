// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Plan.h
 * @brief What all processes agree on before a change, and the figures of the phases.
 */
#ifndef Plan_h
#define Plan_h

#include "DecimateInternals.h"
#include "SharedPositions.h"
#include "vtkPBoneDecimate.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

struct vtkPBoneDecimate::Plan
{
  /// In largest errors: how far phase 1 stays from the input of other processes. What it leaves
  /// there is within one of that input on both sides, so nothing meets, and a gap between them
  /// keeps half of its width.
  static constexpr double ErrorsOfNeighbors = 3.001;
  /// In largest errors, around the original of the strips: where phase 2 sees the surface. New
  /// triangles are within one of it, and the intersection guard looks four farther.
  static constexpr double ErrorsOfReach = 5.001;
  static constexpr double OneError = 1.001; ///< In largest errors, with the rounding of all this.

  /// Once points are smoothed: where those of this process are then.
  bonedecimate::Positions Shared;
  double SharedPoints = 0.0;  ///< Number of shared points of all processes, each once.
  std::vector<char> IsShared; ///< For each point of this process, whether it is shared.
  /// mm, three numbers of each point of this process; empty: not smoothed.
  std::vector<double> SmoothedPoints;
  bool GuardsVoxels = false; ///< Whether edits may not change a voxel.
  double VoxelSize = 0.0;    ///< mm, of the voxel grid; 0: none is known.
  /// The whole input, on process 0 alone; null: not gathered yet.
  vtkSmartPointer<vtkPolyData> Whole;
  vtkSmartPointer<vtkPolyData> Unpruned; ///< The input of this process with all components.
  double Total = 0.0;                    ///< Triangles of all processes.
  double Target = 0.0;                   ///< Triangles to reach, of all processes; 0: none.
  double TargetHere = 0.0;               ///< Triangles of this process to reach in phase 1.
  double Error = 0.0;                    ///< mm, the largest allowed; 0: none.
  bool ProvesError = false;
  /// With ProvesError: triangles of the input of other processes near this one.
  vtkSmartPointer<vtkPolyData> Neighbors;
  double Proved = std::nan(""); ///< mm, of all phases so far; not a number without a proof.
  int ProofStatus = 0;          ///< One of ProofStatuses, the worst of all phases so far.
  int StopReason = 0;           ///< One of StopReasons: ABORTED, or what ended the phases.
  std::map<std::string, double> Figures; ///< Entries of the report.
  bool ReducesStrips = false;
  double StripsBefore = 0.0; ///< Triangles of the strips before and after phase 2.
  double StripsAfter = 0.0;

  /// Distance that phase 1 keeps from the neighbors, mm.
  double NeighborDistance() const { return ErrorsOfNeighbors * this->Error; }
};

/// Where parts are near each other, after phase 1.
struct vtkPBoneDecimate::Strips
{
  vtkSmartPointer<vtkPolyData> Own;      ///< Strips of this process, with marks (BoundaryStrips.h).
  vtkSmartPointer<vtkPolyData> Rest;     ///< Everything else of this process.
  vtkSmartPointer<vtkPolyData> Original; ///< With ProvesError: what all strips are proved against.
};

#endif
