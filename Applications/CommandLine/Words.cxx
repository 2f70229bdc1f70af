// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Words.h"

#include "ExitCode.h"
#include "SurfaceFormat.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <system_error>

namespace bonedecimate
{
namespace
{
constexpr const char* Commands[] = { "certify", "check", "curve", "levels", "thesis", "tolerance" };

/// Letters to insert, remove or replace: V. Levenshtein, 1966.
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ replaced, row[j] + 1, diagonal + 1 });
    }
  }
  return row.back();
}
}

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

void RequireCommandOrFile(const std::string& word)
{
  constexpr std::size_t mostEdits = 2;
  std::error_code error;
  const bool isFileName = word.find_first_of("./") != std::string::npos;
  if (word.empty() || word[0] == '-' || isFileName || std::filesystem::exists(word, error))
  {
    return;
  }
  std::string names;
  for (const std::string command : Commands)
  {
    names.append(names.empty() ? "" : ", ").append(command);
    if (EditDistance(LowerText(word), command) <= mostEdits)
    {
      throw Failure(ExitCode::Usage,
        std::string("'")
          .append(word)
          .append("' is neither a command nor a file; did you mean ")
          .append(command)
          .append("?"));
    }
  }
  throw Failure(
    ExitCode::Usage, "'" + word + "' is neither a command nor a file; the commands are " + names);
}
}
