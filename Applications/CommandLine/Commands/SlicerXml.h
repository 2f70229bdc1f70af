// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlicerXml.h
 * @brief The program's description for 3D Slicer, made from the table of options.
 */
#ifndef BoneDecimate_Applications_SlicerXml_h
#define BoneDecimate_Applications_SlicerXml_h

#include <string>
#include <vector>

namespace bonedecimate
{
/// A number or word that the module gives back.
struct SlicerResult
{
  const char* Name;   ///< In the description and the file of results.
  const char* Kind;   ///< "integer", "double" or "string", as in the description.
  const char* Report; ///< Its entry in ReportTable.h.
  const char* Label;
};

const std::vector<SlicerResult>& SlicerResults();

/// A module description as Slicer's ModuleDescriptionParser reads it.
std::string SlicerXml();
}

#endif
