// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Invariants.h
 * @brief Checks everything HalfEdgeMesh promises; for tests and fuzzers, never inside the loop.
 */
#ifndef BoneDecimate_Core_Mesh_Invariants_h
#define BoneDecimate_Core_Mesh_Invariants_h

#include "HalfEdgeMesh.h"

#include <string>

namespace bonedecimate
{
/// The first broken invariant with its index, or an empty string.
std::string BrokenInvariant(const HalfEdgeMesh& mesh);
}

#endif
