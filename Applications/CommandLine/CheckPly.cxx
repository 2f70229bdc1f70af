// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// PLY announces its counts; VTK allocates by them before it reads, and does not say when the file
/// ends early.
#include "FileChecks.h"
#include "LineReader.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace bonedecimate
{
namespace
{
/// VTK reads the corners of a face into an array of this length.
constexpr std::int64_t MostCorners = 255;

/// What a program may have put behind binary data.
constexpr std::streamoff LongestLineEnd = 2;

struct Property
{
  std::string Name;
  std::size_t Bytes = 0;      // of the value, or of one entry of a list
  std::size_t CountBytes = 0; // of a list's count, 0 if it is no list
  bool IsCorners = false;     // of a face
};

struct Element
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<Property> Properties;
};

std::size_t BytesOf(std::string_view type)
{
  static const std::map<std::string_view, std::size_t> bytes = { { "char", 1 }, { "uchar", 1 },
    { "int8", 1 }, { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 },
    { "int", 4 }, { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = bytes.find(type);
  return found == bytes.end() ? 0 : found->second;
}

class PlyCheck
{
public:
  explicit PlyCheck(const std::string& path)
    : Path(path)
    , Lines(path)
  {
  }

  void Run(std::vector<std::string>& warnings)
  {
    this->ReadHeader();
    this->CheckHeader(warnings);
    for (const Element& element : this->Elements)
    {
      this->Walk(element);
    }
    if (this->Encoding == "ascii" ? this->HasMoreText() : this->HasMoreBytes())
    {
      Refuse(this->Path, "it holds more than its header announces; it is damaged");
    }
  }

private:
  bool HasMoreText()
  {
    while (this->Lines.Next())
    {
      if (!this->Lines.GetWords().empty())
      {
        return true;
      }
    }
    return false;
  }

  bool HasMoreBytes()
  {
    const auto size = static_cast<std::streamoff>(std::filesystem::file_size(this->Path));
    const auto read = static_cast<std::streamoff>(this->Lines.GetStream().tellg());
    return size - read > LongestLineEnd;
  }

  void ReadHeader()
  {
    if (!this->Lines.Next() || this->Lines.GetWords().size() != 1 ||
      this->Lines.GetWords()[0] != "ply")
    {
      Refuse(this->Path, "it does not begin with 'ply'");
    }
    while (this->Lines.Next())
    {
      const std::vector<std::string_view>& words = this->Lines.GetWords();
      if (!words.empty() && words[0] == "end_header")
      {
        return;
      }
      if (!words.empty() && !this->ReadHeaderLine(words))
      {
        Refuse(this->Path, this->Lines.Place() + "the header cannot be understood");
      }
    }
    Refuse(this->Path, "its header has no end; the file is cut off");
  }

  bool ReadHeaderLine(const std::vector<std::string_view>& words)
  {
    if (words[0] == "comment" || words[0] == "obj_info")
    {
      return true;
    }
    if (words[0] == "format" && words.size() == 3)
    {
      this->Encoding = words[1];
      return words[1] == "ascii" || words[1] == "binary_little_endian" ||
        words[1] == "binary_big_endian";
    }
    if (words[0] == "element" && words.size() == 3)
    {
      this->Elements.push_back({ std::string(words[1]), 0, {} });
      return ReadInteger(words[2], this->Elements.back().Count) && this->Elements.back().Count >= 0;
    }
    return words[0] == "property" && !this->Elements.empty() && this->ReadProperty(words);
  }

  bool ReadProperty(const std::vector<std::string_view>& words)
  {
    const bool isList = words.size() == 5 && words[1] == "list";
    if (!isList && words.size() != 3)
    {
      return false;
    }
    const std::string_view type = words[isList ? 3 : 1];
    Property property;
    property.Name = words.back();
    property.Bytes = BytesOf(type);
    property.CountBytes = isList ? BytesOf(words[2]) : 0;
    property.IsCorners =
      isList && (property.Name == "vertex_indices" || property.Name == "vertex_index");
    this->Elements.back().Properties.push_back(property);
    const bool whole = type.find("int") != std::string_view::npos ||
      type.find("char") != std::string_view::npos || type.find("short") != std::string_view::npos;
    return property.Bytes > 0 &&
      (!isList || (property.CountBytes > 0 && property.CountBytes < 8)) &&
      (!property.IsCorners || whole);
  }

  const Element* Find(const std::string& name) const
  {
    const auto found = std::find_if(this->Elements.begin(), this->Elements.end(),
      [&](const Element& element) { return element.Name == name; });
    return found == this->Elements.end() ? nullptr : &*found;
  }

  static const Property* FindProperty(const Element& element, const std::string& name)
  {
    const auto found = std::find_if(element.Properties.begin(), element.Properties.end(),
      [&](const Property& property) { return property.Name == name; });
    return found == element.Properties.end() ? nullptr : &*found;
  }

  void CheckHeader(std::vector<std::string>& warnings)
  {
    const Element* vertices = this->Find("vertex");
    const Element* faces = this->Find("face");
    if (this->Encoding.empty() || !vertices || !faces)
    {
      Refuse(this->Path, "its header has no format, no element 'vertex' or no element 'face'");
    }
    const Property* x = FindProperty(*vertices, "x");
    const bool corners = std::any_of(faces->Properties.begin(), faces->Properties.end(),
      [](const Property& property) { return property.IsCorners; });
    if (!x || !FindProperty(*vertices, "y") || !FindProperty(*vertices, "z") || !corners)
    {
      Refuse(this->Path, "its header has no x, y, z or no list of vertex_indices");
    }
    this->Vertices = vertices->Count;
    if (x->Bytes == 8)
    {
      warnings.emplace_back(
        "the coordinates of the input are doubles; PLY is read in single precision");
    }
    // VTK does not skip what it does not know: it would read such an element as faces.
    if (this->Elements[0].Name != "vertex" || this->Elements[1].Name != "face")
    {
      Refuse(this->Path, "its first two elements are not 'vertex' and 'face'");
    }
    this->CheckSize();
  }

  /// Before anything is walked: what is announced must fit into the file at all.
  void CheckSize()
  {
    const auto size = static_cast<double>(std::filesystem::file_size(this->Path));
    double least = 0.0;
    for (const Element& element : this->Elements)
    {
      for (const Property& property : element.Properties)
      {
        const std::size_t binary = property.CountBytes > 0 ? property.CountBytes : property.Bytes;
        least += static_cast<double>(element.Count) *
          (this->Encoding == "ascii" ? 2.0 : static_cast<double>(binary));
      }
    }
    if (least > size)
    {
      Refuse(this->Path,
        "its header announces more than the file's " + std::to_string(std::uintmax_t(size)) +
          " bytes");
    }
  }

  void Walk(const Element& element)
  {
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      const bool whole =
        this->Encoding == "ascii" ? this->WalkText(element) : this->WalkBinary(element);
      if (!whole)
      {
        Refuse(this->Path,
          "it announces " + std::to_string(element.Count) + " of '" + element.Name +
            "' but ends or breaks in number " + std::to_string(i));
      }
    }
  }

  bool WalkText(const Element& element)
  {
    do
    {
      if (!this->Lines.Next())
      {
        return false;
      }
    } while (this->Lines.GetWords().empty());
    const std::vector<std::string_view>& words = this->Lines.GetWords();
    std::size_t at = 0;
    for (const Property& property : element.Properties)
    {
      std::int64_t count = 1;
      const bool isList = property.CountBytes > 0;
      if (isList)
      {
        if (at >= words.size() || !ReadInteger(words[at], count) || !IsLength(count))
        {
          return false;
        }
        ++at;
      }
      for (std::int64_t i = 0; i < count; ++i, ++at)
      {
        if (at >= words.size() || !this->IsValue(words[at], property))
        {
          return false;
        }
      }
    }
    // VTK does not see a last line that has no end, and skips what a list's count leaves out.
    return at == words.size() && this->Lines.IsEnded();
  }

  bool IsValue(std::string_view word, const Property& property) const
  {
    std::int64_t corner = 0;
    return property.IsCorners ? ReadInteger(word, corner) && this->IsVertex(corner)
                              : IsNumber(word);
  }

  /// VTK follows every corner before the filter could count the wrong ones.
  bool IsVertex(std::int64_t index) const { return index >= 0 && index < this->Vertices; }

  bool WalkBinary(const Element& element)
  {
    for (const Property& property : element.Properties)
    {
      const std::int64_t count = property.CountBytes > 0 ? this->ReadWhole(property.CountBytes) : 1;
      if (!IsLength(count) ||
        !(property.IsCorners ? this->ReadCorners(count, property) : this->Skip(count, property)))
      {
        return false;
      }
    }
    return true;
  }

  bool Skip(std::int64_t count, const Property& property)
  {
    const auto bytes = count * static_cast<std::int64_t>(property.Bytes);
    this->Lines.GetStream().ignore(bytes);
    return this->Lines.GetStream().gcount() == bytes;
  }

  bool ReadCorners(std::int64_t count, const Property& property)
  {
    bool right = true;
    for (std::int64_t i = 0; i < count && right; ++i)
    {
      // A negative index reads as a huge one here.
      right = this->IsVertex(this->ReadWhole(property.Bytes));
    }
    return right;
  }

  /// VTK frees what it never allocated for a list without entries.
  static bool IsLength(std::int64_t count) { return count >= 1 && count <= MostCorners; }

  /// A whole number without sign; -1 at the end of the file.
  std::int64_t ReadWhole(std::size_t bytes)
  {
    unsigned char raw[8] = {};
    this->Lines.GetStream().read(reinterpret_cast<char*>(raw), static_cast<std::streamsize>(bytes));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i)
    {
      const std::size_t place = this->Encoding == "binary_big_endian" ? i : bytes - 1 - i;
      value = value * 256 + raw[place];
    }
    return this->Lines.GetStream() ? static_cast<std::int64_t>(value) : -1;
  }

  const std::string& Path;
  LineReader Lines;
  std::string Encoding;
  std::vector<Element> Elements;
  std::int64_t Vertices = 0;
};
}

void CheckPlyFile(const std::string& path, std::vector<std::string>& warnings)
{
  PlyCheck(path).Run(warnings);
}
}
