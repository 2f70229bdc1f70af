// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportEntries.h"

namespace bonedecimate
{
void AddLeftOut(Entries& entries, const std::string& path, const std::vector<LeftOut>& leftOut)
{
  for (std::size_t i = 0; i < leftOut.size(); ++i)
  {
    const LeftOut& entry = leftOut[i];
    const std::string name = path + "." + std::to_string(i);
    entries.push_back({ name + ".kind", "", entry.Kind });
    entries.push_back({ name + ".count", "", entry.Count });
    entries.push_back({ name + ".what", "", entry.What });
    entries.push_back({ name + ".where", "", entry.Position() });
    AddIfKnown(entries, name + ".distance", "mm", entry.Distance);
    entries.push_back({ name + ".sentence", "", entry.Sentence() });
  }
}

void AddCounts(Entries& entries, const std::string& path, const SurfaceStatistics& surface)
{
  entries.push_back({ path + ".triangles", "", surface.Faces });
  entries.push_back({ path + ".points", "", surface.Points });
  entries.push_back({ path + ".components", "", surface.Components });
  entries.push_back({ path + ".boundary_edges", "", surface.BoundaryEdges });
  entries.push_back({ path + ".non_manifold_edges", "", surface.NonManifoldEdges });
  entries.push_back({ path + ".euler_number", "", surface.EulerNumber });
  entries.push_back({ path + ".area", "mm2", surface.Area });
  entries.push_back({ path + ".volume", "mm3", surface.Volume });
}
}
