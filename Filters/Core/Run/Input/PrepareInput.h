// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrepareInput.h
 * @brief From the input of a run to a half-edge mesh with the tolerances of its vertices.
 *
 *     Clean(input)                     reject, merge, drop, count
 *     Diagnose(input)                  on request
 *     Prune(cleaned)                   components that are too small, on request
 *     CheckLabelMap(source)            whether the voxel grid and its labels suit the input
 *     CheckErrors(tolerances)          whether tolerances and largest
 *                                      error suit mode, precision and size
 *     CompareWithReference(input)      what is left of the largest error,
 *                                      if the input is itself a result
 *     SortAlongCurve(cleaned)          neighbors in space become neighbors in memory
 *     HalfEdgeMesh(cleaned)            split where it is not manifold, and between labels
 *     TolerancesOf(cleaned)            of each vertex
 *     MakeSizingField(mesh)            local lengths of edges
 */
#ifndef BoneDecimate_Core_Run_Input_PrepareInput_h
#define BoneDecimate_Core_Run_Input_PrepareInput_h

#include "Base/RunProgress.h"
#include "Mesh/Cleaning.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/PointRounding.h"
#include "Mesh/SizingField.h"
#include "Options/Options.h"
#include "Proof/Reference/ReferenceMesh.h"
#include "ReferenceInput.h"
#include "Run/Report/Report.h"
#include "RunInputs.h"
#include "SmoothingPlan.h"

#include <memory>
#include <optional>

namespace bonedecimate
{
/// What a run is about.
struct RunTask
{
  const Surface& Input;
  const RunInputs& Inputs;
  /// With the largest error that is used: that of the preset, and none above the diagonal.
  Options Effective;
  bool GuardsVoxels = false;   ///< Whether edits may not let a voxel center change sides.
  PointRounding Rounding = {}; ///< Rounding of the result.
  SmoothingPlan Smoothing = {};
};

/// Rounding of the result for an input of that precision.
PointRounding RoundingOf(const Options& options, bool inputIsSingle);

/// mm, tolerances of the points of the input.
struct PointTolerances
{
  /// As in RunInputs::Tolerances, none above the diagonal.
  std::optional<std::vector<double>> OfPoints;
  std::optional<ReferenceInput> Reference; ///< Caps them; read already.

  /// What holds between input and result; null: none.
  const std::vector<double>* Capped() const
  {
    return this->Reference ? &this->Reference->Left : this->Requested();
  }
  /// Without what the reference leaves; null: none.
  const std::vector<double>* Requested() const
  {
    return this->OfPoints ? &*this->OfPoints : nullptr;
  }
  const KeptSurface* ReferenceSurface() const
  {
    return this->Reference ? &this->Reference->Reference : nullptr;
  }
};

struct PreparedInput
{
  CleanSurface Cleaned;
  PointTolerances Tolerances;
  /// mm, of each vertex of the mesh; negative: none. Empty: no vertex has one.
  std::vector<double> VertexTolerances;
  std::optional<HalfEdgeMesh> Mesh; ///< None if the input was rejected.
  /// Local lengths of edges; null: EdgeLength everywhere, or none.
  std::shared_ptr<const SizingField> Sizes;
  /// The original of a part that is itself a result; null: the input.
  std::unique_ptr<ReferenceMesh> Original;

  /// Whether every vertex has a tolerance.
  bool IsLimitedEverywhere() const;
};

/// Whether the input is a part of a result, and the error bound refers to what that was made from.
inline bool ContinuesEarlierRun(const RunInputs& inputs)
{
  return inputs.Part != nullptr && inputs.Part->Reference != nullptr;
}

/// Whether curves between labels are collapsed: there are labels or several pairs of them, and no
/// log, which cannot record such collapses.
bool CollapsesFeatureCurves(const RunInputs& inputs);

/// @param task Its largest error is lowered to the diagonal if it is more.
/// @param checkedAt,builtAt Fractions of the progress at which the input is checked and the mesh is
/// built.
/// @param report Status, figures of the input. The result is of use only if its status is good.
PreparedInput PrepareInput(
  RunTask& task, double checkedAt, double builtAt, RunProgress& progress, Report& report);
}

#endif
