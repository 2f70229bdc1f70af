// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArgumentKinds.h
 * @brief What does not go together on the command line: what each argument needs, and what each
 * kind of run lacks.
 */
#ifndef BoneDecimate_Applications_ArgumentKinds_h
#define BoneDecimate_Applications_ArgumentKinds_h

#include "Arguments.h"

#include <string>

namespace bonedecimate
{
/// Why the first argument that does not go with the others is rejected; empty if there is none.
std::string FindContradiction(const Arguments& arguments);
}

#endif
