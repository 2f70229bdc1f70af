// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LengthUnit.h
 * @brief --unit: the unit of the coordinates in files of surfaces that do not name it. Everything
 * else is in millimeters.
 *
 *     read     file -> double -> millimeters
 *     write    millimeters -> double -> unit of the file -> precision of the file
 */
#ifndef BoneDecimate_Applications_LengthUnit_h
#define BoneDecimate_Applications_LengthUnit_h

#include "CliForward.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct SurfaceFormat;

struct LengthUnit
{
  std::string Name = "mm";
  double Factor = 1.0; ///< mm = coordinate Factor / Divisor, both whole numbers.
  double Divisor = 1.0;
  bool IsRequested = false; ///< By --unit.

  bool IsMillimeter() const { return this->Factor == this->Divisor; }
  double ToMillimeters(double coordinate) const
  {
    return coordinate * this->Factor / this->Divisor;
  }

  /// One that ToMillimeters() makes this number of, if there is one; else the nearest.
  double FromMillimeters(double millimeters) const;
};

/// The unit of a file: mm if its format names it, else the requested one.
LengthUnit UnitOfFile(const std::string& path, const LengthUnit& requested);

/// The unit of several files: mm if the format of each names it, else the requested one.
LengthUnit UnitOfFiles(
  const std::vector<const SurfaceFormat*>& formats, const LengthUnit& requested);

/// Adds --unit.
void AddUnit(CLI::App& app, LengthUnit& unit);

/// A surface of a file, converted.
struct MillimeterSurface
{
  vtkSmartPointer<vtkPolyData> Surface;
  std::vector<std::string> Warnings;
  vtkSmartPointer<vtkPolyData> InFile; ///< In the unit of the file.
  /// How unit and axes of the file were taken, a sentence; empty: nothing to say.
  std::string Note;
  bool TakesUnit = true; ///< Whether --unit has a meaning for the file.

  /// Whether the coordinates in the file are in single precision.
  bool IsSingle() const { return this->InFile->GetPoints()->GetDataType() == VTK_FLOAT; }
};

/// @throws Failure(ExitCode::InputRejected)
MillimeterSurface ReadInMillimeters(const std::string& path, const LengthUnit& unit);

/// Points of double precision in millimeters; the surface itself if that is its unit.
vtkSmartPointer<vtkPolyData> ToMillimeters(vtkPolyData* surface, const LengthUnit& unit);

/**
 * The surface itself if its file is in millimeters.
 * @param input What the surface was made from, in the unit of its file: a point that has not moved
 * gets its coordinates back bit for bit, although several numbers of a file may be the same in
 * millimeters.
 */
vtkSmartPointer<vtkPolyData> FromMillimeters(
  vtkPolyData* surface, const LengthUnit& unit, bool toSingle, vtkPolyData* input);

/**
 * The message, with --unit and --allow-large-error named where it doubts that coordinates are in
 * millimeters.
 * @param source The file that it is about; one that names its unit takes no --unit.
 * @param unit Requested unit.
 */
std::string WithUnitHint(std::string message, const std::string& source, const LengthUnit& unit);
}

#endif
