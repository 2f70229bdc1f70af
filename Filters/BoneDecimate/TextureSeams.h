// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextureSeams.h
 * @brief Texture coordinates that one point for each position cannot hold.
 *
 * A texture has seams where points of equal coordinates have different texture coordinates. The
 * core merges such points, and triangles along a seam would then span the whole picture.
 */
#ifndef TextureSeams_h
#define TextureSeams_h

#include <set>
#include <string>
#include <vector>

class vtkPolyData;

namespace bonedecimate
{
/// Names of the point arrays of texture coordinates if the texture has seams, or several materials
/// have one each; otherwise none.
std::set<std::string> ArraysWithSeams(vtkPolyData* input);

/// The sentence that says that they are left out; none if there are no seams.
std::vector<std::string> SeamWarnings(const std::set<std::string>& arrays);
}

#endif
