// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProofSection.h
 * @brief What a page says about the proved bounds of a run, as HTML. Bounds are rounded outwards,
 * so that what is shown is proved, too.
 */
#ifndef BoneDecimate_Applications_ProofSection_h
#define BoneDecimate_Applications_ProofSection_h

#include "ReportFields.h"

#include <string>

namespace bonedecimate
{
/// Why a run has no proof, as text.
std::string ReasonWithoutProof(const ReportFields& report);

/// How far the surfaces are apart: one number and whether it is proved or measured, and why it is
/// not proved.
std::string ErrorHeadline(const ReportFields& report);

/// The bounds of each direction, of open boundaries, and what is not proved.
std::string ProofSection(const ReportFields& report);

/// ", but no farther than the proved 0.4999 mm" to end a sentence about measured distances; empty
/// without a proof.
std::string ProofClause(const ReportFields& report);

/// What is proved of the levels of a run.
/// @param report Report of the run; an empty one if the levels come from a log.
std::string LevelsProof(const ReportFields& report);
}

#endif
