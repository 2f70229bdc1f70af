// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertifyFolders.h
 * @brief bonedecimate certify REFERENCES/ RESULTS/: pairs of the same name.
 */
#ifndef BoneDecimate_Applications_CertifyFolders_h
#define BoneDecimate_Applications_CertifyFolders_h

#include "ExitCode.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct FilePair
{
  std::string Name; ///< Below the folders, without an extension.
  std::string Reference;
  std::string Result;
  std::string Problem; ///< Why they are no pair; empty: they are.
};

struct CertifiedPair
{
  std::string Name;
  ExitCode Code;
  std::string Text; ///< Bounds and status, or why it was rejected.
  std::string Json; ///< Its certificate; empty if it was rejected.
  std::vector<std::string> Warnings;
};

/// Whether these are two folders of surfaces, and the first is no volume.
bool AreFolders(const std::vector<std::string>& files);

/// The surfaces of both folders and those below them, by the names that a batch gives to its
/// results, whatever their formats. A name that is not in both of them once has a problem.
/// @param iso The value of the surface of volumes, which are references, too; none: they are not.
/// @throws Failure(ExitCode::InputRejected) if there is no result, or no reference.
std::vector<FilePair> FindPairs(
  const std::string& references, const std::string& results, const std::optional<double>& iso);

/// The first file with each of the others, which have their own names.
std::vector<FilePair> PairsWithFirst(const std::vector<std::string>& files);

/// A list of objects: name, exit code, and the certificate or the problem.
std::string JsonOfPairs(const std::vector<CertifiedPair>& pairs);

/// "12 pairs: 9 proved, 1 violated, 2 not compared"; without a tolerance "12 pairs: 12 compared".
std::string CountsOfPairs(const std::vector<CertifiedPair>& pairs, bool hasTolerance);

/// Interrupted if one is, else Violated, else Undecided, else the code of a pair that was rejected.
ExitCode WorstOfPairs(const std::vector<CertifiedPair>& pairs);
}

#endif
