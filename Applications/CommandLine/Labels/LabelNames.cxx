// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels/LabelNames.h"

#include "Files/FileNames.h"
#include "Formats/FileChecks.h"
#include "Labels/LabelTableSearch.h"
#include "PlainText.h"
#include "Segments/TotalSegmentator.h"

#include <algorithm>
#include <map>

namespace bonedecimate
{
namespace
{
bool HasNames(const LabelTable& table)
{
  return std::any_of(table.Labels.begin(), table.Labels.end(),
    [](const NamedLabel& label) { return !IsGenericName(label.Name); });
}

const NamedLabel* FindIn(const LabelTable& table, std::int64_t label)
{
  const auto found = std::find_if(table.Labels.begin(), table.Labels.end(),
    [label](const NamedLabel& one) { return one.Value == label; });
  return found == table.Labels.end() ? nullptr : &*found;
}

/// Names and colors that the header lacks.
void Complete(LabelTable& known, const LabelTable& more)
{
  std::map<std::int64_t, NamedLabel> labels;
  for (const NamedLabel& label : known.Labels)
  {
    labels.emplace(label.Value, label);
  }
  for (const NamedLabel& label : more.Labels)
  {
    NamedLabel& found = labels.emplace(label.Value, label).first->second;
    found.Name = IsGenericName(found.Name) && !label.Name.empty() ? label.Name : found.Name;
    found.Color = found.Color ? found.Color : label.Color;
  }
  known.Labels.clear();
  for (const auto& [value, label] : labels)
  {
    known.Labels.push_back(label);
  }
  known.Regions.insert(more.Regions.begin(), more.Regions.end());
}

/// Takes the names in the header of the map itself.
void TakeHeader(const std::string& path, vtkFieldData* fields, LabelNames& names)
{
  names.Table.Labels = ReadNamedLabels(fields);
  names.AreSegments = !names.Table.Labels.empty();
  if (names.AreSegments)
  {
    return;
  }
  names.Table = ReadLabelsOfHeader(path);
  if (!names.Table.Problem.empty())
  {
    names.Warnings.push_back(
      "no names are taken from the table of labels in its header: " + names.Table.Problem);
    names.Table = LabelTable();
  }
}

void RequireAgreement(const std::string& path, const LabelTable& header,
  const SegmentArguments& arguments, const LabelTable& given)
{
  const std::string name = arguments.HasTotalSegmentatorNames()
    ? "the table of TotalSegmentator"
    : PlainText(BaseName(arguments.LabelNames));
  const std::string contradiction =
    ContradictionOf(header.Labels, "its header", given.Labels, name);
  if (!contradiction.empty())
  {
    Reject(path,
      contradiction +
        ": --label-names contradicts the label map; leave it out to take the names "
        "of the header");
  }
}
}

LabelTable TableOfArguments(const SegmentArguments& arguments)
{
  LabelTable table;
  if (arguments.HasTotalSegmentatorNames())
  {
    for (const auto& [label, name] : TotalSegmentatorBones())
    {
      table.Labels.push_back({ label, name, {} });
    }
  }
  else if (!arguments.LabelNames.empty())
  {
    table = ReadLabelTable(arguments.LabelNames);
    if (table.Problem.empty() && table.IsEmpty())
    {
      table.Problem =
        std::string("it names no label; a table of labels is ") + LabelTableExtensions;
    }
    if (!table.Problem.empty())
    {
      Reject(arguments.LabelNames, table.Problem);
    }
  }
  return table;
}

const NamedLabel* LabelNames::Find(std::int64_t label) const
{
  return FindIn(this->Table, label);
}

LabelNames FindLabelNames(
  const std::string& path, vtkFieldData* fields, const SegmentArguments& arguments)
{
  LabelNames names;
  TakeHeader(path, fields, names);
  const bool isNamed = HasNames(names.Table);
  if (isNamed && !names.AreSegments)
  {
    names.Note = "names of labels are those of the table in its header";
  }
  if (!arguments.LabelNames.empty())
  {
    const LabelTable given = TableOfArguments(arguments);
    RequireAgreement(path, names.Table, arguments, given);
    Complete(names.Table, given);
  }
  else if (!isNamed)
  {
    const FoundTable beside = FindTableBeside(path);
    Complete(names.Table, beside.Table);
    if (!beside.Path.empty())
    {
      names.Note = "names of labels are those of " + PlainText(BaseName(beside.Path)) +
        " beside the label map";
    }
    if (!beside.Warning.empty())
    {
      names.Warnings.push_back(beside.Warning);
    }
  }
  return names;
}

std::string NameOfSegment(
  std::int64_t label, const std::string& nameInFile, const LabelTable& table)
{
  const NamedLabel* const named = FindIn(table, label);
  return IsGenericName(nameInFile) && named && !named->Name.empty() ? named->Name : nameInFile;
}
}
