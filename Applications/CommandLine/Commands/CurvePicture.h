// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvePicture.h
 * @brief The curve of triangles against proved error as an SVG, both axes logarithmic.
 */
#ifndef BoneDecimate_Applications_CurvePicture_h
#define BoneDecimate_Applications_CurvePicture_h

#include <string>
#include <vector>

namespace bonedecimate
{
struct CurvePoint
{
  double Error; ///< mm
  double Triangles;
};

/// @param title Any text. Points without an error or triangles above 0 are left out.
std::string ComposeCurve(const std::string& title, std::vector<CurvePoint> points);
}

#endif
