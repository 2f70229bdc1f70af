// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearestWord.h"

#include "Options/Text.h"

#include <algorithm>
#include <numeric>

namespace bonedecimate
{
namespace
{
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

std::string NearestWord(const std::string& word, const std::vector<std::string>& known)
{
  std::size_t least = 3;
  std::string nearest;
  for (const std::string& other : known)
  {
    const std::size_t edits = EditDistance(LowerCase(word), LowerCase(other));
    if (edits < least)
    {
      least = edits;
      nearest = other;
    }
  }
  return nearest;
}
}
