// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Invariants.h
 * @brief Checks the invariants of HalfEdgeMesh, for tests and fuzzers.
 */
#ifndef BoneDecimate_Core_Mesh_Invariants_h
#define BoneDecimate_Core_Mesh_Invariants_h

#include "HalfEdgeMesh.h"

#include <string>

namespace bonedecimate
{
/// Describes the first violated invariant with its index; empty if all hold.
std::string BrokenInvariant(const HalfEdgeMesh& mesh);
}

#endif
