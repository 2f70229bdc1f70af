// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomAttributes.h
 * @brief Values of a DICOM data set, also those of items in sequences.
 */
#ifndef BoneDecimate_Applications_DicomAttributes_h
#define BoneDecimate_Applications_DicomAttributes_h

#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmSmartPointer.h>
#include <gdcmTag.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// Text of an attribute without blanks and zeros at either end; empty if it is not there.
std::string TextOf(const gdcm::DataSet& data, const gdcm::Tag& tag);

/// Exactly so many decimal numbers (DS or IS), or none.
std::optional<std::vector<double>> NumbersOf(
  const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count);

/// Exactly so many numbers of 16 bits (US), or none. The file is little-endian.
std::optional<std::vector<std::uint16_t>> WordsOf(
  const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count);

/// The items of a sequence, valid as long as this object lives.
class DicomItems
{
public:
  /// Has no items if there is no such sequence.
  DicomItems(const gdcm::DataSet& data, const gdcm::Tag& tag);

  std::size_t Count() const { return this->Items ? this->Items->GetNumberOfItems() : 0; }
  const gdcm::DataSet& At(std::size_t i) const
  {
    return this->Items->GetItem(i + 1).GetNestedDataSet();
  }

private:
  gdcm::SmartPointer<gdcm::SequenceOfItems> Items;
};

/**
 * What a file of several frames says of one of them: a functional group is in the item of the frame
 * or in that of all frames.
 */
class FrameAttributes
{
public:
  FrameAttributes(const gdcm::DataSet& frame, const gdcm::DataSet* shared)
    : Frame(frame)
    , Shared(shared)
  {
  }

  std::optional<std::vector<double>> Numbers(
    const gdcm::Tag& group, const gdcm::Tag& tag, std::size_t count) const;

  std::optional<std::uint16_t> Word(const gdcm::Tag& group, const gdcm::Tag& tag) const;

private:
  DicomItems Group(const gdcm::Tag& group) const;

  const gdcm::DataSet& Frame;
  const gdcm::DataSet* Shared; ///< May be null.
};
}

#endif
