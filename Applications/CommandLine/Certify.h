// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Certify.h
 * @brief bonedecimate certify: reads two surfaces, proves how far they are from each other, tells.
 */
#ifndef BoneDecimate_Applications_Certify_h
#define BoneDecimate_Applications_Certify_h

#include "ExitCode.h"
#include "LengthUnit.h"

#include <optional>
#include <string>

namespace bonedecimate
{
struct CertifyArguments
{
  std::string Reference;
  std::string Result;
  std::optional<double> Tolerance; ///< mm
  std::string ToleranceArray;      ///< A point array of the reference, mm; empty: none.
  std::string Json;                ///< A file; empty: none.
  LengthUnit Unit;                 ///< Of the coordinates in both files.
  double Gap = 1e-6;
  double Precision = 5e-3; ///< Of means.
  int Threads = 0;
  bool FirstProof = false; ///< Stop at the tolerance.
  bool WithoutMeans = false;
  bool WithoutBorders = false;
  bool Quiet = false;
};

/// @returns Nothing if it asked for a text (--help), which is then printed.
/// @throws Failure(ExitCode::Usage)
std::optional<CertifyArguments> ParseCertifyArguments(int argc, char* argv[]);

/**
 * @returns Done if the tolerance is proved to be kept or none was given, Violated, or Undecided.
 * @throws Failure, std::bad_alloc
 */
ExitCode RunCertify(const CertifyArguments& arguments);
}

#endif
