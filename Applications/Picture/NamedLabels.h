// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NamedLabels.h
 * @brief Names and colors of labels, in the field arrays LabelValues, LabelNames and LabelColors of
 * surfaces and label maps.
 */
#ifndef BoneDecimate_Applications_NamedLabels_h
#define BoneDecimate_Applications_NamedLabels_h

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// The cell array with the labels on both sides of each triangle.
constexpr const char* LabelsOfSidesName = "BoundaryLabels";

/// The cell array with the color of each triangle: three bytes.
constexpr const char* ColorArray = "Color";

using LabelColor = std::array<unsigned char, 3>; ///< Red, green, blue.

struct NamedLabel
{
  std::int64_t Value = 0;
  std::string Name; ///< Empty: it has none.
  std::optional<LabelColor> Color;
};

/// One label for each row of LabelValues; empty if there is no such array.
std::vector<NamedLabel> ReadNamedLabels(vtkFieldData* fields);

/// Replaces the three arrays. Without any color there is no LabelColors; a label without one is
/// black.
void WriteNamedLabels(const std::vector<NamedLabel>& labels, vtkFieldData* fields);

/// The labels of a surface of vtkBoneSurfaces or of its result, without the background, which is
/// the last value.
std::vector<NamedLabel> LabelsOf(vtkPolyData* surface);

/// "3 (femur)", or "3" without a name.
std::string LabelText(const NamedLabel& label);

/// The color of the first of the labels of each triangle; null if the surface has no
/// BoundaryLabels, or no label has a color.
/// @param labels LabelsOf() the surface.
vtkSmartPointer<vtkUnsignedCharArray> ColorsOfTriangles(
  vtkPolyData* surface, const std::vector<NamedLabel>& labels);

/// Gives those without a color one that differs from its neighbors in the list.
std::vector<NamedLabel> WithColors(std::vector<NamedLabel> labels);
}

#endif
