// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProofSentence.h
 * @brief What is proved of a result, with all that the proof does not cover, as every adapter
 * prints it.
 */
#ifndef BoneDecimate_Core_Run_Report_ProofSentence_h
#define BoneDecimate_Core_Run_Report_ProofSentence_h

#include "Report.h"
#include "ReportTable.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// What the sentence is made of.
struct ProofFacts
{
  double Upper = 0.0; ///< mm
  bool IsToReference = false;
  std::string Boundaries; ///< a word of the report: "both", "reference_only", "not_compared"
  std::vector<bonedecimate::LeftOut> LeftOut;
  double BoundaryUpper = 0.0; ///< mm, of open boundaries; said if it is larger
};

/// "at most 0.499900 mm in both directions, open boundaries too, but for 2 lines ...": the bound is
/// rounded up.
std::string ProofSentence(const ProofFacts& facts);
std::string ProofSentence(const Report& report);

/// One word, as in the report: "both", "not_compared".
std::string BoundariesWord(const ErrorProof& proof);

/**
 * The entries as they travel with a surface, which others may change afterwards: all of proof.* but
 * the sentence becomes proof.if_unchanged.*, and the sentence says so. A reader takes them back if
 * the triangles of the surface have output.checksum.
 */
std::vector<ReportEntry> BoundToSurface(const std::vector<ReportEntry>& entries);

/// The name of an entry in such a report.
std::string NameBoundToSurface(const std::string& name);

std::string SentenceBoundToSurface(const std::string& sentence);

/// In a report that travels with another surface than the proved one.
inline constexpr const char* ChangedSurfaceSentence =
  "nothing is proved of this surface: it is not the one that was proved, or was changed afterwards";
}

#endif
