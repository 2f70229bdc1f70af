// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeprecatedNames.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

struct RenamedWord
{
  const char* Old;
  const char* Current;
};

constexpr RenamedWord Flags[] = {
  { "--target-faces", "--target-triangles" },
  { "--keep-clearance", "--intersection-guard" },
  { "--examine", "--diagnose" },
  { "--no-borders", "--no-boundaries" },
};

/// First words of the command line.
constexpr RenamedWord Commands[] = { { "check", "diagnose" } };

struct RenamedKey
{
  const char* Old;
  const char* Current;
  const char* Parent = nullptr; ///< The key of the object that holds it; null: any.
};

constexpr RenamedKey Keys[] = {
  { "faces", "triangles" },
  { "faces_read", "triangles_read" },
  { "locked_points", "non_manifold_points" },
  { "first_locked_point", "first_non_manifold_point" },
  { "frozen_points", "constrained_points" },
  { "verdict", "status" },
  { "borders", "boundaries" },
  { "border_output_to_input", "boundary_output_to_input" },
  { "border_input_to_output", "boundary_input_to_output" },
  { "border_reference_to_result", "boundary_reference_to_result" },
  { "border_result_to_reference", "boundary_result_to_reference" },
  { "border", "boundary", "rejections" },
  { "too_far", "error_bound", "rejections" },
  { "frozen", "constrained", "rejections" },
  { "crossing", "intersection", "rejections" },
  { "refusals", "rejections" },
  { "findings", "diagnostics" },
  { "place", "center" },
  { "clearance", "fragment_gap" },
  { "KeepClearance", "IntersectionGuard" },
  { "ExamineInput", "DiagnoseInput" },
};

/// Replaces the beginning of a word up to its end or an equals sign.
template <std::size_t Count>
void Replace(const RenamedWord (&table)[Count], std::string& word)
{
  const std::string name = word.substr(0, word.find('='));
  const auto* found = std::find_if(std::begin(table), std::end(table),
    [&name](const RenamedWord& renamed) { return name == renamed.Old; });
  if (found != std::end(table))
  {
    word.replace(0, name.size(), found->Current);
    std::fprintf(stderr,
      "bonedecimate: %s is deprecated and will be removed in the next release; use %s\n",
      found->Old, found->Current);
  }
}

/// @param used Gets the keys that were added, each with its current name.
void AddKeys(Json& node, const std::string& parent, Json& used)
{
  for (auto& [key, child] : node.items())
  {
    if (child.is_structured())
    {
      AddKeys(child, key, used);
    }
  }
  for (const RenamedKey& renamed : Keys)
  {
    const bool isHere = renamed.Parent == nullptr || parent == renamed.Parent;
    if (isHere && node.is_object() && node.contains(renamed.Current))
    {
      const Json value = node[renamed.Current];
      node[renamed.Old] = value;
      used[renamed.Old] = renamed.Current;
    }
  }
}
}

std::vector<std::string> WithCurrentNames(std::vector<std::string> words)
{
  if (!words.empty())
  {
    Replace(Commands, words.front());
  }
  const auto flagsEnd = std::find(words.begin(), words.end(), "--");
  std::for_each(words.begin(), flagsEnd, [](std::string& word) { Replace(Flags, word); });
  return words;
}

void AddDeprecatedKeys(nlohmann::ordered_json& report)
{
  Json used = Json::object();
  AddKeys(report, "", used);
  if (!used.empty())
  {
    report["deprecated_keys"] = used;
  }
}
}
