// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoveringList.h"

#include <numeric>

namespace bonedecimate
{
CoveringList::CoveringList(Index originals)
  : FacesOrPositions(static_cast<std::size_t>(originals))
{
  std::iota(this->FacesOrPositions.begin(), this->FacesOrPositions.end(), 0);
}

//------------------------------------------------------------------------------
Covering CoveringList::Of(std::size_t original) const
{
  const Index number = this->FacesOrPositions[original];
  if (number < None)
  {
    return this->CoveringsBySeveral[PositionOf(number)];
  }
  Covering covering;
  covering.Faces[0] = number;
  covering.Count = 1;
  return covering;
}

//------------------------------------------------------------------------------
/// A covering that is replaced by a single face leaves its position unused.
void CoveringList::Set(std::size_t original, const Covering& covering)
{
  Index& number = this->FacesOrPositions[original];
  if (covering.IsOneFace())
  {
    number = covering.Faces[0];
    return;
  }
  if (number > None)
  {
    number = None - 1 - static_cast<Index>(this->CoveringsBySeveral.size());
    this->CoveringsBySeveral.emplace_back();
  }
  this->CoveringsBySeveral[PositionOf(number)] = covering;
}

//------------------------------------------------------------------------------
Coverage CoveringList::ToCoverage(Index coverings) const
{
  Coverage coverage(static_cast<Index>(this->Count()), coverings);
  for (std::size_t original = 0; original < this->Count(); ++original)
  {
    const Covering covering = this->Of(original);
    for (int i = 0; i < covering.Count; ++i)
    {
      coverage.Add(static_cast<Index>(original), covering.Faces[static_cast<std::size_t>(i)]);
    }
  }
  return coverage;
}
}
