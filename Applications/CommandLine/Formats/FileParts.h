// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileParts.h
 * @brief A surface as the parts of a file: one for each label, with the walls between labels in
 * both.
 *
 *     written    a surface with BoundaryLabels -> a part for each label, its triangles with the
 *                normal outward
 *     read       parts -> one surface; two parts with the same triangle have a wall in common,
 *                which is one triangle again
 *
 * A surface without BoundaryLabels is one part.
 */
#ifndef BoneDecimate_Applications_FileParts_h
#define BoneDecimate_Applications_FileParts_h

#include "NamedLabels.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Values of the points of a part that was read.
struct PartArray
{
  int Components = 1;
  int Type = 0; ///< VTK_FLOAT and so on.
  std::vector<double> Values;
};

struct FilePart
{
  std::optional<NamedLabel> Label;    ///< None: the surface has no labels.
  std::vector<std::uint32_t> Corners; ///< Three for each triangle, indices of Points.
  std::vector<std::array<double, 3>> Points;
  /// Points of the written surface; empty in a part that was read.
  std::vector<vtkIdType> OriginalPoints;
  std::map<std::string, PartArray> Arrays; ///< By name; empty in a part that is written.
};

/// Labels without triangles are left out.
std::vector<FilePart> PartsOf(vtkPolyData* surface);

/// With the point arrays that all parts have. @param parts Their corners are valid.
vtkSmartPointer<vtkPolyData> JoinParts(const std::vector<FilePart>& parts);

/// Names of the arrays that JoinParts() leaves aside: those that some parts have in another form or
/// not at all.
std::vector<std::string> ArraysOfSomeParts(const std::vector<FilePart>& parts);

/// Whether each edge belongs to two triangles of opposite direction.
bool IsClosed(const FilePart& part);
}

#endif
