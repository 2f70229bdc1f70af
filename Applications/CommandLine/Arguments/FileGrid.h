// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileGrid.h
 * @brief --position-bits: the grid of outputs whose coordinates are whole numbers
 * (Formats/PointGrid.h).
 *
 * The run rounds its points to this grid, so that what is proved is what these files hold.
 */
#ifndef BoneDecimate_Applications_FileGrid_h
#define BoneDecimate_Applications_FileGrid_h

#include "Arguments.h"
#include "Formats/PointGrid.h"

#include "vtkPolyData.h"

#include <functional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Adds --position-bits, --glb-compression and --vertex-colors.
void AddFileOptions(CLI::App& app, Arguments& arguments);

/// Adds --glb-compression. @param given Receives the value.
void AddGlbCompression(
  CLI::App& app, bool& compresses, const std::function<void(const std::string&)>& given);

/// Checks the options of AddFileOptions() against the outputs. @throws Failure(ExitCode::Usage)
void CheckFileOptions(const Arguments& arguments);

/// Whether some output has its coordinates on a grid.
bool WritesGrid(const Arguments& arguments);

/**
 * mm, the step of the grid for what is made from this surface.
 * @param error mm, the largest error; 0: none, or not known.
 * @param path Path of the surface, for messages.
 * @throws Failure(ExitCode::InputRejected) if rounding would take more than half of the error.
 */
double GridStepFor(vtkPolyData* surface, double error, int bits, const std::string& path);

/// "glb: coordinates are multiples of 0.0039 mm ..."
std::string GridNote(double step, bool isBounded);

/// A warning for each kind of doubt about a surface on a grid: points that coincide. @param
/// mergesPoints Whether they did not before.
std::vector<std::string> GridWarnings(vtkPolyData* surface, double step, bool mergesPoints);

/**
 * The surface with the point array VertexColor (Formats/GlbFiles.h): the proved bound at each
 * point, or the distance where nothing is proved, from white at 0 to red at the largest error
 * (without one: the largest value).
 * @throws Failure(ExitCode::InputRejected) if the surface has neither.
 */
vtkSmartPointer<vtkPolyData> WithErrorColors(
  vtkPolyData* surface, const std::vector<std::string>& arrays, double error);
}

#endif
