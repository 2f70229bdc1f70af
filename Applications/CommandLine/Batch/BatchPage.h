// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchPage.h
 * @brief The table of a batch as a page with links to what it wrote.
 */
#ifndef BoneDecimate_Applications_BatchPage_h
#define BoneDecimate_Applications_BatchPage_h

#include "BatchTable.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// @param folder Where the page is to lie: links are relative to it.
std::string ComposeBatchPage(const std::string& folder, const std::vector<BatchRow>& rows);
}

#endif
