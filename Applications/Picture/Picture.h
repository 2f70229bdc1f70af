// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Picture.h
 * @brief The picture a surgeon looks at: before, after, and the distance in mm as colors with a
 * scalar bar.
 */
#ifndef BoneDecimate_Applications_Picture_h
#define BoneDecimate_Applications_Picture_h

#include "vtkPolyData.h"

#include <array>
#include <optional>
#include <string>

namespace bonedecimate
{
/// A point that the close-up shows, with a ring around it.
struct PictureMark
{
  std::array<double, 3> Position; ///< mm
  bool IsOnBefore = true;         ///< Otherwise it is a point of the result.
  std::string Words;              ///< Beside the ring.
  double MostWidth = 0.0;         ///< Limit of the width of the close-up, mm.
  std::string Largest;            ///< The largest distance of the two surfaces, mm.
};

struct PictureSubject
{
  vtkPolyData* Before = nullptr; ///< The input surface, with the array below as point data.
  vtkPolyData* After = nullptr;  ///< The result.
  std::string DistanceArrayName; ///< mm, distance of each point of Before to After.
  std::string Title;             ///< Over the picture; may be empty.
  std::string Frame; ///< "LPS", "RAS", or empty: not known. Then no directions are written.
  std::array<std::string, 2> Names{ "Before", "After" }; ///< What captions call the surfaces.
  std::array<std::optional<double>, 2>
    Triangles;                     ///< In captions, before and after; empty: as drawn.
  double LargestDistance = 0.0;    ///< mm, if it is known to be larger than that of any point.
  double Tolerance = 0.0;          ///< As that of ColorScale.
  std::optional<PictureMark> Mark; ///< Empty: the close-up shows where most of the distance is.
  int Width = 1800;                ///< Pixels, of the file; the height goes with it.
};

/// Why this program draws no pictures; empty if it does.
std::string WhyNoPictures();

/// Renders off screen and writes a PNG whole or not at all. Returns what went wrong, or an empty
/// string. Without a display it starts a virtual one (Xvfb) if the system has it.
std::string WritePicture(const PictureSubject& subject, const std::string& file);
}

#endif
