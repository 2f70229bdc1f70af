// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileRounding.h
 * @brief A proved result in millimeters on its way to a file in another unit: writing rounds each
 * coordinate once more.
 *
 *     before    the run keeps a largest error that is smaller by the distance that the rounding can
 *               move a point
 *     after     the distance that the rounding moved points is added to the proved bounds
 *
 * Both surfaces have the same triangles, so that no distance changes by more than the farthest move
 * of a corner.
 */
#ifndef BoneDecimate_Applications_FileRounding_h
#define BoneDecimate_Applications_FileRounding_h

#include "Arguments/LengthUnit.h"
#include "Options/Options.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace bonedecimate
{
/// How far writing can move a point of a surface like this one, mm; 0 if files are in millimeters.
double MaxRounding(vtkPolyData* surface, const LengthUnit& unit, bool isSingle);

/// The largest error of these options as far as it is known before a run, mm; 0 if there is none.
double KnownError(const Options& options);

/**
 * The largest error that a run has to keep so that the rounding may be added.
 * @param unit Or format, for messages.
 * @throws Failure(ExitCode::InputRejected) if that is more than half of it.
 */
double ErrorBeforeRounding(
  double error, double rounding, const std::string& unit, const std::string& path);

/// Whether some point has a tolerance of 0.
bool HasZeroTolerance(vtkPolyData* surface, const std::string& array);

/// The surface with tolerances that are smaller by the rounding; a tolerance below the rounding
/// becomes 0.
vtkSmartPointer<vtkPolyData> TolerancesBeforeRounding(
  vtkPolyData* surface, const std::string& array, double rounding);

/// A copy whose point array of proved bounds, if it is there, holds for points that were moved so
/// far, mm.
vtkSmartPointer<vtkPolyData> WithWidenedBounds(
  vtkPolyData* surface, const std::string& array, double move);

/// A run whose result goes to a file in another unit than millimeters.
struct RoundedRun
{
  const LengthUnit& Unit;
  double Error; ///< mm, requested; 0: none, or not known before the run.
  std::string BoundArray;
  bool MergesPoints;
  const std::string& Path; ///< Path of the input, for messages.
};

struct RoundedResult
{
  vtkSmartPointer<vtkPolyData> Result; ///< mm, with bounds that hold for the file.
  double Move;                         ///< mm, of the farthest point.
};

/**
 * @param result A proved result, mm.
 * @param inFile The result as the file will have it.
 * @throws Failure(ExitCode::InputRejected) if the rounding puts points onto each other,
 * Failure(ExitCode::Undecided) if the largest error is less than the sum.
 */
RoundedResult RoundForFile(vtkPolyData* result, vtkPolyData* inFile, const RoundedRun& run);
}

#endif
