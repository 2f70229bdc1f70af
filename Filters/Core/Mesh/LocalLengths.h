// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalLengths.h
 * @brief The length that edges are to have at each vertex, kept with its position so that
 * only moved vertices are looked up.
 */
#ifndef BoneDecimate_Core_Mesh_LocalLengths_h
#define BoneDecimate_Core_Mesh_LocalLengths_h

#include "HalfEdgeMesh.h"
#include "SizingField.h"

#include <memory>
#include <vector>

namespace bonedecimate
{
class LocalLengths
{
public:
  /// @param sizes Null: there are none.
  LocalLengths(std::shared_ptr<const SizingField> sizes, const HalfEdgeMesh& mesh, int threads);

  /// mm, of a vertex at that position, which it need not have.
  double At(VertexId vertex, const Vector3& position) const;

  /// The same; keeps it if the vertex has moved or is new.
  double Update(VertexId vertex, const Vector3& position);

private:
  struct CachedLength
  {
    Vector3 Position;
    SizingField::LocalLength Found;
  };
  std::shared_ptr<const SizingField> Sizes;
  std::vector<CachedLength> CachedLengths;
};
}

#endif
