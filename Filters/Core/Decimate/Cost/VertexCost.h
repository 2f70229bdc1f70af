// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexCost.h
 * @brief The cost by which VertexQueue orders vertices, and the edges at a vertex.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_VertexCost_h
#define BoneDecimate_Core_Decimate_Cost_VertexCost_h

#include "Mesh/Handles.h"

namespace bonedecimate
{
class VertexCost
{
public:
  virtual ~VertexCost() = default;
  virtual double OfEdge(HalfEdgeId h) const = 0;
  /// @param v Not constrained.
  virtual double OfVertex(VertexId v) const = 0;
};
}

#endif
