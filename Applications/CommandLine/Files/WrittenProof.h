// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WrittenProof.h
 * @brief Whether what was proved holds for the file that was written.
 *
 *     every triangle read back has the same corners, bit for bit:  it is what was proved
 *     else:                                                   the certificate of what was read back
 */
#ifndef BoneDecimate_Applications_WrittenProof_h
#define BoneDecimate_Applications_WrittenProof_h

#include "vtkPolyData.h"

#include <string>

namespace bonedecimate
{
/// Equal positions; points may have other numbers, as in STL files, and triangles another order, as
/// in GLB files.
bool HasSameTriangles(vtkPolyData* a, vtkPolyData* b);

/// Requires that the triangles of a file are those that were proved. @param target The name the
/// file will get.
/// @throws Failure(ExitCode::Undecided)
void RequireSameTriangles(vtkPolyData* proved, vtkPolyData* readBack, const std::string& target);

/**
 * Requires that a run did not end with a bound that is violated or undecided.
 * @param status Status in the report: proof.status.
 * @param message Why the bound is violated or undecided.
 * @throws Failure(ExitCode::Violated) or Failure(ExitCode::Undecided)
 */
void RequireProof(const std::string& status, const std::string& input, const std::string& message);

/// A run whose result is proved.
struct ProvedRun
{
  vtkPolyData* Input;
  vtkPolyData* Output;
  double Tolerance;           ///< mm, everywhere; 0: none
  std::string ToleranceArray; ///< Point array of the input; empty: none.
  bool WithBoundaries;
  int NumberOfThreads;
};

/**
 * @param target The name the file will get, for messages.
 * @returns "same_bits" or "certified".
 * @throws Failure(ExitCode::Violated) or Failure(ExitCode::Undecided)
 */
std::string ProveWritten(const ProvedRun& run, vtkPolyData* readBack, const std::string& target);
}

#endif
