// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceShape.h
 * @brief The smallest angle of a face of the mesh, and what edits for the sake of angles have in
 * common.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FaceShape_h
#define BoneDecimate_Core_Decimate_Stages_FaceShape_h

#include "Geometry/SmallestAngle.h"
#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
/// By how much an edit has to lower the cosine of a smallest angle to be worth its proof.
constexpr double MinGainOfCosine = 0.002;

inline double CosineOfFace(const HalfEdgeMesh& mesh, FaceId face)
{
  const auto [a, b, c] = PositionsOf(mesh, face);
  return CosineOfSmallestAngle(a, b, c);
}
}

#endif
