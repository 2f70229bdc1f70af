// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlainStream.h"

#include "ClosedPipe.h"
#include "PlainText.h"

#include <cerrno>

namespace bonedecimate
{
PlainStream::PlainStream(std::ostream& stream)
  : Stream(stream)
  , Target(stream.rdbuf(this))
{
}

PlainStream::~PlainStream()
{
  this->PlainStream::sync();
  this->Stream.rdbuf(this->Target);
}

PlainStream::int_type PlainStream::overflow(int_type c)
{
  if (traits_type::eq_int_type(c, traits_type::eof()))
  {
    return traits_type::not_eof(c);
  }
  return this->Take(traits_type::to_char_type(c)) ? c : traits_type::eof();
}

int PlainStream::sync()
{
  const bool isWritten = this->Pending.empty() || this->Write("?");
  this->Pending.clear();
  return isWritten && this->Target->pubsync() == 0 ? 0 : (this->NoteFailure(), -1);
}

bool PlainStream::Take(char c)
{
  const bool isAscii = static_cast<unsigned char>(c) < 0x80;
  const bool isStart = (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  if (isStart && !this->Pending.empty())
  {
    this->Pending.clear();
    if (!this->Write("?"))
    {
      return false;
    }
  }
  if (isAscii)
  {
    const bool isPlain =
      c == '\n' || c == '\r' || c == '\t' || LengthOfPlainCharacter({ &c, 1 }) == 1;
    return this->Write(std::string(1, isPlain ? c : '?'));
  }
  this->Pending += c;
  constexpr std::size_t longest = 4;
  const bool isPlain = LengthOfPlainCharacter(this->Pending) == this->Pending.size();
  if (!isPlain && this->Pending.size() < longest &&
    static_cast<unsigned char>(this->Pending[0]) >= 0xc2)
  {
    return true; // more of it may follow
  }
  const std::string text = isPlain ? this->Pending : "?";
  this->Pending.clear();
  return this->Write(text);
}

bool PlainStream::Write(const std::string& text)
{
  const auto size = static_cast<std::streamsize>(text.size());
  return this->Target->sputn(text.data(), size) == size || this->NoteFailure();
}

bool PlainStream::NoteFailure()
{
  this->Closed = this->Closed || IsClosedPipe(errno);
  return false;
}
}
