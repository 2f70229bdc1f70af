// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditorContinued.cxx
 * @brief What an editor knows of the reference if its run continues an earlier one.
 */
#include "Editor.h"

#include <algorithm>

namespace bonedecimate
{
std::vector<Index> Editor::CurrentVertices() const
{
  std::vector<Index> current = this->Source.CurrentVertices();
  if (this->Continued == nullptr)
  {
    return current;
  }
  std::vector<Index> ofReference = this->Continued->NearVertex;
  for (Index& vertex : ofReference)
  {
    vertex = current[vertex];
  }
  return ofReference;
}

//------------------------------------------------------------------------------
/// Adds the corners of faces that may be what a triangle of the reference is near to, although this
/// was not proved.
/// @param constrained For each vertex, whether it is constrained; empty: none is.
std::vector<char> Editor::NearUnproved(std::vector<char> constrained) const
{
  constrained.resize(this->Unproved.empty()
      ? constrained.size()
      : static_cast<std::size_t>(this->Half.NumberOfVertexSlots()),
    0);
  for (const FaceId triangle : this->Unproved)
  {
    double squaredReach = 0.0;
    Vector3 middle = Vector3::Zero();
    for (const Index corner : this->Continued->Mesh.Corners(triangle))
    {
      middle += this->Continued->Mesh.Position(corner) / 3.0;
    }
    for (const Index corner : this->Continued->Mesh.Corners(triangle))
    {
      const double reach = (this->Continued->Mesh.Position(corner) - middle).norm() +
        this->BoundFilter->LimitAt(corner);
      squaredReach = std::max(squaredReach, reach * reach);
    }
    this->Source.Tree().VisitNear(middle, squaredReach,
      [&](Index face)
      {
        for (const Index corner : this->Half.Corners(face))
        {
          constrained[corner] = 1;
        }
      });
  }
  return constrained;
}
}
