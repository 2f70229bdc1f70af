// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelTableSearch.h
 * @brief The file with the names of labels that lies beside a label map.
 */
#ifndef BoneDecimate_Applications_LabelTableSearch_h
#define BoneDecimate_Applications_LabelTableSearch_h

#include "Labels/LabelTable.h"

#include <string>

namespace bonedecimate
{
struct FoundTable
{
  std::string Path; ///< Path of the table; empty: there is none.
  LabelTable Table;
  std::string Warning; ///< Which file was not taken, and why; may be empty.
};

/**
 * Table for the label map NAME.nii.gz, by the first of these steps that finds one:
 *
 *     NAME.tsv, NAME.csv, NAME.ctbl, NAME_ColorTable.ctbl, NAME.label, NAME.txt
 *     a *_dseg.tsv whose words between underscores are all in NAME, and dseg.tsv
 *     dataset.json; of a map in a folder labels... that of the folder around it, too
 *
 * Two tables of one step that contradict each other are not taken, nor is a damaged one; the
 * warning says so.
 */
FoundTable FindTableBeside(const std::string& labelMap);

/// "label 3 is 'femur' in a.tsv and 'tibia' in b.ctbl"; empty if no label has two names. Case and
/// underscores do not matter.
std::string ContradictionOf(const std::vector<NamedLabel>& a, const std::string& nameOfA,
  const std::vector<NamedLabel>& b, const std::string& nameOfB);

/// Whether the name says no more than the label: empty, "Segment_3", "Label 3", "3".
bool IsGenericName(const std::string& name);
}

#endif
