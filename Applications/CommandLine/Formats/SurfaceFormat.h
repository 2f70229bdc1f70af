// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceFormat.h
 * @brief The table of surface formats: what each can hold, how it is read and written.
 *
 * A new format is a file NAMEFormat.cxx with its row and the name of that row in SurfaceFormat.cxx.
 * Readers, writers, messages, the help, batches, the description for 3D Slicer, tests and the
 * fuzzer of files take it from there.
 */
#ifndef BoneDecimate_Applications_SurfaceFormat_h
#define BoneDecimate_Applications_SurfaceFormat_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>
#include <vector>

namespace bonedecimate
{
class CoordinateCollector;

struct SurfaceFormat
{
  const char* Extension; ///< In lower case, without its dot.
  bool HoldsArrays;      ///< All arrays (distances, report) beside points and triangles.
  bool HoldsDoubles;     ///< Coordinates in double precision come back as they were.
  bool KeepsPoints;      ///< As many points come back as were written.

  /**
   * Reads a file that is there and not empty. What it does not read becomes a warning or a message
   * of VTK.
   * @throws Failure(ExitCode::InputRejected)
   */
  vtkSmartPointer<vtkPolyData> (*Read)(const std::string& path, std::vector<std::string>& warnings);

  /// @throws Failure(ExitCode::CouldNotWrite)
  void (*Write)(vtkPolyData* surface, const std::string& path);

  /// The file says its unit: surfaces are read and written in mm, whatever --unit is.
  bool NamesUnit = false;
  /// Files of other programs name a unit that may not be meant: --unit tells another.
  bool UnitMayDiffer = false;
  /// Coordinates are whole multiples of a step (PointGrid.h): surfaces are written on such a grid.
  bool HasGrid = false;
  bool IsForPrinting = false; ///< Parts that are not closed are no solids in it.
  bool HoldsLines = false;    ///< Lines and single vertices; those that hold arrays do.
  /// Names of the arrays of points, cells and fields that a file of this surface holds; null: all
  /// or none, see HoldsArrays.
  std::set<std::string> (*ArraysHeld)(vtkPolyData* surface) = nullptr;
  /// Writes in fewer bytes what fewer programs read; null: there is one form only.
  void (*WriteCompressed)(vtkPolyData* surface, const std::string& path) = nullptr;
  std::string MissingLibrary = {}; ///< What the build lacks to read and write it; empty: nothing.

  /// What a file has to pass before a library reads it, which would trust it; null: Read checks all
  /// itself.
  void (*Check)(const std::string& path, CoordinateCollector& textPoints) = nullptr;
};

/// The row of a format in a build without its library.
SurfaceFormat FormatWithoutLibrary(const char* extension, const char* library);

/// "'bone.glb' needs meshoptimizer, which this build lacks"; empty if the build lacks nothing.
std::string LackText(const std::string& path);

/// Every format once. A new one comes last: the corpus of the fuzzer has the numbers of rows.
const std::vector<const SurfaceFormat*>& SurfaceFormats();

/// The format of a file by its extension, whatever its case; null if there is none.
const SurfaceFormat* FindFormat(const std::string& path);

/// "vtp, vtk, ply, stl, obj"
std::string SurfaceExtensions();

/// "vtp and vtk": those for which a property holds, such as &SurfaceFormat::HoldsArrays.
std::string ExtensionsThat(bool SurfaceFormat::*property);
}

#endif
