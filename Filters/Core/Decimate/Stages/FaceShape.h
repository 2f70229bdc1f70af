// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceShape.h
 * @brief The smallest angle of a face of the mesh, and a constant of edits that enlarge angles.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FaceShape_h
#define BoneDecimate_Core_Decimate_Stages_FaceShape_h

#include "Geometry/SmallestAngle.h"
#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
/// The decrease of the cosine of a smallest angle that makes an edit worth its proof.
constexpr double MinGainOfCosine = 0.002;

inline double CosineOfFace(const HalfEdgeMesh& mesh, FaceId face)
{
  const auto [a, b, c] = PositionsOf(mesh, face);
  return CosineOfSmallestAngle(a, b, c);
}
}

#endif
