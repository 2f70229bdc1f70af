// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputFigures.h"

#include <algorithm>

namespace bonedecimate
{
double MaxLabelChange(const std::vector<LabelArea>& labels)
{
  double largest = 0.0;
  for (const LabelArea& area : labels)
  {
    largest = std::max(largest, area.Change());
  }
  return largest;
}
}
