// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Plan.h
 * @brief What all processes agree on before anything is changed, and what became of it.
 */
#ifndef Plan_h
#define Plan_h

#include "SharedPlaces.h"
#include "vtkPBoneDecimate.h"

struct vtkPBoneDecimate::Plan
{
  /// The share of MaximumError that phase 1 may use; phase 2 has what is left, for errors of both may add up.
  static constexpr double ShareOfParts = 0.8;

  /// Point array of the tolerances of phase 1.
  static constexpr const char* ToleranceName = "bonedecimate.seam";

  bonedecimate::Places Shared;
  double Total = 0.0;      ///< Triangles of all processes.
  double Wanted = 0.0;     ///< Triangles to reach, of all processes; 0: none.
  double WantedHere = 0.0; ///< Of this process in phase 1.
  double Error = 0.0;      ///< mm, the largest allowed; 0: none.
  double Proved = 0.0;     ///< mm, of all phases so far; not a number without a proof.
  bool ReducesSeams = false;
  double SeamsBefore = 0.0; ///< Triangles of the strips before and after phase 2.
  double SeamsAfter = 0.0;
};

#endif
