// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PassedNames.h
 * @brief Names under which arrays of the input go to the result, beside the arrays that a run adds.
 */
#ifndef PassedNames_h
#define PassedNames_h

#include "Options/Options.h"

#include <set>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;
class vtkPolyData;

namespace bonedecimate
{
/// Names of the point arrays that a run adds to its result.
std::set<std::string> OwnPointArrays(const Options& options);

/// Names of the point arrays that a run adds to the copy of its input.
std::set<std::string> OwnInputArrays(const Options& options);

/**
 * The name of an input array in the result. An array with the name of an own array is either that
 * of an earlier run, which is dropped, or the user's, which gets another name: "Distance.input".
 * Arrays of runs have the unit as the name of their component.
 * @param own Names of the arrays that the run adds. @return Empty: dropped, or without a name.
 */
std::string PassedName(
  vtkAbstractArray* array, const std::set<std::string>& own, vtkDataSetAttributes* data);

/// A sentence for each array that gets another name, and for texture coordinates that are left out
/// (TextureSeams.h).
std::vector<std::string> ArrayWarnings(vtkPolyData* input, const Options& options);

/// Keeps arrays of the user in the copy of an input under such names.
void KeepUserArrays(vtkPolyData* copy, const Options& options);
}

#endif
