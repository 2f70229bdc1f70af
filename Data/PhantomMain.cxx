// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PhantomMain.cxx
 * @brief bonedecimate-phantom: writes a synthetic CT of a broken leg, a label map of its bones, or
 * a micro-CT of trabecular bone.
 */
#include "PhantomScan.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace
{
using namespace phantom;

enum ExitCode
{
  Done = 0,
  Usage = 1,
  CouldNotWrite = 3
};

/// A cube; no size if the text is not a number of voxels along an axis.
Scan TrabecularScan(const std::string& text)
{
  constexpr int most = 8192;
  const bool isNumber = !text.empty() && text.size() <= 4 &&
    std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int size = isNumber ? std::stoi(text) : 0;
  return { size >= 2 && size <= most ? std::array<int, 3>{ { size, size, size } }
                                     : std::array<int, 3>{ { 0, 0, 0 } },
    { 0.005, 0.005, 0.005 }, { 0.0, 0.0, 0.0 }, 3 };
}

/// Takes a flag out of the words.
bool Take(std::vector<std::string>& words, const std::string& flag)
{
  const auto found = std::find(words.begin(), words.end(), flag);
  const bool isThere = found != words.end();
  if (isThere)
  {
    words.erase(found);
  }
  return isThere;
}
}

int main(int argumentCount, char** arguments)
{
  std::vector<std::string> words(arguments + 1, arguments + argumentCount);
  const bool hasLabels = Take(words, "--labels");
  const bool isTrabecular = words.size() == 3 && words[1] == "--trabeculae" && !hasLabels;
  const bool isSized = words.size() == 3 && words[1] == "--size";
  const Scan cube = TrabecularScan(isTrabecular ? words[2] : "");
  const Scan* const leg = FindScan(isSized ? words[2] : "normal");
  const Scan* const scan = !isTrabecular ? leg : cube.Size[0] > 0 ? &cube : nullptr;
  const bool isUnderstood = (words.size() == 1 || isSized || isTrabecular) && scan != nullptr;
  if (!isUnderstood || words[0].empty() || words[0][0] == '-')
  {
    std::fputs("Usage: bonedecimate-phantom OUTPUT.mha [--size small|normal|large] [--labels]\n"
               "       bonedecimate-phantom OUTPUT.mha --trabeculae VOXELS\n",
      stderr);
    return Usage;
  }
  const Content content = isTrabecular ? Content::Trabeculae
    : hasLabels                        ? Content::Labels
                                       : Content::Intensities;
  if (!WriteScan(words[0], *scan, content))
  {
    std::fprintf(stderr, "%s could not be written.\n", words[0].c_str());
    return CouldNotWrite;
  }
  return Done;
}
