// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestWord.h
 * @brief The word that was probably meant.
 */
#ifndef BoneDecimate_Applications_NearestWord_h
#define BoneDecimate_Applications_NearestWord_h

#include <string>
#include <vector>

namespace bonedecimate
{
/// The one with the fewest letters to insert, remove or replace, whatever its case; empty if more
/// than two are needed for each.
std::string NearestWord(const std::string& word, const std::vector<std::string>& known);

/**
 * The names, of words with dashes in between, that were probably meant: the nearest word, or, where
 * there is none, at most three of which a part was given ("triangles" of "target-triangles"), or
 * which are a part of what was given.
 */
std::vector<std::string> SimilarNames(
  const std::string& name, const std::vector<std::string>& known);
}

#endif
