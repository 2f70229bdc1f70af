// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LeftOut.h"

#include "BoundText.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr int DecimalsOfDistance = 6;
}

std::string LeftOut::Position() const
{
  return this->FirstTriangle < 0 ? this->Where : "triangle " + std::to_string(this->FirstTriangle);
}

std::string LeftOut::Sentence() const
{
  std::string text = std::to_string(this->Count) + " " + this->What;
  if (const std::string position = this->Position(); !position.empty())
  {
    text += (this->Count == 1 ? " (" : " (the first is ") + position + ")";
  }
  if (!std::isnan(this->Distance))
  {
    text += ", up to " + UpperBoundText(this->Distance, DecimalsOfDistance) + " mm away";
  }
  return text;
}

std::string LeftOutClause(const std::vector<LeftOut>& leftOut, double proved)
{
  std::string clause;
  for (const LeftOut& entry : leftOut)
  {
    if (!(entry.Distance <= proved)) // or not known
    {
      clause += (clause.empty() ? "but for " : "; and for ") + entry.Sentence();
    }
  }
  return clause;
}
}
