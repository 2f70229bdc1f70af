// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceConversion.h
 * @brief The corridor between vtkPolyData and the core's surface. No geometry is decided here.
 */
#ifndef SurfaceConversion_h
#define SurfaceConversion_h

#include "Decimate.h"
#include "Doctor/Doctor.h"
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

  vtkIdType operator()(std::size_t triangle) const { return this->CellOfTriangle[triangle]; }
};

/// Triangles as they are, strips and polygons triangulated, ids out of range as None (the core counts them).
ConvertedSurface ToSurface(vtkPolyData* input, int threads);

/// A number for each point; nothing if there is no such point array of one component.
std::optional<std::vector<double>> ReadPointValues(vtkPolyData* input, const std::string& name);

/// Whether the run has to say where its points and triangles lie on the input.
bool NeedsOrigins(vtkPolyData* input, const Options& options);

/// The result's points, triangles, report and those arrays that were filled (Decimate.h); the input's vertices, lines and
/// field data pass through, its arrays as DataTransfer.h says.
void FillOutput(const Result& result, const ConvertedSurface& converted, const Options& options,
  bool single, vtkPolyData* input, vtkPolyData* output);

/// One array for each entry, its name the prefix and the entry's.
void AddEntries(
  const std::vector<ReportEntry>& entries, const std::string& prefix, vtkFieldData* fieldData);

/// The input with the distance of each of its points to the result, if it was measured, and the map, if it was asked for.
void FillInputCopy(
  const Result& result, const Options& options, vtkPolyData* input, vtkPolyData* output);
}

#endif
