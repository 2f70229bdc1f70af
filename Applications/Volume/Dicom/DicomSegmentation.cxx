// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomSegmentation.h"

#include "DicomAttributes.h"
#include "DicomTags.h"
#include "GdcmMessages.h"
#include "MemoryCap.h"
#include "Readers/DataFile.h"
#include "SegmentationHeader.h"

#include <gdcmBitmap.h>
#include <gdcmByteValue.h>
#include <gdcmFileMetaInformation.h>
#include <gdcmPreamble.h>
#include <gdcmReader.h>
#include <gdcmSequenceOfFragments.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>

namespace bonedecimate::volume
{
namespace
{
const gdcm::Tag SyntaxInHeader(0x0002, 0x0010);

constexpr const char* DamagedFile = "it is truncated or damaged";

constexpr const char* UnreadableSyntax =
  "its pixels are compressed or stored in a way that is not read; save it uncompressed";

/// Empty frames are packed more tightly than real voxels: up to so many bytes into one.
constexpr double LargestFrameExpansion = 1 << 14;

/// Bytes of all frames.
using PixelBytes = std::optional<std::vector<unsigned char>>;

bool IsReadSyntax(gdcm::TransferSyntax::TSType syntax)
{
  const auto read = { gdcm::TransferSyntax::ImplicitVRLittleEndian,
    gdcm::TransferSyntax::ExplicitVRLittleEndian, gdcm::TransferSyntax::RLELossless,
    gdcm::TransferSyntax::JPEGLosslessProcess14, gdcm::TransferSyntax::JPEGLosslessProcess14_1,
    gdcm::TransferSyntax::JPEGLSLossless, gdcm::TransferSyntax::JPEG2000Lossless };
  return std::find(read.begin(), read.end(), syntax) != read.end();
}

/// Why it is rejected before its data set is read; empty if it is not. GDCM takes minutes for
/// deflated files that end early.
std::string SyntaxProblem(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  gdcm::Preamble preamble;
  gdcm::FileMetaInformation header;
  bool isKnown = true;
  try
  {
    preamble.Read(file);
    header.Read(file);
  }
  catch (const std::exception&)
  {
    isKnown = false; // the header is read nevertheless
  }
  const std::string syntax = TextOf(header, SyntaxInHeader);
  if (syntax.empty())
  {
    return DamagedFile;
  }
  return isKnown && IsReadSyntax(gdcm::TransferSyntax::GetTSType(syntax.c_str()))
    ? std::string()
    : UnreadableSyntax;
}

/// An element may announce 4 GB.
bool ReadWithin(gdcm::Reader& reader, std::uint64_t memory)
{
  const MemoryCap cap(memory);
  try
  {
    return reader.Read();
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
}

/// Lossless codecs of GDCM. The size was checked.
PixelBytes Unpacked(const SegmentationHeader& header, const gdcm::File& file, std::uint64_t bytes)
{
  gdcm::Bitmap bitmap;
  bitmap.SetNumberOfDimensions(3);
  bitmap.SetDimension(0, static_cast<unsigned int>(header.Size[0]));
  bitmap.SetDimension(1, static_cast<unsigned int>(header.Size[1]));
  bitmap.SetDimension(2, static_cast<unsigned int>(header.Frames.size()));
  bitmap.SetPixelFormat(
    header.Pixels == SegmentPixels::Bytes ? gdcm::PixelFormat::UINT8 : gdcm::PixelFormat::UINT16);
  bitmap.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  bitmap.SetTransferSyntax(file.GetHeader().GetDataSetTransferSyntax());
  bitmap.SetDataElement(file.GetDataSet().GetDataElement(tags::PixelData));
  std::vector<unsigned char> unpacked(bytes);
  const bool isRead =
    bitmap.GetBufferLength() == bytes && bitmap.GetBuffer(reinterpret_cast<char*>(unpacked.data()));
  return isRead ? PixelBytes(std::move(unpacked)) : std::nullopt;
}

/// @return Nothing if there are not as many as the header says, or if they are damaged.
PixelBytes ReadPixels(const SegmentationHeader& header, const gdcm::File& file)
{
  const gdcm::DataSet& data = file.GetDataSet();
  if (!data.FindDataElement(tags::PixelData))
  {
    return std::nullopt;
  }
  const auto pixels = static_cast<std::uint64_t>(header.Size[0] * header.Size[1]) *
    static_cast<std::uint64_t>(header.Frames.size());
  const std::uint64_t bytes = BytesOfPixels(pixels, header.Pixels);
  const gdcm::DataElement& element = data.GetDataElement(tags::PixelData);
  if (const gdcm::SequenceOfFragments* const fragments = element.GetSequenceOfFragments())
  {
    const auto packed = static_cast<double>(fragments->ComputeByteLength());
    return static_cast<double>(bytes) <= LargestFrameExpansion * packed
      ? Unpacked(header, file, bytes)
      : std::nullopt;
  }
  const gdcm::ByteValue* const value = element.GetByteValue();
  // An odd number of bytes is followed by another one.
  if (!value || value->GetLength() < bytes || value->GetLength() > bytes + 1)
  {
    return std::nullopt;
  }
  const auto* const first = reinterpret_cast<const unsigned char*>(value->GetPointer());
  return std::vector<unsigned char>(first, first + bytes);
}

/// Combines all planes once.
Overlap OverlapOf(const SegmentFrames& frames, const SegmentationHeader& header)
{
  std::vector<std::uint16_t> labels(static_cast<std::size_t>(header.Size[0] * header.Size[1]));
  Overlap all;
  for (std::int64_t plane = 0; plane < header.Grid.Planes; ++plane)
  {
    const Overlap overlap = frames.Combine(plane, labels.data());
    all.Voxels += overlap.Voxels;
    all.Undescribed += overlap.Undescribed;
  }
  return all;
}

std::string NoteOf(const SegmentationHeader& header, const Overlap& overlap)
{
  std::string note = OverlapNote(overlap);
  if (header.Grid.PlanesWithoutFrames > 0)
  {
    note += std::string(note.empty() ? "" : "; ") +
      std::to_string(header.Grid.PlanesWithoutFrames) + " of its " +
      std::to_string(header.Grid.Planes) + " planes have no frame and are background";
  }
  if (!header.Grid.Note.empty())
  {
    note += (note.empty() ? "" : "; ") + header.Grid.Note;
  }
  return note;
}

LayeredVolume LabelsOf(const SegmentationHeader& header, std::vector<unsigned char> bytes,
  const SegmentSelection& selection)
{
  const auto frames =
    std::make_shared<SegmentFrames>(header.Pixels, std::move(bytes), header.Size, header.Segments);
  const std::string arrangement =
    frames->Arrange(header.Frames, header.Grid.Planes, ChosenSegments(header.Segments, selection));
  const Overlap overlap = arrangement.empty() ? OverlapOf(*frames, header) : Overlap();
  const std::string problem = FirstOf({ arrangement, UndescribedProblem(overlap) });
  if (!problem.empty())
  {
    return RejectedLayers(problem);
  }
  LayeredVolume volume;
  volume.Header.Size = { { header.Size[0], header.Size[1], header.Grid.Planes } };
  volume.Header.ScalarType = VTK_UNSIGNED_SHORT;
  volume.Header.Geometry = header.Grid.Geometry;
  volume.Header.Layers = header.Grid.Layers;
  volume.Header.IsReadWhole = true;
  volume.Header.Note = NoteOf(header, overlap);
  AddLabelFields(header.Segments, volume.Header.Fields);
  volume.ReadLayer = [frames, plane = std::int64_t(0)](void* labels) mutable
  {
    frames->Combine(plane++, static_cast<std::uint16_t*>(labels));
    return std::string();
  };
  return volume;
}
}

LayeredVolume OpenDicomSegmentation(const std::string& file, const SegmentSelection& selection)
{
  const GdcmMessages messages;
  const std::string syntaxProblem = SyntaxProblem(file);
  if (!syntaxProblem.empty())
  {
    return RejectedLayers(syntaxProblem);
  }
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!ReadWithin(reader, MemoryForFiles(SizeOfFile(file))) || messages.TellOfMissingPixels())
  {
    return RejectedLayers(DamagedFile);
  }
  const SegmentationHeader header = ReadSegmentationHeader(reader.GetFile().GetDataSet());
  // Voxels that are announced are held against the bytes of pixels below; planes without a frame
  // take none.
  const std::string problem = header.Problem.empty()
    ? SizeProblem({ { header.Size[0], header.Size[1], header.Grid.Planes } }, 0, 0, false)
    : header.Problem;
  if (!problem.empty())
  {
    return RejectedLayers(problem);
  }
  if (header.Pixels == SegmentPixels::Bits &&
    reader.GetFile().GetHeader().GetDataSetTransferSyntax().IsEncapsulated())
  {
    return RejectedLayers(UnreadableSyntax);
  }
  PixelBytes bytes = ReadPixels(header, reader.GetFile());
  return bytes ? LabelsOf(header, std::move(*bytes), selection) : RejectedLayers(DamagedVoxels);
}
}
