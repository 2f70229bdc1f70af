// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tables.h
 * @brief The tables of modes, formats and reasons of rejections, for programs: scripts and tests
 * list none of them by hand.
 */
#ifndef BoneDecimate_Applications_Tables_h
#define BoneDecimate_Applications_Tables_h

#include <string>

namespace bonedecimate
{
/**
 * An object of three lists, each in the order of its table:
 *
 *     modes        name, use, order, position, refinement (Markdown), proves_error, is_default
 *     formats      extension, holds_arrays, holds_doubles, keeps_points, names_unit, has_grid,
 *                  missing_library
 *     rejections   word, sentence
 */
std::string TablesJson();
}

#endif
