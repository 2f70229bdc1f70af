// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Explanation.h
 * @brief Lines of --explain: a heading, and what belongs to it.
 */
#ifndef BoneDecimate_Applications_Explanation_h
#define BoneDecimate_Applications_Explanation_h

#include <string>
#include <utility>
#include <vector>

namespace bonedecimate
{
class Explanation
{
public:
  /// A line; lines of one heading in a row show it once.
  void Add(const std::string& heading, const std::string& text)
  {
    this->Lines.emplace_back(heading, text);
  }

  void Print() const;

private:
  std::vector<std::pair<std::string, std::string>> Lines;
};

/// "0.25 mm"
std::string LengthText(double millimeters);
}

#endif
