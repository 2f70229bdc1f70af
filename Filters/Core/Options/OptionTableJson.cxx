// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Written by hand because the core depends on no library but Eigen.
#include "OptionTableJson.h"

#include "OptionTable.h"
#include "RunKinds.h"

#include <cstddef>
#include <vector>

namespace bonedecimate
{
namespace
{
std::string Quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += (c == '"' || c == '\\' ? std::string("\\") : std::string()) + c;
  }
  return quoted + "\"";
}

std::string TruthText(bool isTrue)
{
  return isTrue ? "true" : "false";
}

/// @param open,close "[" and "]", or "{" and "}".
std::string JoinedParts(
  const std::vector<std::string>& parts, const char* open, const char* close, const char* joint)
{
  std::string text = open;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += (i == 0 ? "" : joint) + parts[i];
  }
  return text + close;
}

std::string List(const std::vector<std::string>& parts)
{
  return JoinedParts(parts, "[", "]", ", ");
}

std::string Texts(const std::vector<std::string>& texts)
{
  std::vector<std::string> quoted;
  quoted.reserve(texts.size());
  for (const std::string& text : texts)
  {
    quoted.push_back(Quoted(text));
  }
  return List(quoted);
}

std::string Conditions(const OptionInfo& info)
{
  std::vector<std::string> lists;
  for (const NeedList& needs : info.Needs)
  {
    for (const Need need : needs)
    {
      const NeedInfo* row = FindNeed(need);
      for (std::size_t i = 0; row != nullptr && i < row->Panel.size(); ++i)
      {
        std::vector<std::string> terms;
        terms.reserve(row->Panel[i].size());
        for (const PanelTerm& term : row->Panel[i])
        {
          terms.push_back(
            List({ Quoted(term.Option), Quoted(term.Value), TruthText(term.HasValue) }));
        }
        lists.push_back(List(terms));
      }
    }
  }
  return List(lists);
}

std::string Unsupported(const OptionInfo& info)
{
  std::vector<std::string> reasons;
  for (const RunKind& kind : RunKindTable())
  {
    const std::string reason = WhyUnsupported(kind, info);
    if (!reason.empty())
    {
      reasons.push_back(Quoted(kind.Name) + ": " + Quoted(reason));
    }
  }
  return JoinedParts(reasons, "{", "}", ", ");
}

std::string KindWord(const OptionInfo& info)
{
  static const char* const kinds[] = { "bool", "int", "double", "text" };
  return info.Choices.empty() ? kinds[GetOption(Options(), info).index()] : "choice";
}

std::string GroupWord(PanelGroup group)
{
  static const char* const names[] = { "", "Targets", "Smoothing", "Proof", "Shape", "Input",
    "Output", "Names", "Thesis" };
  return names[static_cast<std::size_t>(group)];
}

std::string RowText(const OptionInfo& info)
{
  const std::vector<std::string> members = {
    "\"name\": " + Quoted(info.Name),
    "\"kind\": " + Quoted(KindWord(info)),
    "\"minimum\": " + SentenceNumber(info.Minimum),
    "\"maximum\": " + SentenceNumber(info.Maximum),
    "\"unit\": " + Quoted(info.Unit),
    "\"flag\": " + Quoted(info.Flag),
    "\"choices\": " + Texts(info.Choices),
    "\"default\": " + Quoted(OptionText(Options(), info)),
    "\"sentence\": " + Quoted(info.Sentence),
    "\"group\": " + Quoted(GroupWord(info.Group)),
    "\"names_point_array\": " + TruthText(info.IsPointArrayName),
    "\"conditions\": " + Conditions(info),
    "\"unsupported\": " + Unsupported(info),
  };
  return JoinedParts(members, "    {\n      ", "\n    }", ",\n      ");
}
}

std::string OptionTableJson()
{
  std::vector<std::string> rows;
  rows.reserve(OptionTable().size());
  for (const OptionInfo& info : OptionTable())
  {
    rows.push_back(RowText(info));
  }
  return "{\n  \"modes\": " + Texts(ModeNames()) +
    ",\n  \"options\": " + JoinedParts(rows, "[\n", "\n  ]", ",\n") + "\n}\n";
}
}
