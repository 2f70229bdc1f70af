// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GltfScene.h
 * @brief The meshes of the default scene of a glTF document and where its nodes put them.
 */
#ifndef BoneDecimate_Applications_GltfScene_h
#define BoneDecimate_Applications_GltfScene_h

#include "GltfDocument.h"

#include "vtkPolyData.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
/// An affine map: 3 rows of 4 numbers.
struct GltfTransform
{
  std::array<double, 12> Rows = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };

  GltfTransform After(const GltfTransform& inner) const; ///< First the inner one.
  std::array<double, 3> Of(const std::array<double, 3>& point) const;
  double Determinant() const;
  /// A normal, which stays at a right angle to its surface; of length 1.
  std::array<double, 3> OfNormal(const std::array<double, 3>& normal) const;
  bool IsIdentity() const { return this->Rows == GltfTransform().Rows; }
};

/// A node with a mesh.
struct GltfInstance
{
  const nlohmann::json* Node;
  GltfTransform Transform;
};

struct GltfScene
{
  std::vector<GltfInstance> Instances;
  /// Written by this program: below the node of its frame (GlbFiles.h).
  bool IsInMillimeters = false;
  std::int64_t HiddenNodes = 0;      ///< Nodes that are marked as not visible.
  std::int64_t UnusedMeshes = 0;     ///< Meshes unused by the scene; 0 if nodes are hidden.
  std::vector<std::string> Warnings; ///< What the scene leaves aside, a sentence each.
};

/// @throws Failure(ExitCode::InputRejected), Json::exception
GltfScene ReadScene(const GltfDocument& document);

/// Tells the surface what of its file is no part of it (LeftOutCells.h).
/// @param primitives Number of primitives of points or lines.
void ListLeftOut(const GltfScene& scene, std::int64_t primitives, vtkPolyData* surface);
}

#endif
