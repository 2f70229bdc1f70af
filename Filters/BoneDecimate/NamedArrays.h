// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NamedArrays.h
 * @brief The surface of a run, and what the arrays that its options name say of it: tolerances and
 * edge lengths of points, labels of triangles.
 */
#ifndef NamedArrays_h
#define NamedArrays_h

#include "Options/Options.h"
#include "Run/Input/Labels.h"
#include "SurfaceConversion.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace bonedecimate
{
/// Labels of triangles as the cell array of the input; without an array: none are known.
struct CellLabels
{
  vtkSmartPointer<vtkDataArray> Array;
  std::vector<vtkIdType> CellOfTriangle; ///< Cell of the input of each triangle.

  /// Adds the labels to a surface. @param triangles For each of its triangles one of the input.
  void Fill(const std::vector<Index>& triangles, vtkPolyData* surface) const;
};

struct NamedArrays
{
  ConvertedSurface Converted;
  std::optional<std::vector<double>> Tolerances;  ///< mm, of each point; nothing: none is named.
  std::optional<std::vector<double>> EdgeLengths; ///< mm, of each point; nothing: none is named.
  std::optional<bonedecimate::Labels> Labels;     ///< Labels of triangles; nothing: none is named.
  /// The array of the labels if it belongs to cells, or null.
  vtkDataArray* LabelsOfCells = nullptr;
  std::string Problem; ///< One sentence; empty if the input has what is named.

  /// Inputs of a run with these arrays; they refer to this object.
  RunInputs Inputs() const;

  CellLabels LabelsToCopy() const;
};

/// The names of the arrays of one component, for a sentence that an array is missing.
std::string ListOfArrays(vtkFieldData* data);

/// The sentence if the input lacks a point array that an option names.
/// @param name In quotes, after a blank.
std::string LackOfPointArray(vtkPolyData* input, const std::string& name);
/// The same for labels, of cells or points.
std::string LackOfLabels(vtkPolyData* input, const std::string& name);

/// @param options ToleranceArrayName, EdgeLengthArrayName and LabelArrayName.
NamedArrays ReadNamedArrays(vtkPolyData* input, const Options& options);
}

#endif
