// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearestWord.h"

#include "Base/Text.h"

#include <algorithm>
#include <iterator>
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

/// Whether the part begins the name or one of its words between dashes.
bool HasPart(const std::string& name, const std::string& part)
{
  constexpr std::size_t shortest = 3;
  const std::size_t at = name.find(part);
  return part.size() >= shortest && at != std::string::npos && (at == 0 || name[at - 1] == '-');
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

std::vector<std::string> SimilarNames(
  const std::string& name, const std::vector<std::string>& known)
{
  constexpr std::size_t most = 3;
  const std::string nearest = NearestWord(name, known);
  if (!nearest.empty())
  {
    return { nearest };
  }
  const std::string lower = LowerCase(name);
  std::vector<std::string> similar;
  std::copy_if(known.begin(), known.end(), std::back_inserter(similar),
    [&lower](const std::string& other) { return HasPart(other, lower) || HasPart(lower, other); });
  similar.resize(std::min(similar.size(), most));
  return similar;
}
}
