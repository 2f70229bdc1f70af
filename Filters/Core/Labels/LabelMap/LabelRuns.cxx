// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelRuns.h"

#include "Base/DisjointSets.h"

#include <algorithm>

namespace bonedecimate
{
//------------------------------------------------------------------------------
LabelRuns::LabelRuns(const LabelImage& image, const LabelRanks& ranks)
  : Width(static_cast<std::size_t>(image.Grid.Dimensions[0]))
  , Height(static_cast<std::size_t>(image.Grid.Dimensions[1]))
  , Depth(static_cast<std::size_t>(image.Grid.Dimensions[2]))
  , Spacing(image.Grid.Spacing)
  , Shear(image.Grid.UnitArea(0), image.Grid.UnitArea(1), image.Grid.UnitArea(2))
{
  for (Index layer = 0; layer < image.Grid.Dimensions[2]; ++layer)
  {
    this->Thickness.push_back(image.Grid.ThicknessOf(layer, layer + 1));
  }
  std::vector<Index> row(this->Width);
  for (std::size_t number = 0; number < this->Height * this->Depth; ++number)
  {
    ranks.Convert(image, number * this->Width, this->Width, row.data());
    this->FirstOfRow.push_back(this->Runs.size());
    for (auto begin = row.cbegin(); begin != row.cend();)
    {
      const Index rank = *begin;
      const auto end =
        std::find_if(begin, row.cend(), [rank](Index other) { return other != rank; });
      this->Runs.push_back({ static_cast<Index>(begin - row.cbegin()),
        static_cast<Index>(end - row.cbegin()), rank, number });
      begin = end;
    }
  }
  this->FirstOfRow.push_back(this->Runs.size());
}

//------------------------------------------------------------------------------
std::vector<std::size_t> LabelRuns::JoinByFaces() const
{
  DisjointSets<std::size_t> sets(this->Runs.size());
  const auto join = [&](std::size_t a, std::size_t b)
  {
    if (this->Runs[a].Rank != 0 && this->Runs[a].Rank == this->Runs[b].Rank)
    {
      sets.Join(a, b);
    }
  };
  for (std::size_t row = 0; row < this->Height * this->Depth; ++row)
  {
    if (row % this->Height > 0)
    {
      this->VisitRows(row, row - 1, 0, join);
    }
    if (row >= this->Height)
    {
      this->VisitRows(row, row - this->Height, 0, join);
    }
  }
  return sets.TakeRoots();
}

//------------------------------------------------------------------------------
std::vector<std::size_t> LabelRuns::JoinByEdges() const
{
  DisjointSets<std::size_t> sets(this->Runs.size());
  const auto join = [&](std::size_t a, std::size_t b)
  {
    if (this->Runs[a].Rank == 0 && this->Runs[b].Rank == 0)
    {
      sets.Join(a, b);
    }
  };
  for (std::size_t row = 0; row < this->Height * this->Depth; ++row)
  {
    const std::size_t y = row % this->Height;
    if (y > 0)
    {
      this->VisitRows(row, row - 1, 1, join);
    }
    if (row < this->Height)
    {
      continue;
    }
    const std::size_t below = row - this->Height;
    for (std::size_t other = y > 0 ? below - 1 : below;
         other <= (y + 1 < this->Height ? below + 1 : below); ++other)
    {
      this->VisitRows(row, other, other == below ? 1 : 0, join);
    }
  }
  return sets.TakeRoots();
}
}
