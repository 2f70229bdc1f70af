// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainText.h
 * @brief Names from files as text that terminals, tables and files of every format can hold.
 */
#ifndef BoneDecimate_Applications_PlainText_h
#define BoneDecimate_Applications_PlainText_h

#include <cstddef>
#include <string>
#include <string_view>

namespace bonedecimate
{
/**
 * The bytes of the character at the beginning, if it is valid UTF-8 and neither a control character
 * nor one that changes the direction of text; 0 otherwise. Allocates nothing.
 */
std::size_t LengthOfPlainCharacter(std::string_view text);

/// Valid UTF-8 in which each other byte is a question mark.
std::string PlainText(std::string_view text);

/// The code points of that text.
std::size_t NumberOfCharacters(std::string_view text);
}

#endif
