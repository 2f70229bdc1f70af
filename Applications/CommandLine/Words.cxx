// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Words.h"

#include "ExitCode.h"

#include <iostream>

namespace bonedecimate
{
std::vector<std::string> WordsOf(int argc, char* argv[], int first)
{
  std::vector<std::string> words;
  for (int i = argc - 1; i >= first; --i)
  {
    const std::string word = argv[i];
    const bool isList = word.size() > 1 && word.front() == '[' && word.back() == ']';
    words.push_back(isList ? "./" + word : word);
  }
  return words;
}

bool ParseWords(CLI::App& app, std::vector<std::string> words)
{
  try
  {
    app.parse(std::move(words));
    return true;
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() != 0)
    {
      throw Failure(
        ExitCode::Usage, std::string(error.what()) + "; see " + app.get_name() + " --help");
    }
    app.exit(error, std::cout, std::cerr);
    return false;
  }
}
}
