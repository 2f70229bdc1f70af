// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Evaluation.h
 * @brief Evaluates the result of a run for the report: statistics of both surfaces, and the
 * distances between them or to the reference, if there is one.
 *
 *     Describe(input), Describe(result)      counts, area, volume
 *     PartComparer                           the same of each component or label, if
 *                                            the surface was smoothed; thickness,
 *                                            too, if distances are measured
 *     Certify(input, result)                 open boundaries, curve to curve, unless a certificate
 *                                            follows
 *     MeasureDistance                        both directions, by samples
 *     PointDistances                         of each point of the input
 */
#ifndef BoneDecimate_Core_Run_Output_Evaluation_h
#define BoneDecimate_Core_Run_Output_Evaluation_h

#include "Base/RunProgress.h"
#include "Decimate/Edit/Editor.h"
#include "Mesh/Cleaning.h"
#include "Mesh/SizingField.h"
#include "Options/Options.h"
#include "Result.h"
#include "Run/Input/RunInputs.h"

#include <memory>

namespace bonedecimate
{
/// A run after its last edit.
struct EvaluatedRun
{
  const Surface& Input;
  const CleanSurface& Cleaned;
  const Editor& MeshEditor;
  const Surface& LocalResult; ///< mm, relative to Cleaned.Origin
  const Surface* Reference;   ///< mm, as stored; distances are measured to it; null: to the input.
  bool CertificateFollows;    ///< whether a certificate of surfaces and boundaries follows
  const RunInputs& Inputs;
  std::shared_ptr<const SizingField> Sizes; ///< Local lengths of edges; null: none.
  double MinPart; ///< mm^3, PartComparison::MinVolume; 0: parts are not compared.
};

/// Progress at which the evaluation begins and ends, 0 to 1.
double MeasuredFrom(const Options& options, bool isProvedNext);
double MeasuredTo(bool isProvedNext);

/// Fills in the report, and the distances of input points if requested. After an abort, computes
/// statistics only.
void Evaluate(
  const EvaluatedRun& run, const Options& options, RunProgress& progress, Result& output);
}

#endif
