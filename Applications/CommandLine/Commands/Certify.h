// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Certify.h
 * @brief bonedecimate certify: proved bounds of the distance of two surfaces, and the voxels of a
 * label map that one changes.
 */
#ifndef BoneDecimate_Applications_Certify_h
#define BoneDecimate_Applications_Certify_h

#include "Arguments/CliForward.h"
#include "Arguments/LabelMapArguments.h"
#include "Arguments/LengthUnit.h"
#include "ExitCode.h"
#include "Settings/SettingsRecord.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct CertifyArguments
{
  std::vector<std::string> Files;  ///< Reference and results; a result alone with a label map.
  std::optional<double> Tolerance; ///< mm
  std::string ToleranceArray;      ///< A point array of the reference, mm; empty: none.
  std::optional<double> Iso;       ///< HU, of a CT volume as the reference.
  LabelMapFile Map;                ///< Without a map the voxels are not compared.
  std::string Json;                ///< A file; empty: none.
  std::string Page;                ///< A file; empty: none.
  LengthUnit Unit;                 ///< Unit of the coordinates in both files.
  double Gap = 1e-6;
  double Precision = 5e-3; ///< Relative precision of the mean distances.
  int Threads = 0;
  bool FirstProof = false; ///< Stop at the tolerance.
  bool WithoutMeans = false;
  bool WithoutBoundaries = false;
  SettingsRecord Settings;
  bool Quiet = false;
  bool IsOneOfSeveral = false; ///< One of several results: no progress.

  const std::string& Result() const { return this->Files.back(); }
  bool HasReference() const { return this->Files.size() > 1; }
  bool HasTolerance() const { return this->Tolerance || !this->ToleranceArray.empty(); }
};

/**
 * Adds the command. Its code is Done if the tolerance is proved to be kept or none was given, and
 * if no voxel has another label; else Violated or Undecided.
 * It throws Failure and std::bad_alloc.
 */
void AddCertifyCommand(CLI::App& program, ExitCode& code);
}

#endif
