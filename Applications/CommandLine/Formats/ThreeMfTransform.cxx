// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Text.h"
#include "LineReader.h"
#include "ThreeMfModel.h"

namespace bonedecimate
{
std::optional<ThreeMfTransform> ThreeMfTransform::FromText(std::string_view text)
{
  std::vector<std::string_view> words;
  SplitWords(text, words);
  ThreeMfTransform transform;
  if (words.empty())
  {
    return transform;
  }
  for (std::size_t i = 0; i < transform.Rows.size(); ++i)
  {
    const std::optional<double> number =
      i < words.size() ? ParseNumber<double>(words[i]) : std::nullopt;
    if (!number || words.size() != transform.Rows.size())
    {
      return {};
    }
    transform.Rows[i] = *number;
  }
  return transform;
}

std::array<double, 3> ThreeMfTransform::Of(const std::array<double, 3>& point) const
{
  std::array<double, 3> moved = {};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    moved[axis] = point[0] * this->Rows[axis] + point[1] * this->Rows[3 + axis] +
      point[2] * this->Rows[6 + axis] + this->Rows[9 + axis];
  }
  return moved;
}

double ThreeMfTransform::Determinant() const
{
  const std::array<double, 12>& m = this->Rows;
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
    m[2] * (m[3] * m[7] - m[4] * m[6]);
}
}
