// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyElementReader.h"

#include "Base/Text.h"
#include "FilePath.h"

#include "vtkDataArray.h"

#include <cmath>
#include <cstring>
#include <filesystem>

namespace bonedecimate
{
namespace
{
/// What a program may have put behind binary data.
constexpr std::int64_t LongestLineEnd = 2;

/// Independent of the system: the bits are a whole number here.
double ValueOf(std::uint64_t bits, int type)
{
  switch (type)
  {
    case VTK_SIGNED_CHAR:
      return static_cast<double>(static_cast<std::int8_t>(bits));
    case VTK_SHORT:
      return static_cast<double>(static_cast<std::int16_t>(bits));
    case VTK_INT:
      return static_cast<double>(static_cast<std::int32_t>(bits));
    case VTK_FLOAT:
    {
      const auto word = static_cast<std::uint32_t>(bits);
      float value = 0.0F;
      std::memcpy(&value, &word, sizeof(value));
      return static_cast<double>(value);
    }
    case VTK_DOUBLE:
    {
      double value = 0.0;
      std::memcpy(&value, &bits, sizeof(value));
      return value;
    }
    default:
      return static_cast<double>(bits);
  }
}
}

PlyElementReader::PlyElementReader(
  const std::string& path, const PlyHeader& header, LineReader& lines)
  : Header(header)
  , Lines(lines)
{
  if (!header.IsText)
  {
    this->BytesLeft = static_cast<std::int64_t>(std::filesystem::file_size(FilePath(path))) -
      static_cast<std::int64_t>(lines.GetStream().tellg());
  }
}

bool PlyElementReader::Read(const PlyElement& element, PlyValues& values)
{
  values.Scalars.resize(element.Properties.size());
  values.Lists.resize(element.Properties.size());
  return this->Header.IsText ? this->ReadText(element, values)
                             : this->ReadProperties(element, values);
}

bool PlyElementReader::HasMore()
{
  if (!this->Header.IsText)
  {
    return this->BytesLeft > LongestLineEnd;
  }
  while (this->Lines.Next())
  {
    if (!this->Lines.GetWords().empty())
    {
      return true;
    }
  }
  return false;
}

bool PlyElementReader::ReadText(const PlyElement& element, PlyValues& values)
{
  do
  {
    if (!this->Lines.Next())
    {
      return false;
    }
  } while (this->Lines.GetWords().empty());
  this->Word = 0;
  return this->ReadProperties(element, values) && this->Word == this->Lines.GetWords().size();
}

bool PlyElementReader::ReadProperties(const PlyElement& element, PlyValues& values)
{
  for (std::size_t i = 0; i < element.Properties.size(); ++i)
  {
    const PlyProperty& property = element.Properties[i];
    const bool isGood = property.IsList() ? this->ReadList(property, values.Lists[i])
                                          : this->ReadValue(property.Type, values.Scalars[i]);
    if (!isGood)
    {
      return false;
    }
  }
  return true;
}

bool PlyElementReader::ReadList(const PlyProperty& property, std::vector<double>& list)
{
  double count = 0.0;
  if (!this->ReadValue(property.CountType, count) || count < 0.0 ||
    count > this->MostValues(property.Type))
  {
    return false;
  }
  list.resize(static_cast<std::size_t>(count));
  for (double& value : list)
  {
    if (!this->ReadValue(property.Type, value))
    {
      return false;
    }
  }
  return true;
}

/// What is left of the line or of the file can hold no more.
double PlyElementReader::MostValues(int type)
{
  return this->Header.IsText
    ? static_cast<double>(this->Lines.GetWords().size())
    : static_cast<double>(this->BytesLeft) / static_cast<double>(BytesOfPlyType(type));
}

bool PlyElementReader::ReadValue(int type, double& value)
{
  return this->Header.IsText ? this->ReadTextValue(type, value)
                             : this->ReadBinaryValue(type, value);
}

bool PlyElementReader::ReadTextValue(int type, double& value)
{
  const std::vector<std::string_view>& words = this->Lines.GetWords();
  const std::optional<double> number =
    this->Word < words.size() ? ParseNumber<double>(words[this->Word]) : std::nullopt;
  if (!number)
  {
    return false;
  }
  value = *number;
  ++this->Word;
  return !IsWholeNumber(type) ||
    (std::floor(value) == value && value >= vtkDataArray::GetDataTypeMin(type) &&
      value <= vtkDataArray::GetDataTypeMax(type));
}

bool PlyElementReader::ReadBinaryValue(int type, double& value)
{
  const std::size_t bytes = BytesOfPlyType(type);
  unsigned char raw[8] = {};
  const auto length = static_cast<std::streamsize>(bytes);
  if (this->Lines.GetStream().rdbuf()->sgetn(reinterpret_cast<char*>(raw), length) != length)
  {
    return false;
  }
  this->BytesLeft -= length;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes; ++i)
  {
    bits = bits << 8 | raw[this->Header.IsBigEndian ? i : bytes - 1 - i];
  }
  value = ValueOf(bits, type);
  return true;
}
}
