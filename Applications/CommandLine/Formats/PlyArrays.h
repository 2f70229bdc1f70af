// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlyArrays.h
 * @brief The single properties of a PLY file's vertices or faces as arrays.
 */
#ifndef BoneDecimate_Applications_PlyArrays_h
#define BoneDecimate_Applications_PlyArrays_h

#include "PlyHeader.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

#include <cstdint>

namespace bonedecimate
{
/**
 * Colors, normals and texture coordinates become "RGB" or "RGBA", "Normals" and "TCoords" and the
 * active ones, as in VTK's reader; of faces "intensity" and colors are the active scalars. Every
 * other property becomes an array of its own name and type.
 */
class PlyArrays
{
public:
  enum class Kind
  {
    Points,
    Cells
  };

  PlyArrays(const PlyElement& element, Kind kind);

  /// The values of one vertex or face, by property.
  void Set(std::int64_t number, const std::vector<double>& values);

  void AddTo(vtkDataSetAttributes* data) const;

private:
  struct Column
  {
    std::vector<std::size_t> Properties;
    vtkSmartPointer<vtkDataArray> Array;
    int Attribute; // vtkDataSetAttributes::SCALARS and so on, -1: none
  };

  bool AddGroup(const PlyElement& element, const char* name, int attribute,
    const std::vector<std::string>& properties);
  void AddColors(const PlyElement& element);
  void AddOthers(const PlyElement& element);

  std::vector<Column> Columns;
  std::vector<bool> Taken; // properties that have an array
};
}

#endif
