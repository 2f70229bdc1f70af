// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainStream.h
 * @brief What the program says, without bytes that would command a terminal: names of files and
 * options may hold any.
 */
#ifndef BoneDecimate_Applications_PlainStream_h
#define BoneDecimate_Applications_PlainStream_h

#include <ostream>
#include <streambuf>
#include <string>

namespace bonedecimate
{
/// As long as it lives, each byte of a stream that is neither plain text (PlainText.h), a tab nor
/// the end of a line becomes a question mark.
class PlainStream : private std::streambuf
{
public:
  explicit PlainStream(std::ostream& stream);
  ~PlainStream() override;
  PlainStream(const PlainStream&) = delete;
  PlainStream& operator=(const PlainStream&) = delete;

  /// Whether a write failed because the reader of the pipe has ended.
  bool IsClosed() const { return this->Closed; }

private:
  int_type overflow(int_type c) override;
  int sync() override;
  bool Take(char c);
  bool Write(const std::string& text);
  bool NoteFailure();

  std::ostream& Stream;
  std::streambuf* Target;
  std::string Pending; // the beginning of a character
  bool Closed = false;
};
}

#endif
