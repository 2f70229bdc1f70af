// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StlColors.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace bonedecimate
{
StlColors::StlColors(std::string_view header)
{
  constexpr std::string_view key = "COLOR=";
  const std::size_t at = header.find(key);
  this->IsMagics = at != std::string_view::npos && at + key.size() + 4 <= header.size();
  if (this->IsMagics)
  {
    std::copy_n(
      header.begin() + static_cast<std::ptrdiff_t>(at + key.size()), 3, this->OfAll.begin());
  }
}

StlColors::Color StlColors::ColorOf(std::uint16_t attribute) const
{
  const bool hasOwn = this->IsMagics == ((attribute & Flag) == 0);
  if (!hasOwn)
  {
    return this->OfAll;
  }
  const auto channel = [attribute](int shift)
  {
    const int bits = attribute >> shift & 31;
    return static_cast<unsigned char>((bits * 255 + 15) / 31);
  };
  return this->IsMagics ? Color{ channel(0), channel(5), channel(10) }
                        : Color{ channel(10), channel(5), channel(0) };
}

void StlColors::AddTo(vtkPolyData* surface, std::vector<std::string>& warnings) const
{
  if (!this->IsMagics && !this->HasColors)
  {
    if (this->HasValues)
    {
      warnings.emplace_back(
        "the attributes of triangles in the input are no colors and are not read");
    }
    return;
  }
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("RGB");
  array->SetNumberOfComponents(3);
  for (const std::uint16_t attribute : this->Attributes)
  {
    array->InsertNextTypedTuple(this->ColorOf(attribute).data());
  }
  surface->GetCellData()->SetScalars(array);
}
}
