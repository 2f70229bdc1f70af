// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Written by hand because the core depends on no library but Eigen.
#include "ReportJson.h"

#include "Options/NumberRange.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bonedecimate
{
namespace
{
/// An entry, or the entries whose names begin with the same words.
struct Node
{
  std::string Name;
  const ReportEntry* Entry = nullptr;
  std::vector<Node> Children;
};

/// The child of that name, which is added if there is none.
Node& Child(Node& parent, const std::string& name)
{
  const auto isIt = [&](const Node& node) { return node.Name == name; };
  const auto found = std::find_if(parent.Children.rbegin(), parent.Children.rend(), isIt);
  return found != parent.Children.rend() ? *found
                                         : parent.Children.emplace_back(Node{ name, nullptr, {} });
}

Node Nested(const std::vector<ReportEntry>& entries)
{
  Node root;
  for (const ReportEntry& entry : entries)
  {
    Node* node = &root;
    std::size_t begin = 0;
    while (begin != std::string::npos)
    {
      const std::size_t dot = entry.Name.find('.', begin);
      node = &Child(*node, entry.Name.substr(begin, dot - begin));
      begin = dot == std::string::npos ? dot : dot + 1;
    }
    node->Entry = &entry;
  }
  return root;
}

/// Length of the UTF-8 character at a position; 0 if there is none.
std::size_t CharacterLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80 ? 1
    : first >= 0xc2 && first < 0xe0       ? 2
    : first >= 0xe0 && first < 0xf0       ? 3
    : first >= 0xf0 && first < 0xf5       ? 4
                                          : 0;
  if (length == 0 || at + length > text.size())
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(at + i) & 0xc0U) != 0x80U)
    {
      return 0;
    }
  }
  // Overlong forms, surrogates, and what is beyond the last character.
  const unsigned char second = length > 1 ? byte(at + 1) : 0;
  const bool isWrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
    (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
  return isWrong ? 0 : length;
}

std::string Quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t length = CharacterLength(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (length == 0)
    {
      quoted += "\\ufffd";
    }
    else if (byte < 0x20)
    {
      char escaped[8];
      std::snprintf(escaped, sizeof(escaped), "\\u%04x", static_cast<unsigned int>(byte));
      quoted += escaped;
    }
    else
    {
      quoted += byte == '"' || byte == '\\' ? "\\" : "";
      quoted += text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
  return quoted + "\"";
}

/// A real number keeps its point, so that readers do not take it for a whole one.
std::string RealText(double value)
{
  if (!std::isfinite(value))
  {
    return "null";
  }
  const std::string text = NumberText(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string ValueText(const ReportValue& value)
{
  if (const auto* text = std::get_if<std::string>(&value))
  {
    return Quoted(*text);
  }
  const auto* whole = std::get_if<std::int64_t>(&value);
  return whole ? std::to_string(*whole) : RealText(std::get<double>(value));
}

std::string NodeText(const Node& node)
{
  if (node.Entry)
  {
    return ValueText(node.Entry->Value);
  }
  const bool isList = !node.Children.empty() && node.Children.front().Name == "0";
  std::string text = isList ? "[" : "{";
  for (const Node& child : node.Children)
  {
    text += &child == &node.Children.front() ? "" : ", ";
    text += (isList ? std::string() : Quoted(child.Name) + ": ") + NodeText(child);
  }
  return text + (isList ? "]" : "}");
}
}

std::string ReportJson(const std::vector<ReportEntry>& entries)
{
  std::vector<ReportEntry> units; // by whole names, which are not nested
  Node root = Nested(entries);
  Node& node = root.Children.emplace_back(Node{ "units", nullptr, {} });
  for (const ReportEntry& entry : entries)
  {
    if (!entry.Unit.empty())
    {
      units.push_back({ entry.Name, "", entry.Unit });
    }
  }
  for (const ReportEntry& unit : units)
  {
    node.Children.push_back({ unit.Name, &unit, {} });
  }
  return NodeText(root);
}
}
