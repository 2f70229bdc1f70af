// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputArguments.h
 * @brief What belongs to the input on the command line: regions and arrays of tolerances, labels,
 * the reference.
 */
#ifndef BoneDecimate_Applications_InputArguments_h
#define BoneDecimate_Applications_InputArguments_h

#include "LengthUnit.h"
#include "Regions.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkBoneDecimateAlgorithm;

namespace bonedecimate
{
/// Arguments about the input, for commands whose options are not those of the table.
struct InputArguments
{
  std::string ToleranceArray;
  std::string LabelArray;
  std::vector<Region> Regions;
  std::string Reference; ///< Path; empty: none.

  bool HasTolerances() const { return !this->ToleranceArray.empty() || !this->Regions.empty(); }
};

/// Adds --region. @param given Called with all texts, separated by semicolons; may be empty.
void AddRegions(CLI::App& app, std::vector<Region>& regions,
  const std::function<void(const std::string&)>& given = {});

/// Adds --region, --tolerance-array, --labels and --reference.
void AddInputArguments(CLI::App& app, InputArguments& arguments);

/// @throws Failure(ExitCode::InputRejected) if the surface lacks a point array; an empty name is
///   none.
void NeedPointArray(vtkPolyData* surface, const std::string& array, const std::string& path);

/**
 * The surface with an array of tolerances from the regions, if there are any, which becomes that of
 * the filter.
 * @param array The array of tolerances that was requested; empty: none.
 * @param path Path of the surface, for messages.
 * @throws Failure(ExitCode::InputRejected) if the surface lacks the array.
 */
vtkSmartPointer<vtkPolyData> ApplyRegions(const std::vector<Region>& regions, std::string array,
  const std::string& path, vtkSmartPointer<vtkPolyData> surface, vtkBoneDecimateAlgorithm* filter,
  std::vector<std::string>& warnings);

/// Sets the options of the arrays. @return The surface as ApplyRegions() returns it.
vtkSmartPointer<vtkPolyData> ApplyInputArguments(const InputArguments& arguments,
  const std::string& path, vtkSmartPointer<vtkPolyData> surface, vtkBoneDecimateAlgorithm* filter,
  std::vector<std::string>& warnings);

/// In millimeters; null if there is none. @throws Failure(ExitCode::InputRejected)
vtkSmartPointer<vtkPolyData> ReadReference(const InputArguments& arguments, const LengthUnit& unit);
}

#endif
