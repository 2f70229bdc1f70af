// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomAttributes.h"

#include "Readers/TextNumbers.h"

#include <gdcmByteValue.h>

namespace bonedecimate::volume
{
namespace
{
std::string BytesOf(const gdcm::DataSet& data, const gdcm::Tag& tag)
{
  const gdcm::ByteValue* const value =
    data.FindDataElement(tag) ? data.GetDataElement(tag).GetByteValue() : nullptr;
  return value ? std::string(value->GetPointer(), value->GetLength()) : std::string();
}
}

std::string TextOf(const gdcm::DataSet& data, const gdcm::Tag& tag)
{
  return Trimmed(BytesOf(data, tag));
}

std::optional<std::vector<double>> NumbersOf(
  const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count)
{
  auto numbers = ParseNumbers(TextOf(data, tag));
  return numbers && numbers->size() == count ? numbers : std::nullopt;
}

std::optional<std::vector<std::uint16_t>> WordsOf(
  const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count)
{
  const std::string bytes = BytesOf(data, tag);
  if (bytes.size() != 2 * count)
  {
    return std::nullopt;
  }
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; i < bytes.size(); i += 2)
  {
    const auto low = static_cast<unsigned char>(bytes[i]);
    const auto high = static_cast<unsigned char>(bytes[i + 1]);
    words.push_back(static_cast<std::uint16_t>(low | high << 8));
  }
  return words;
}

DicomItems::DicomItems(const gdcm::DataSet& data, const gdcm::Tag& tag)
{
  if (data.FindDataElement(tag))
  {
    this->Items = data.GetDataElement(tag).GetValueAsSQ();
  }
}

DicomItems FrameAttributes::Group(const gdcm::Tag& group) const
{
  DicomItems ofFrame(this->Frame, group);
  return ofFrame.Count() > 0 || !this->Shared ? ofFrame : DicomItems(*this->Shared, group);
}

std::optional<std::vector<double>> FrameAttributes::Numbers(
  const gdcm::Tag& group, const gdcm::Tag& tag, std::size_t count) const
{
  const DicomItems items = this->Group(group);
  return items.Count() > 0 ? NumbersOf(items.At(0), tag, count) : std::nullopt;
}

std::optional<std::uint16_t> FrameAttributes::Word(
  const gdcm::Tag& group, const gdcm::Tag& tag) const
{
  const DicomItems items = this->Group(group);
  const auto words = items.Count() > 0 ? WordsOf(items.At(0), tag, 1) : std::nullopt;
  return words ? std::optional<std::uint16_t>(words->front()) : std::nullopt;
}
}
