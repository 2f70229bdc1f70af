// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamedLabels.h"

#include "PlainText.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bonedecimate
{
namespace
{
constexpr const char* ValuesName = "LabelValues";
constexpr const char* NamesName = "LabelNames";
constexpr const char* ColorsName = "LabelColors";

constexpr std::array<LabelColor, 8> Palette = { { { 222, 196, 152 }, { 128, 174, 201 },
  { 174, 196, 122 }, { 211, 138, 118 }, { 160, 146, 198 }, { 226, 178, 92 }, { 120, 184, 162 },
  { 206, 150, 178 } } };

std::int64_t ValueAt(vtkDataArray* values, vtkIdType row)
{
  if (auto* exact = vtkAOSDataArrayTemplate<long long>::FastDownCast(values))
  {
    return exact->GetTypedComponent(row, 0);
  }
  if (auto* exact = vtkAOSDataArrayTemplate<long>::FastDownCast(values))
  {
    return exact->GetTypedComponent(row, 0);
  }
  return static_cast<std::int64_t>(values->GetComponent(row, 0));
}

/// Bytes, or numbers from 0 to 1.
LabelColor ColorAt(vtkDataArray* colors, vtkIdType row, double scale)
{
  LabelColor color;
  for (std::size_t i = 0; i < color.size(); ++i)
  {
    const double value = scale * colors->GetComponent(row, static_cast<int>(i));
    color[i] = static_cast<unsigned char>(
      std::lround(std::isfinite(value) ? std::clamp(value, 0.0, 255.0) : 0.0));
  }
  return color;
}

double ScaleOf(vtkDataArray* colors)
{
  double largest = 0.0;
  for (int i = 0; i < colors->GetNumberOfComponents(); ++i)
  {
    largest = std::max(largest, colors->GetRange(i)[1]);
  }
  const bool isReal = colors->GetDataType() == VTK_FLOAT || colors->GetDataType() == VTK_DOUBLE;
  return isReal && largest <= 1.0 ? 255.0 : 1.0;
}
}

std::vector<NamedLabel> ReadNamedLabels(vtkFieldData* fields)
{
  vtkDataArray* const values = fields->GetArray(ValuesName);
  auto* const names = vtkStringArray::SafeDownCast(fields->GetAbstractArray(NamesName));
  vtkDataArray* const colors = fields->GetArray(ColorsName);
  std::vector<NamedLabel> labels(
    static_cast<std::size_t>(values ? values->GetNumberOfTuples() : 0));
  const bool hasNames =
    values && names && names->GetNumberOfValues() == values->GetNumberOfTuples();
  const bool hasColors = values && colors && colors->GetNumberOfComponents() >= 3 &&
    colors->GetNumberOfTuples() == values->GetNumberOfTuples();
  const double scale = hasColors ? ScaleOf(colors) : 0.0;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    labels[i].Value = ValueAt(values, row);
    labels[i].Name = hasNames ? PlainText(names->GetValue(row)) : std::string();
    const LabelColor color = hasColors ? ColorAt(colors, row, scale) : LabelColor{};
    if (color != LabelColor{}) // black: the row of a label without a color
    {
      labels[i].Color = color;
    }
  }
  return labels;
}

void WriteNamedLabels(const std::vector<NamedLabel>& labels, vtkFieldData* fields)
{
  vtkNew<vtkTypeInt64Array> values;
  vtkNew<vtkStringArray> names;
  vtkNew<vtkUnsignedCharArray> colors;
  values->SetName(ValuesName);
  names->SetName(NamesName);
  colors->SetName(ColorsName);
  colors->SetNumberOfComponents(3);
  bool hasColors = false;
  for (const NamedLabel& label : labels)
  {
    values->InsertNextValue(label.Value);
    names->InsertNextValue(PlainText(label.Name));
    colors->InsertNextTypedTuple(label.Color.value_or(LabelColor{}).data());
    hasColors = hasColors || label.Color;
  }
  fields->RemoveArray(ColorsName);
  fields->AddArray(values);
  fields->AddArray(names);
  if (hasColors)
  {
    fields->AddArray(colors);
  }
}

std::vector<NamedLabel> LabelsOf(vtkPolyData* surface)
{
  std::vector<NamedLabel> labels = ReadNamedLabels(surface->GetFieldData());
  if (!labels.empty())
  {
    labels.pop_back();
  }
  return labels;
}

std::string LabelText(const NamedLabel& label)
{
  const std::string number = std::to_string(label.Value);
  return label.Name.empty() ? number : number + " (" + label.Name + ")";
}

vtkSmartPointer<vtkUnsignedCharArray> ColorsOfTriangles(
  vtkPolyData* surface, const std::vector<NamedLabel>& labels)
{
  vtkDataArray* const pairs = surface->GetCellData()->GetArray(LabelsOfSidesName);
  std::map<std::int64_t, LabelColor> known;
  for (const NamedLabel& label : labels)
  {
    if (label.Color)
    {
      known[label.Value] = *label.Color;
    }
  }
  if (!pairs || known.empty())
  {
    return nullptr;
  }
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName(ColorArray);
  colors->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < pairs->GetNumberOfTuples(); ++cell)
  {
    const auto found = known.find(ValueAt(pairs, cell));
    colors->InsertNextTypedTuple((found == known.end() ? Palette[0] : found->second).data());
  }
  return colors;
}

std::vector<NamedLabel> WithColors(std::vector<NamedLabel> labels)
{
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    labels[i].Color = labels[i].Color.value_or(Palette[i % Palette.size()]);
  }
  return labels;
}
}
