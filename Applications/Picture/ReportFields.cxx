// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportFields.h"

#include "NamedLabels.h"
#include "ReportOfSurface.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

/// Calls visit(name, value) for each value, with its name of words and dots.
template <typename Visit>
void VisitValues(const std::string& path, const Json& json, const Visit& visit)
{
  if (!json.is_structured())
  {
    visit(path, json);
    return;
  }
  for (const auto& item : json.items())
  {
    VisitValues(path.empty() ? item.key() : path + "." + item.key(), item.value(), visit);
  }
}

/// Whole numbers without a point.
std::string TextOf(const Json& value)
{
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  const bool isWhole = text.size() > 2 && text.compare(text.size() - 2, 2, ".0") == 0;
  return value.is_number_float() && isWhole ? text.substr(0, text.size() - 2) : text;
}
}

ReportFields::ReportFields(vtkPolyData* result)
  : ReportFields(ReportOf(result).dump())
{
  if (result)
  {
    this->AddLabelMap(result);
  }
}

void ReportFields::AddLabelMap(vtkPolyData* result)
{
  for (const NamedLabel& label : LabelsOf(result))
  {
    if (!label.Name.empty())
    {
      this->Fields.push_back({ "label_names." + std::to_string(label.Value), {}, label.Name });
    }
  }
  vtkDataArray* const spacing = result->GetFieldData()->GetArray("VoxelGridSpacing");
  if (spacing && spacing->GetNumberOfComponents() == 3 && spacing->GetNumberOfTuples() == 1)
  {
    const double* const sides = spacing->GetTuple(0);
    const double least = std::min({ sides[0], sides[1], sides[2] });
    this->Fields.push_back({ "voxel_grid.smallest_spacing", least, std::to_string(least) });
  }
}

ReportFields::ReportFields(const std::string& json)
{
  Json report = Json::parse(json, nullptr, false);
  if (report.is_object())
  {
    report.erase("units");
    VisitValues("", report,
      [this](const std::string& name, const Json& value)
      {
        const auto number =
          value.is_number() ? std::optional<double>(value.get<double>()) : std::nullopt;
        this->Fields.push_back({ name, number, TextOf(value) });
      });
  }
}

const ReportFields::Field* ReportFields::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Fields.begin(), this->Fields.end(),
    [&](const Field& field) { return field.Name == name; });
  return found == this->Fields.end() ? nullptr : &*found;
}

std::optional<double> ReportFields::Number(const std::string& name) const
{
  const Field* field = this->Find(name);
  return field ? field->Number : std::nullopt;
}

std::string ReportFields::Text(const std::string& name) const
{
  const Field* field = this->Find(name);
  return field ? field->Text : std::string();
}

std::vector<std::string> ReportFields::NamesBelow(const std::string& beginning) const
{
  std::vector<std::string> names;
  for (const Field& field : this->Fields)
  {
    if (field.Name.compare(0, beginning.size(), beginning) == 0)
    {
      names.push_back(field.Name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::optional<double> CountBeforePruning(const ReportFields& report, const std::string& what)
{
  const std::optional<double> count = report.Number("input." + what);
  return count ? std::optional<double>(*count + report.Number("pruned." + what).value_or(0.0))
               : count;
}
}
