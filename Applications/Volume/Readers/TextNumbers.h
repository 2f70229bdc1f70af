// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextNumbers.h
 * @brief Numbers in the text of headers.
 */
#ifndef BoneDecimate_Applications_TextNumbers_h
#define BoneDecimate_Applications_TextNumbers_h

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// The text without blanks, line ends and zeros at either end.
std::string Trimmed(const std::string& text);

/// Numbers between blanks, commas or backslashes; none if anything else is there.
std::optional<std::vector<double>> ParseNumbers(const std::string& text);

/// One whole number; none if anything else is there.
std::optional<std::int64_t> ParseWholeNumber(const std::string& text);
}

#endif
