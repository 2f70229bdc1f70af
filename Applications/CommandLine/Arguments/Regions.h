// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Regions.h
 * @brief Boxes and balls with a tolerance of their own: "sphere:10,20,30,5=0.05".
 */
#ifndef BoneDecimate_Applications_Regions_h
#define BoneDecimate_Applications_Regions_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct Region
{
  enum Shapes
  {
    Box,    ///< x0, x1, y0, y1, z0, z1, mm
    Sphere, ///< center x, y, z and radius, mm
    Rest    ///< Whatever no other region and no array limits.
  };
  Shapes Shape = Rest;
  std::vector<double> Numbers;
  double Tolerance = 0.0; ///< mm; 0 constrains the vertices
  std::string Text;       ///< As it was given.
};

/// Numbers with commas in between, each -1e30 to 1e30.  @return false if it is anything else.
bool ReadNumbers(const std::string& text, std::vector<double>& numbers);

/**
 * One or more regions, with semicolons in between, appended to those given.
 * @return What is wrong with the text; empty if nothing is.
 */
std::string ReadRegions(const std::string& text, std::vector<Region>& regions);

/// The surface with a point array of tolerances: the least of those of the regions that hold a
/// point, and of the array if it was there before.
vtkSmartPointer<vtkPolyData> WithTolerances(
  vtkPolyData* surface, const std::vector<Region>& regions, const std::string& arrayName);

/// The texts of the regions that hold no point of the surface, and so limit nothing.
std::vector<std::string> RegionsWithoutPoints(
  vtkPolyData* surface, const std::vector<Region>& regions);
}

#endif
