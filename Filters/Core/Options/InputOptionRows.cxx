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
      "Remove components whose bounding box has no side of at least this length. The report lists "
      "them; errors and proofs refer to the remaining surface. 0: off." },
    { "PruneArea", &Options::PruneArea, 0, LargestNumber, "mm2", "prune-area", {},
      "Remove components with a smaller area. 0: off." },
    { "PruneVolume", &Options::PruneVolume, 0, LargestNumber, "mm3", "prune-volume", {},
      "Remove closed components with a smaller volume; open components stay. 0: off." },
    { "PruneTriangles", &Options::PruneTriangles, 0, largestInteger, "triangles", "prune-triangles",
      {}, "Remove components with fewer triangles. 0: off." },
    { "TunnelSize", &Options::TunnelSize, 0, LargestNumber, "mm", "close-tunnels", {},
      "Close tunnels of at most this diameter before anything else: handles of the surface around "
      "an opening whose shortest closed loop of edges is no longer than that of a circle of this "
      "diameter. Bone around which such a loop runs is never cut. The report lists them; errors "
      "and proofs refer to the surface with its tunnels closed. 0: off." },
    { "DiagnoseInput", &Options::DiagnoseInput, 0, 1, "", "diagnose", {},
      "Add diagnostics of the input to the report: kinds, counts and first ids." },
  };
}
}
