// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureSeams.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
namespace
{
/// The active texture coordinates, and those that an OBJ file has for each of its materials.
std::vector<vtkDataArray*> TexturesOf(vtkPolyData* input)
{
  vtkPointData* const data = input->GetPointData();
  std::vector<vtkDataArray*> textures;
  const auto add = [&textures](vtkDataArray* array)
  {
    if (array != nullptr && array->GetName() != nullptr && array->GetNumberOfComponents() <= 3 &&
      std::find(textures.begin(), textures.end(), array) == textures.end())
    {
      textures.push_back(array);
    }
  };
  add(data->GetTCoords());
  auto* const materials =
    vtkStringArray::SafeDownCast(input->GetFieldData()->GetAbstractArray("MaterialNames"));
  for (vtkIdType i = 0; materials != nullptr && i < materials->GetNumberOfValues(); ++i)
  {
    add(data->GetArray(materials->GetValue(i).c_str()));
  }
  return textures;
}

struct TexturedPoint
{
  std::array<double, 3> Position;
  std::array<double, 3> Texture;
};

/// Whether points of equal coordinates have different texture coordinates.
bool HasSeam(vtkPolyData* input, vtkDataArray* texture)
{
  std::vector<TexturedPoint> points(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    input->GetPoint(point, points[i].Position.data());
    for (int component = 0; component < texture->GetNumberOfComponents(); ++component)
    {
      points[i].Texture[static_cast<std::size_t>(component)] =
        texture->GetComponent(point, component);
    }
  }
  std::sort(points.begin(), points.end(),
    [](const TexturedPoint& a, const TexturedPoint& b) { return a.Position < b.Position; });
  return std::adjacent_find(points.begin(), points.end(),
           [](const TexturedPoint& a, const TexturedPoint& b)
           { return a.Position == b.Position && a.Texture != b.Texture; }) != points.end();
}
}

std::set<std::string> ArraysWithSeams(vtkPolyData* input)
{
  const std::vector<vtkDataArray*> textures = TexturesOf(input);
  const bool isLeftOut =
    textures.size() > 1 || (textures.size() == 1 && HasSeam(input, textures.front()));
  std::set<std::string> names;
  for (vtkDataArray* texture : textures)
  {
    if (isLeftOut)
    {
      names.insert(texture->GetName());
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::vector<std::string> SeamWarnings(const std::set<std::string>& arrays)
{
  if (arrays.empty())
  {
    return {};
  }
  return {
    "texture coordinates are left out: at seams of the texture, points have several of them, "
    "which simplified triangles cannot keep; MergePoints off keeps seams as open "
    "boundaries"
  };
}
}
