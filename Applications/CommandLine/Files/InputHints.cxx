// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputHints.h"

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
}
