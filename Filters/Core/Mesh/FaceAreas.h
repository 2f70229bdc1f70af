// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceAreas.h
 * @brief Cached area and unit normal of every face for the costs.
 */
#ifndef BoneDecimate_Core_Mesh_FaceAreas_h
#define BoneDecimate_Core_Mesh_FaceAreas_h

#include "Geometry/TriangleGeometry.h"
#include "HalfEdgeMesh.h"

#include <vector>

namespace bonedecimate
{
class FaceAreas
{
public:
  struct Face
  {
    Vector3 Normal = Vector3::Zero(); ///< Unit length; zero for a face without area.
    double Area = 0.0;                ///< mm^2
  };

  explicit FaceAreas(const HalfEdgeMesh& mesh)
    : Faces(static_cast<std::size_t>(mesh.NumberOfFaceSlots()))
  {
    for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
    {
      this->Update(mesh, face);
    }
  }

  void Update(const HalfEdgeMesh& mesh, FaceId face)
  {
    const auto [a, b, c] = PositionsOf(mesh, face);
    const Vector3 vector = AreaVector(a, b, c);
    const double area = vector.norm();
    this->Faces[face] = { area > 0.0 ? Vector3(vector / area) : Vector3(Vector3::Zero()), area };
  }

  const Face& operator[](FaceId face) const { return this->Faces[face]; }

private:
  std::vector<Face> Faces;
};
}

#endif
