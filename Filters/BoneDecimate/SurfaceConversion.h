// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceConversion.h
 * @brief The corridor between vtkPolyData and the core's surface. No geometry is decided here.
 */
#ifndef SurfaceConversion_h
#define SurfaceConversion_h

#include "Decimate.h"
#include "ReportTable.h"

#include "vtkType.h"

#include <optional>
#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace bonedecimate
{
struct ConvertedSurface
{
  bonedecimate::Surface Surface;
  std::vector<vtkIdType> CellOfTriangle; ///< Cell of the input from which each triangle came.
  bool IsSingle = true;                  ///< Whether the points are single precision.
  std::vector<std::string> Warnings;     ///< What had to be left out, a sentence each.
};

/// Triangles as they are, strips and polygons triangulated, ids out of range as None (the core counts them).
ConvertedSurface ToSurface(vtkPolyData* input, int threads);

/// A number for each point; nothing if there is no such point array of one component.
std::optional<std::vector<double>> ReadPointValues(vtkPolyData* input, const std::string& name);

/// Triangles that the report names become the cells from which they came.
void NameCells(const ConvertedSurface& converted, Report& report);

/// The result's points, triangles, report and those arrays that were filled (Decimate.h); the input's vertices, lines and
/// field data pass through.
void FillOutput(const Result& result, const Options& options, bool single, vtkPolyData* input,
  vtkPolyData* output);

/// One array for each entry, its name the prefix and the entry's.
void AddEntries(
  const std::vector<ReportEntry>& entries, const std::string& prefix, vtkFieldData* fieldData);

/// The input with the distance of each of its points to the result, if it was measured.
void FillInputCopy(
  const Result& result, const Options& options, vtkPolyData* input, vtkPolyData* output);

/// Names of the input's point and cell arrays, which the result does not carry; empty if there are none.
/// @param used Name of one that is not missed.
std::string NamesOfArraysLeftBehind(vtkPolyData* input, const std::string& used = {});
}

#endif
