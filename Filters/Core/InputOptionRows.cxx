// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputOptionRows.h"

#include "NumberRange.h"

#include <limits>

namespace bonedecimate
{
std::vector<OptionInfo> InputOptionRows()
{
  constexpr double largestInteger = std::numeric_limits<int>::max();
  return {
    { "PruneSize", &Options::PruneSize, 0, LargestNumber, "mm", "prune-size", {},
      "Components whose box has no side as long as this are left out, and listed in the report; 0 "
      "leaves out none. Errors and proofs are about what is left." },
    { "PruneArea", &Options::PruneArea, 0, LargestNumber, "mm2", "prune-area", {},
      "The same for components of a smaller area." },
    { "PruneVolume", &Options::PruneVolume, 0, LargestNumber, "mm3", "prune-volume", {},
      "The same for closed components of a smaller volume; open ones have none, and stay." },
    { "PruneTriangles", &Options::PruneTriangles, 0, largestInteger, "triangles", "prune-triangles",
      {}, "The same for components of fewer triangles." },
    { "ExamineInput", &Options::ExamineInput, 0, 1, "", "examine", {},
      "Put into the report what is odd about the input, kind by kind, with counts and first ids." },
  };
}
}
