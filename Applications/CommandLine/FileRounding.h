// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileRounding.h
 * @brief A proved result in millimeters on its way to a file in another unit: writing rounds each coordinate once more.
 *
 *     room      the run keeps a largest error that is smaller by what the rounding can move a point
 *     widened   what was proved of the result, with what the rounding moved its points added
 *
 * Both surfaces have the same triangles, so that no distance changes by more than the farthest move of a corner.
 */
#ifndef BoneDecimate_Applications_FileRounding_h
#define BoneDecimate_Applications_FileRounding_h

#include "LengthUnit.h"
#include "Options.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace bonedecimate
{
/// How far writing can move a point of a surface like this one, mm; 0 if files are in millimeters.
double LargestRounding(vtkPolyData* surface, const LengthUnit& unit, bool isSingle);

/// The largest error of these options as far as it is known before a run, mm; 0 if there is none.
double KnownError(const Options& options);

/**
 * Leaves room for the rounding in a largest error.
 * @throws Failure(ExitCode::InputRefused) if that is more than half of it.
 */
double ErrorWithRoom(
  double error, double rounding, const LengthUnit& unit, const std::string& path);

/// Whether some point has a tolerance of 0.
bool HasFrozenPoints(vtkPolyData* surface, const std::string& array);

/// The surface with an array of tolerances that leaves the same room; one that leaves none freezes.
vtkSmartPointer<vtkPolyData> TolerancesWithRoom(
  vtkPolyData* surface, const std::string& array, double rounding);

/// How far the farthest point of a result, mm, lies from itself in the file, mm.
double LargestMove(vtkPolyData* result, vtkPolyData* inFile, const LengthUnit& unit);

/**
 * A copy whose proved bounds in the field data ("bonedecimate.proof.*", and those of open borders) hold for the file.
 * @param error What is kept then, mm; 0: leaves the tolerance of the proof as it is.
 */
vtkSmartPointer<vtkPolyData> WithWidenedProof(vtkPolyData* result, double move, double error);

/// A copy with the same for a point array of bounds, if it is there.
vtkSmartPointer<vtkPolyData> WithWidenedBounds(
  vtkPolyData* surface, const std::string& array, double move);

/// Points of different coordinates in the first surface that have the same in the second.
vtkIdType CountMeetingPoints(vtkPolyData* result, vtkPolyData* inFile);
}

#endif
