// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MergeReports.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Entries of the same kind and noun are one; where its first one is, only the part knows.
void Join(const LeftOut& entry, std::vector<LeftOut>& all)
{
  const auto same = std::find_if(
    all.begin(), all.end(), [&](const LeftOut& other) { return other.Kind == entry.Kind; });
  if (same == all.end())
  {
    all.push_back(entry);
    return;
  }
  same->What = same->Count > 1 ? same->What : entry.What;
  same->Count += entry.Count;
  same->Where.clear();
}
}

void AddPart(const Report& part, Report& whole)
{
  whole.Edits.Add(part.Edits);
  whole.Seconds.AddStages(part.Seconds);
  whole.RunningError = std::max(whole.RunningError, part.RunningError); // stays not a number
  whole.OutputChecksum += part.OutputChecksum;
  for (const LeftOut& entry : part.LeftOut)
  {
    Join(entry, whole.LeftOut);
  }
}
}
