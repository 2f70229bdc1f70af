// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EnclosedLabel.h"

#include "Base/Text.h"

#include <algorithm>

namespace bonedecimate
{
EnclosedLabel FindEnclosedLabel(
  const std::vector<std::int64_t>& values, std::int64_t requested, std::int64_t background)
{
  std::vector<std::int64_t> labels = values;
  labels.erase(std::remove(labels.begin(), labels.end(), background), labels.end());
  if (requested != background)
  {
    const bool isThere = std::find(labels.begin(), labels.end(), requested) != labels.end();
    return { requested,
      isThere ? std::string()
              : "the label map has no voxel with the label " + std::to_string(requested) };
  }
  if (labels.empty())
  {
    return { background, "the label map has no label beside the background" };
  }
  return { labels.front(),
    labels.size() == 1 ? std::string()
                       : "the label map has the labels " + ListText(labels) +
        ", and the surface does not say which of them it encloses: set Label" };
}
}
