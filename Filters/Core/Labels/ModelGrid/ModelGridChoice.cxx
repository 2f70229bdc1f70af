// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelGridChoice.h"

#include "Base/Text.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
namespace
{
/// At most three decimals, without trailing zeros.
std::string LengthText(double length)
{
  const std::int64_t thousandths = std::llround(length * 1000.0);
  std::string text = std::to_string(thousandths % 1000 + 1000).replace(0, 1, ".");
  text.erase(text.find_last_not_of('0') + 1);
  return std::to_string(thousandths / 1000) + (text == "." ? "" : text);
}
}

ModelGridChoice ReadModelGridChoice(const std::string& text)
{
  ModelGridChoice choice;
  const std::string word = LowerCase(text);
  if (word == "off")
  {
    return choice;
  }
  choice.Request.emplace();
  if (word == "auto")
  {
    return choice;
  }
  std::vector<double> lengths;
  for (const std::string& part : SplitAt(text, ','))
  {
    lengths.push_back(ParseFinite(part).value_or(0.0));
    if (!(lengths.back() > 0.0))
    {
      lengths.clear();
      break;
    }
  }
  if (lengths.size() != 1 && lengths.size() != 3)
  {
    choice.Problem = "takes auto, off, or one or three positive lengths in mm, not '" + text + "'";
    return choice;
  }
  choice.Request->Spacing = Vector3(lengths[0], lengths[lengths.size() / 2], lengths.back());
  return choice;
}

std::string SpacingText(const VoxelGrid& grid)
{
  return LengthText(grid.Spacing[0]) + " x " + LengthText(grid.Spacing[1]) + " x " +
    LengthText(grid.Spacing[2]);
}

std::string ModelGridSentence(const ModelGrid& found)
{
  return "the label map is a copy of one with voxels of " + SpacingText(found.Grid) +
    " mm, as networks make them; the surface is that of their voxels" +
    (found.Different == 0
        ? std::string()
        : "; " + std::to_string(found.Different) + " voxels of the file were changed afterwards");
}
}
