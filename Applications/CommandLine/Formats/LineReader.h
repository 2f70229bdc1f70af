// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LineReader.h
 * @brief Lines and words of text files, with the number of the line for messages.
 *
 *     line ends        LF, CRLF and CR, also mixed
 *     blanks           those of C, spaces of Unicode such as U+00A0, the byte-order mark
 *
 * What follows the lines in binary begins after the line end: if the first line ends with CR alone,
 * every line does.
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

  /// Goes on to the next line; false at the end of the file. @throws Failure if the file is UTF-16
  /// text.
  bool Next();

  /// Whether this line ends with a backslash.
  bool IsContinued() const;

  /// Puts the next line in place of the backslash; false at the end of the file.
  bool Continue();

  /// The current line without its end.
  const std::string& GetLine() const { return this->Line; }
  std::int64_t GetNumber() const { return this->Number; }

  /// Whether the last line read had an end of line: a file that was cut off has none.
  bool IsEnded() const { return this->Ended; }

  /// "line 12: "
  std::string Prefix() const { return "line " + std::to_string(this->Number) + ": "; }

  /// The words of the line, valid until the next line.
  const std::vector<std::string_view>& GetWords();

  /// The stream, for binary data that follows the lines.
  std::ifstream& GetStream();

private:
  bool ReadLine();
  void RejectWideText() const;

  const std::string& Path;
  std::ifstream Stream;
  std::string Block;     // up to a line feed
  std::size_t Begin = 0; // of what is left of the block
  bool HasBlock = false;
  bool BlockEnded = false; // by a line feed
  bool EndsWithCarriageReturn = false;
  std::string Line;
  std::vector<std::string_view> Words;
  bool IsSplit = false;
  std::int64_t Number = 0;
  bool Ended = true;
};

/// Adds what stands between blanks and line ends; valid as long as the text is.
void SplitWords(std::string_view text, std::vector<std::string_view>& words);

/// The text without blanks at both ends.
std::string_view Trimmed(std::string_view text);
}

#endif
