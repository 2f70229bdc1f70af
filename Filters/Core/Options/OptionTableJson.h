// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OptionTableJson.h
 * @brief The table of options as JSON, for what is generated from it:
 * methods of filters, panels, types.
 */
#ifndef BoneDecimate_Core_Options_OptionTableJson_h
#define BoneDecimate_Core_Options_OptionTableJson_h

#include <string>

namespace bonedecimate
{
/**
 * { "modes": [names], "options": [rows] }, a row with
 *
 *     name, kind         "MaximumError"; "bool", "int", "double", "choice" or "text"
 *     minimum, maximum   of a number, or of the numbers of a choice
 *     unit, flag         without dashes; empty where there is none
 *     choices            names of the values 0, 1, ...
 *     default            as text
 *     sentence           the meaning
 *     group, advanced    of panels
 *     names_point_array  whether it is chosen from the point arrays of the input
 *     conditions         lists of [option, value, whether it has the value]: of each list one holds
 *                        where the option has an effect
 *     unsupported        { kind of run: why it does not have the option }
 */
std::string OptionTableJson();
}

#endif
