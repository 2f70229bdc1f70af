// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputHints.h"

#include "NumberText.h"

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

/// Bones of one unit hardly differ that much in size; mm, cm, inches and m do.
void WarnOfUnits(vtkPolyData* reference, vtkPolyData* result, std::vector<std::string>& warnings)
{
  constexpr double most = 9.0;
  const double before = reference->GetLength();
  const double after = result->GetLength();
  if (before > 0.0 && after > 0.0 && std::max(before / after, after / before) >= most)
  {
    warnings.push_back("the diagonal of RESULT is " + ShortText(after / before) +
      " times that of REFERENCE: the files may have different units (--unit is that of both)");
  }
}
}
