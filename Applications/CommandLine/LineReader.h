// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LineReader.h
 * @brief Lines and words of text files, with the number of the line for messages.
 */
#ifndef BoneDecimate_Applications_LineReader_h
#define BoneDecimate_Applications_LineReader_h

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace bonedecimate
{
class LineReader
{
public:
  explicit LineReader(const std::string& path);

  /// Goes on to the next line; false at the end of the file.
  bool Next();

  /// Puts the next line in place of the backslash at the end of this one; false at the end of the
  /// file.
  bool Continue();

  const std::string& GetLine() const { return this->Line; }
  std::int64_t GetNumber() const { return this->Number; }

  /// Whether the last line read had an end of line: a file that was cut off has none.
  bool IsEnded() const { return this->Ended; }

  /// "line 12: "
  std::string Place() const { return "line " + std::to_string(this->Number) + ": "; }

  /// The words of the line, valid until the next line.
  const std::vector<std::string_view>& GetWords();

  /// For what follows the lines, in binary.
  std::ifstream& GetStream() { return this->Stream; }

private:
  std::ifstream Stream;
  std::string Line;
  std::vector<std::string_view> Words;
  bool IsSplit = false;
  std::int64_t Number = 0;
  bool Ended = true;
};

/// Whether the whole word is a number, and which: rounded to the nearest double, infinite beyond
/// the largest.
bool ReadNumber(std::string_view word, double& value);

/// Whether the whole word is a number; nan and inf are numbers here, the filter refuses them with
/// their count.
bool IsNumber(std::string_view word);

/// The same for a number that is written as one, not as the word nan or inf.
bool ReadFiniteNumber(std::string_view word, double& value);

/// Whether the whole word is a whole number, and which.
bool ReadInteger(std::string_view word, std::int64_t& value);
}

#endif
