// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LogBytes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::array<unsigned char, 8> Magic = { 'B', 'D', 'L', 'E', 'V', 'E', 'L', 'S' };
constexpr std::uint32_t FormatVersion = 2;
constexpr std::uint32_t SingleFlag = 1;
constexpr std::uint32_t MergeFlag = 2;
constexpr std::size_t BytesOfChecksum = 8;

/// FNV-1a over little-endian words of eight bytes; the last word is padded with zeros.
std::uint64_t ChecksumOf(const unsigned char* bytes, std::size_t size)
{
  std::uint64_t sum = 14695981039346656037ULL;
  for (std::size_t i = 0; i < size; i += 8)
  {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 8 && i + k < size; ++k)
    {
      word |= std::uint64_t(bytes[i + k]) << (8 * k);
    }
    sum = (sum ^ word) * 1099511628211ULL;
  }
  return sum;
}

template <typename To, typename From>
To BitsOf(const From& value)
{
  static_assert(sizeof(To) == sizeof(From), "the same bits");
  To bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

class Writer
{
public:
  template <typename Unsigned>
  void PutBits(Unsigned value)
  {
    for (std::size_t k = 0; k < sizeof(value); ++k)
    {
      this->Bytes.push_back(static_cast<unsigned char>(value >> (8 * k) & 0xFFU));
    }
  }
  void Put(Index value) { this->PutBits(static_cast<std::uint32_t>(value)); }
  void Put(double value) { this->PutBits(BitsOf<std::uint64_t>(value)); }
  void Put(const Vector3& position, bool isSingle)
  {
    for (const double coordinate : position)
    {
      if (isSingle)
      {
        this->PutBits(BitsOf<std::uint32_t>(static_cast<float>(coordinate)));
      }
      else
      {
        this->Put(coordinate);
      }
    }
  }
  template <typename T>
  void PutCount(const std::vector<T>& list)
  {
    this->Put(static_cast<Index>(list.size()));
  }

  std::vector<unsigned char> Bytes;
};

/// Reads zeros beyond the end and stores the error.
class Reader
{
public:
  Reader(const unsigned char* bytes, std::size_t size)
    : Position(bytes)
    , BytesLeft(size)
  {
  }

  template <typename Unsigned>
  Unsigned GetBits()
  {
    Unsigned value = 0;
    if (this->BytesLeft < sizeof(value))
    {
      this->Good = false;
      this->BytesLeft = 0;
      return value;
    }
    for (std::size_t k = 0; k < sizeof(value); ++k)
    {
      value |= static_cast<Unsigned>(static_cast<Unsigned>(this->Position[k]) << (8 * k));
    }
    this->Position += sizeof(value);
    this->BytesLeft -= sizeof(value);
    return value;
  }
  Index GetIndex() { return static_cast<Index>(this->GetBits<std::uint32_t>()); }
  double GetDouble() { return BitsOf<double>(this->GetBits<std::uint64_t>()); }
  Vector3 GetPosition(bool isSingle)
  {
    Vector3 position;
    for (double& coordinate : position)
    {
      coordinate =
        isSingle ? double(BitsOf<float>(this->GetBits<std::uint32_t>())) : this->GetDouble();
    }
    return position;
  }
  /// Reserves memory for at most as many entries as the remaining bytes can hold.
  template <typename T>
  void Resize(std::vector<T>& list, Index count, std::size_t bytesOfEach)
  {
    this->Good =
      this->Good && count >= 0 && static_cast<std::size_t>(count) <= this->BytesLeft / bytesOfEach;
    list.resize(this->Good ? static_cast<std::size_t>(count) : 0);
  }

  bool IsGood() const { return this->Good; }
  bool IsAtEnd() const { return this->BytesLeft == 0; }

private:
  const unsigned char* Position;
  std::size_t BytesLeft;
  bool Good = true;
};

std::size_t BytesOfPosition(bool isSingle)
{
  return 3 * (isSingle ? sizeof(float) : sizeof(double));
}

void Put(Writer& to, const LoggedPatch& patch, bool isSingle)
{
  to.Put(patch.Collapses);
  to.PutCount(patch.Faces);
  to.PutCount(patch.Vertices);
  for (const LoggedPatch::Face& face : patch.Faces)
  {
    to.Put(face.Id);
    std::for_each(face.Corners.begin(), face.Corners.end(), [&](Index v) { to.Put(v); });
  }
  for (const LoggedPatch::Vertex& vertex : patch.Vertices)
  {
    to.Put(vertex.Id);
    to.Put(vertex.Position, isSingle);
  }
}

void Get(Reader& from, LoggedPatch& patch, bool isSingle)
{
  patch.Collapses = from.GetIndex();
  const Index faces = from.GetIndex();
  const Index vertices = from.GetIndex();
  from.Resize(patch.Faces, faces, 4 * sizeof(Index));
  for (LoggedPatch::Face& face : patch.Faces)
  {
    face.Id = from.GetIndex();
    std::generate(face.Corners.begin(), face.Corners.end(), [&] { return from.GetIndex(); });
  }
  from.Resize(patch.Vertices, vertices, sizeof(Index) + BytesOfPosition(isSingle));
  for (LoggedPatch::Vertex& vertex : patch.Vertices)
  {
    vertex.Id = from.GetIndex();
    vertex.Position = from.GetPosition(isSingle);
  }
}

/// The content between version and checksum.
void Get(Reader& from, EditLog& log)
{
  const std::uint32_t flags = from.GetBits<std::uint32_t>();
  log.IsSingle = (flags & SingleFlag) != 0;
  log.MergesPoints = (flags & MergeFlag) != 0;
  log.InputChecksum = from.GetBits<std::uint64_t>();
  log.Vertices = from.GetIndex();
  log.Faces = from.GetIndex();
  const Index collapses = from.GetIndex();
  const Index patches = from.GetIndex();
  const Index marks = from.GetIndex();
  from.Resize(log.Collapses, collapses, 3 * sizeof(Index) + BytesOfPosition(log.IsSingle));
  for (LoggedCollapse& collapse : log.Collapses)
  {
    collapse.HalfEdge = from.GetIndex();
    collapse.OtherFace = from.GetIndex();
    collapse.KeptVertex = from.GetIndex();
    collapse.Position = from.GetPosition(log.IsSingle);
  }
  from.Resize(log.Patches, patches, 3 * sizeof(Index));
  for (LoggedPatch& patch : log.Patches)
  {
    Get(from, patch, log.IsSingle);
  }
  from.Resize(log.Marks, marks, 2 * sizeof(Index) + 2 * sizeof(double));
  for (LevelMark& mark : log.Marks)
  {
    mark.Collapses = from.GetIndex();
    mark.Triangles = from.GetIndex();
    mark.Largest = from.GetDouble();
    mark.Mean = from.GetDouble();
  }
}

bool IsOrdered(const EditLog& log)
{
  Index last = 0;
  for (const LevelMark& mark : log.Marks)
  {
    if (mark.Collapses < last || mark.Collapses > static_cast<Index>(log.Collapses.size()))
    {
      return false;
    }
    last = mark.Collapses;
  }
  return log.Vertices >= 0 && log.Faces >= 0;
}
}

std::string LogMessage(LogStatus status)
{
  switch (status)
  {
    case LogStatus::NotALog:
      return "it is no log of levels";
    case LogStatus::UnknownVersion:
      return "it is a log of levels of a version that this program does not know";
    case LogStatus::Damaged:
      return "the log is damaged: it is cut off or was changed after it was written";
    case LogStatus::Contradictory:
      return "the log contradicts itself: no run can have written it";
    case LogStatus::OtherSurface:
      return "the log was recorded on another surface";
    case LogStatus::BadLabelMap:
      return "the voxel grid or the labels of the surface cannot be used";
    case LogStatus::Good:
      break;
  }
  return {};
}

//------------------------------------------------------------------------------
std::vector<unsigned char> WriteLog(const EditLog& log)
{
  Writer to;
  to.Bytes.reserve(64 + (3 * sizeof(Index) + BytesOfPosition(log.IsSingle)) * log.Collapses.size());
  to.Bytes.insert(to.Bytes.end(), Magic.begin(), Magic.end());
  to.PutBits(FormatVersion);
  to.PutBits((log.IsSingle ? SingleFlag : 0U) | (log.MergesPoints ? MergeFlag : 0U));
  to.PutBits(log.InputChecksum);
  to.Put(log.Vertices);
  to.Put(log.Faces);
  to.PutCount(log.Collapses);
  to.PutCount(log.Patches);
  to.PutCount(log.Marks);
  for (const LoggedCollapse& collapse : log.Collapses)
  {
    to.Put(collapse.HalfEdge);
    to.Put(collapse.OtherFace);
    to.Put(collapse.KeptVertex);
    to.Put(collapse.Position, log.IsSingle);
  }
  for (const LoggedPatch& patch : log.Patches)
  {
    Put(to, patch, log.IsSingle);
  }
  for (const LevelMark& mark : log.Marks)
  {
    to.Put(mark.Collapses);
    to.Put(mark.Triangles);
    to.Put(mark.Largest);
    to.Put(mark.Mean);
  }
  to.PutBits(ChecksumOf(to.Bytes.data(), to.Bytes.size()));
  return std::move(to.Bytes);
}

//------------------------------------------------------------------------------
LogStatus ReadLog(const unsigned char* bytes, std::size_t size, EditLog& log)
{
  if (size < Magic.size() || !std::equal(Magic.begin(), Magic.end(), bytes))
  {
    return LogStatus::NotALog;
  }
  Reader from(bytes + Magic.size(), size - Magic.size());
  const std::uint32_t version = from.GetBits<std::uint32_t>();
  if (from.IsGood() && version != FormatVersion)
  {
    return LogStatus::UnknownVersion;
  }
  if (size < Magic.size() + sizeof(version) + BytesOfChecksum ||
    ChecksumOf(bytes, size - BytesOfChecksum) !=
      Reader(bytes + size - BytesOfChecksum, BytesOfChecksum).GetBits<std::uint64_t>())
  {
    return LogStatus::Damaged;
  }
  Reader content(bytes + Magic.size() + sizeof(version),
    size - Magic.size() - sizeof(version) - BytesOfChecksum);
  EditLog read;
  Get(content, read);
  if (!content.IsGood() || !content.IsAtEnd() || !IsOrdered(read))
  {
    return LogStatus::Contradictory;
  }
  log = std::move(read);
  return LogStatus::Good;
}
}
