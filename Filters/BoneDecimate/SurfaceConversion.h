// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceConversion.h
 * @brief Conversion between vtkPolyData and the core's surface.
 */
#ifndef SurfaceConversion_h
#define SurfaceConversion_h

#include "Repair/Diagnostics/Diagnostics.h"
#include "Run/Decimate.h"
#include "Run/Report/ReportTable.h"

#include "vtkType.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFieldData;
class vtkPolyData;

namespace bonedecimate
{
struct ConvertedSurface
{
  bonedecimate::Surface Surface;
  std::vector<vtkIdType> CellOfTriangle; ///< Cell of the input from which each triangle came.
  bool IsSingle = true;                  ///< Whether the points are single precision.
  std::vector<LeftOutShape> LeftOut;     ///< RunInputs::LeftOut
  std::vector<std::string> Warnings;     ///< What had to be left out, a sentence each.

  vtkIdType operator()(std::size_t triangle) const { return this->CellOfTriangle[triangle]; }
};

/// Triangles as they are, strips and polygons triangulated (PolygonCells.h), ids out of range as
/// None (the core counts them).
ConvertedSurface ToSurface(vtkPolyData* input, int threads);

/// The values of an array; nothing if it is null or has several components.
std::optional<std::vector<double>> ReadNumbers(vtkDataArray* array);

/// Whether the run has to say where its points and triangles lie on the input.
bool NeedsOrigins(vtkPolyData* input, const Options& options);

/// The result's points, triangles, report and those arrays that were filled (Result.h); the
/// input's vertices, lines and field data pass through, its arrays as DataTransfer.h says.
void FillOutput(const Result& result, const ConvertedSurface& converted, const Options& options,
  bool single, vtkPolyData* input, vtkPolyData* output);

/// How a report is stored in field data.
struct ReportArrays
{
  std::string Json;   ///< Name of the array of one string.
  std::string Prefix; ///< Prefix of the array names of the key figures.
  std::vector<std::string> KeyFigures;
};
const ReportArrays& ArraysOfReport();      ///< BoneDecimateReport, bonedecimate.*
const ReportArrays& ArraysOfCertificate(); ///< BoneDecimateCertificate, bonedecimate.certificate.*

/// Replaces the reports of earlier runs. The key figures that are among the entries get an array
/// each, with their unit.
void SetReport(
  const std::vector<ReportEntry>& entries, const ReportArrays& arrays, vtkFieldData* fieldData);

/// The input with the distance of each of its points to the result, if it was measured, and the
/// map, if MakeMaps is on or these distances are those of an input that was pruned.
void FillInputCopy(
  const Result& result, const Options& options, vtkPolyData* input, vtkPolyData* output);
}

#endif
