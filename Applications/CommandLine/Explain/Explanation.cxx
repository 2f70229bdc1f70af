// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Explain/Explanation.h"

#include <iomanip>
#include <iostream>
#include <sstream>

namespace bonedecimate
{
void Explanation::Print() const
{
  constexpr int width = 12;
  std::string before;
  for (const auto& [heading, text] : this->Lines)
  {
    std::cout << std::left << std::setw(width) << (heading == before ? "" : heading) << text
              << "\n";
    before = heading;
  }
}

std::string LengthText(double millimeters)
{
  std::ostringstream text;
  text << std::setprecision(6) << millimeters << " mm";
  return text.str();
}
}
