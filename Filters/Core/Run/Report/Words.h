// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Words.h
 * @brief The word of a value of an enumeration.
 */
#ifndef BoneDecimate_Core_Run_Report_Words_h
#define BoneDecimate_Core_Run_Report_Words_h

#include <cstddef>

namespace bonedecimate
{
/// The word at the number of the value; "unknown" if there is none, so that a value without a word
/// cannot read beyond them.
template <typename Value, std::size_t Count>
const char* WordOf(const char* const (&words)[Count], Value value)
{
  const auto number = static_cast<std::size_t>(value);
  return number < Count ? words[number] : "unknown";
}
}

#endif
