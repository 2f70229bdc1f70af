// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Judgement.h
 * @brief What a run's result is worth: statistics of both surfaces and the distances between them, for the report;
 *        distances to the reference, if the run has one.
 *
 *     Describe(input), Describe(result)      counts, area, volume
 *     Certify(input, result)                 open borders, curve to curve, unless the whole is certified afterwards
 *     MeasureDistance                        both directions, by samples
 *     PointDistances                         of each point of the input
 */
#ifndef BoneDecimate_Core_Judgement_h
#define BoneDecimate_Core_Judgement_h

#include "Collapse/Editor.h"
#include "Decimate.h"
#include "Mesh/Cleaning.h"
#include "RunProgress.h"

namespace bonedecimate
{
/// A run that has collapsed what it could.
struct JudgedRun
{
  const Surface& Input;
  const CleanSurface& Cleaned;
  const Editor& Work;
  const Surface& LocalResult; ///< mm, relative to Cleaned.Origin
  const Surface* Reference;   ///< mm, as stored: what distances are measured to; null: the input.
  bool IsProvedNext;          ///< whether the certificate follows, borders and all
};

/// Where on the way from 0 to 1 the judgement begins and ends.
double MeasuredFrom(const Options& options, bool isProvedNext);
double MeasuredTo(bool isProvedNext);

/// Fills in the report, and the distances of the input's points if they are asked for. Who aborted gets statistics alone.
void Judge(const JudgedRun& run, const Options& options, RunProgress& progress, Result& answer);
}

#endif
