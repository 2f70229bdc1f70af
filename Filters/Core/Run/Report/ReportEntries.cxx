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
}
