// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Handles.h
 * @brief Indices of vertices, half-edges and faces of a mesh, as types that cannot be mixed up.
 *
 * A handle converts to an Index, for arrays, and from one, for loops over slots. A default handle
 * is None. Neither the conversion of one kind of handle to another nor their comparison compiles.
 */
#ifndef BoneDecimate_Core_Mesh_Handles_h
#define BoneDecimate_Core_Mesh_Handles_h

#include "Geometry/Surface.h"

namespace bonedecimate
{
template <typename Kind>
class Handle
{
public:
  constexpr Handle() = default;
  constexpr Handle(Index value)
    : Value(value)
  {
  }
  template <typename Other>
  Handle(Handle<Other>) = delete;
  constexpr operator Index() const { return this->Value; }
  Handle& operator++()
  {
    ++this->Value;
    return *this;
  }

private:
  Index Value = None;
};

template <typename Kind, typename Other>
bool operator==(Handle<Kind>, Handle<Other>) = delete;
template <typename Kind>
constexpr bool operator==(Handle<Kind> a, Handle<Kind> b)
{
  return static_cast<Index>(a) == static_cast<Index>(b);
}
template <typename Kind, typename Other>
bool operator!=(Handle<Kind>, Handle<Other>) = delete;
template <typename Kind>
constexpr bool operator!=(Handle<Kind> a, Handle<Kind> b)
{
  return static_cast<Index>(a) != static_cast<Index>(b);
}

using VertexId = Handle<struct VertexKind>;
using HalfEdgeId = Handle<struct HalfEdgeKind>;
using FaceId = Handle<struct FaceKind>;
}

#endif
