// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Replay.cxx
 * @brief Runs a harness on a corpus without a fuzzer: a text with one input a line, its bytes in
 * hexadecimal.
 */
#include "Bytes.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace
{
std::vector<std::uint8_t> BytesOf(const std::string& line)
{
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < line.size(); i += 2)
  {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(line.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}
}

int main(int argumentCount, char** words)
{
  int inputs = 0;
  for (int i = 1; i < argumentCount; ++i)
  {
    std::ifstream corpus(words[i]);
    for (std::string line; std::getline(corpus, line); ++inputs)
    {
      const std::vector<std::uint8_t> bytes = BytesOf(line);
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
  }
  std::printf("%d inputs\n", inputs);
  return inputs > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
