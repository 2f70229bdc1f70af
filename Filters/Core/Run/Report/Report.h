// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Report.h
 * @brief Report of a run: input, edits, stop reason, result and its distances.
 */
#ifndef BoneDecimate_Core_Run_Report_Report_h
#define BoneDecimate_Core_Run_Report_Report_h

#include "Figures/DistanceFigures.h"
#include "Figures/EditFigures.h"
#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"
#include "Figures/LeftOut.h"
#include "Figures/PartFigures.h"
#include "Figures/ShapeFigures.h"
#include "Figures/SmoothingFigures.h"
#include "Figures/SurfaceFigures.h"
#include "Figures/TunnelFigures.h"
#include "Labels/LabelMap/VoxelCheck.h"
#include "Options/Options.h"
#include "Repair/Diagnostics/Diagnostics.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
struct StageSeconds
{
  double Prepare = 0.0;  ///< Cleaning and building the half-edge mesh.
  double Collapse = 0.0; ///< Costs, the loop, extraction; the original's bounding tree, if needed.
  double Decimate = 0.0; ///< Prepare + Collapse: the time until the surface is complete.
  double Measure = 0.0;  ///< Statistics of both surfaces and distances.
  double Prove = 0.0;    ///< The certificate of the result.
  double Total = 0.0;

  /// All but the total: parts may run at the same time.
  void AddStages(const StageSeconds& ofPart);
};

struct Report
{
  InputStatus Status = InputStatus::Good;
  StopReason Stop = StopReason::NotRun;
  SurfaceStatistics Input; ///< After cleaning.
  SurfaceStatistics Output;
  CleaningStatistics Cleaning;
  std::vector<Diagnostic> Diagnostics; ///< Irregularities of the whole input, if requested.
  PruneFigures Pruned;
  TunnelFigures Tunnels; ///< If any were closed, everything else refers to the closed surface.
  bool DistancesMeasured = false;
  DistanceStatistics OutputToInput;
  DistanceStatistics InputToOutput;
  /// If distances were measured and both surfaces have boundaries.
  bool BoundariesMeasured = false;
  ProvedDistance BoundaryOutputToInput;
  ProvedDistance BoundaryInputToOutput;
  bool FragmentGapMeasured = false; ///< If distances were measured and there are several fragments.
  FragmentGap Gap;
  std::vector<LabelArea> Labels; ///< Empty without labels.
  ErrorProof Proof;              ///< Relative to the reference, if there is one.
  ReferenceFigures Reference;
  WeldFigures Weld;
  std::string Conflict; ///< A sentence, with InputStatus::OptionConflict.
  /// What of the input, or of the reference, the proof does not cover.
  std::vector<bonedecimate::LeftOut> LeftOut;
  VoxelFigures Voxel;
  VoxelReport Voxels; ///< For an input with a voxel grid.
  SizeFigures Size;
  SmoothingFigures Smoothing;
  PartComparison Parts; ///< Input and result of a surface that was smoothed as a whole.
  /// mm, maxError of the thesis: the largest distance of a new vertex to the input, after each
  /// collapse in mode Thesis and at the end in other modes. NaN if not measured (other modes
  /// without MeasureDistances and origins); tables omit it then.
  double RunningError = 0.0;
  double NormalTolerance = 0.0; ///< The tolerance w of the thesis; only in mode Thesis.
  EditFigures Edits;
  RegionFigures Regions;
  AngleFigures Angles;
  EdgeFigures Edges;
  StageSeconds Seconds;
  std::uint64_t InputChecksum = 0;  ///< Mesh/Checksum.h.
  std::uint64_t OutputChecksum = 0; ///< Independent of the order of triangles; Mesh/Checksum.h.
  Options Requested;
  bool HasTolerances = false; ///< Whether there were tolerances of points.
};

/// One word, as in the JSON report: "target_reached".
const char* StopReasonWord(StopReason reason);
/// A sentence that explains the reason.
const char* StopReasonSentence(StopReason reason);
const char* DraftStatusWord(DraftStatus status);
const char* RegionStatusWord(RegionStatus status);
/// Why the input was rejected, with counts and first ids; empty if it is good.
std::string InputMessage(const Report& report);
/// Warnings about a good input, one sentence each, with counts and first ids.
std::vector<std::string> InputWarnings(const Report& report);
/// A warning that the error is violated or undecided; empty if it is proved or there is no proof.
std::string ProofMessage(const Report& report);
/// Version of this software, "major.minor.patch".
const char* Version();
}

#endif
