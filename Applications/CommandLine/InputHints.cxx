// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputHints.h"

#include <algorithm>

namespace bonedecimate
{
std::string VertexCellsHint(vtkPolyData* input)
{
  const vtkIdType vertices = input->GetNumberOfVerts();
  return vertices == 0 ? std::string()
                       : std::to_string(vertices) +
      (vertices == 1
          ? " vertex cell of the input is no part of the surface and stays with its point"
          : " vertex cells of the input are no part of the surface and stay with their "
            "points") +
      "; without them the file is smaller";
}

void ForgetFlatTriangles(std::vector<std::string>& warnings)
{
  const auto isOfThem = [](const std::string& warning)
  { return warning.find(" without area ") != std::string::npos; };
  warnings.erase(std::remove_if(warnings.begin(), warnings.end(), isOfThem), warnings.end());
}
}
