// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyHeader.h"

#include "Base/Text.h"
#include "FileChecks.h"
#include "FileFrame.h"
#include "FilePath.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace bonedecimate
{
namespace
{
/// VTK compares the name of each array with those of all others.
constexpr int MostProperties = 4096;

/// VTK_VOID if there is no such type.
int TypeOf(std::string_view name)
{
  static const std::map<std::string, int> types = { { "char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "short", VTK_SHORT }, { "int16", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "int", VTK_INT }, { "int32", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "uint32", VTK_UNSIGNED_INT }, { "float", VTK_FLOAT },
    { "float32", VTK_FLOAT }, { "double", VTK_DOUBLE }, { "float64", VTK_DOUBLE } };
  const auto found = types.find(LowerCase(std::string(name)));
  return found == types.end() ? VTK_VOID : found->second;
}

class HeaderReader
{
public:
  HeaderReader(const std::string& path, LineReader& lines)
    : Path(path)
    , Lines(lines)
  {
  }

  PlyHeader Run()
  {
    this->ReadLines();
    this->CheckElements();
    this->CheckSize();
    return this->Header;
  }

private:
  void ReadLines()
  {
    if (!this->Lines.Next() || this->Lines.GetWords().size() != 1 ||
      LowerCase(std::string(this->Lines.GetWords()[0])) != "ply")
    {
      Reject(this->Path, "it does not begin with 'ply'");
    }
    while (this->Lines.Next())
    {
      const std::vector<std::string_view>& words = this->Lines.GetWords();
      const std::string keyword = words.empty() ? "" : LowerCase(std::string(words[0]));
      if (keyword == "end_header")
      {
        return;
      }
      if (!words.empty() && !this->ReadLine(keyword, words))
      {
        Reject(this->Path, this->Lines.Prefix() + "the header cannot be understood");
      }
    }
    Reject(this->Path, "its header has no end; the file is cut off");
  }

  bool ReadLine(const std::string& keyword, const std::vector<std::string_view>& words)
  {
    if (keyword == "comment" || keyword == "obj_info")
    {
      std::string& frame = this->Header.Frame;
      frame = frame.empty() ? FrameIn(this->Lines.GetLine()) : frame;
      return true;
    }
    if (keyword == "format" && words.size() == 3)
    {
      const std::string form = LowerCase(std::string(words[1]));
      this->HasFormat = true;
      this->Header.IsText = form == "ascii";
      this->Header.IsBigEndian = form == "binary_big_endian";
      return this->Header.IsText || this->Header.IsBigEndian || form == "binary_little_endian";
    }
    std::vector<PlyElement>& elements = this->Header.Elements;
    if (keyword == "element" && words.size() == 3)
    {
      const std::int64_t count = ParseNumber<std::int64_t>(words[2]).value_or(-1);
      elements.push_back({ std::string(words[1]), count, {} });
      return count >= 0;
    }
    return keyword == "property" && !elements.empty() && this->ReadProperty(words);
  }

  bool ReadProperty(const std::vector<std::string_view>& words)
  {
    const bool isList = words.size() == 5 && words[1] == "list";
    if (!isList && words.size() != 3)
    {
      return false;
    }
    PlyProperty property;
    property.Name = words.back();
    if (++this->Properties > MostProperties)
    {
      Reject(
        this->Path, "its header has more than " + std::to_string(MostProperties) + " properties");
    }
    property.Type = TypeOf(words[isList ? 3 : 1]);
    property.CountType = isList ? TypeOf(words[2]) : VTK_VOID;
    property.IsCorners =
      isList && (property.Name == "vertex_indices" || property.Name == "vertex_index");
    this->Header.Elements.back().Properties.push_back(property);
    return property.Type != VTK_VOID && (!isList || IsWholeNumber(property.CountType)) &&
      (!property.IsCorners || IsWholeNumber(property.Type));
  }

  const PlyElement* Find(const std::string& name) const
  {
    const std::vector<PlyElement>& elements = this->Header.Elements;
    const auto found = std::find_if(elements.begin(), elements.end(),
      [&](const PlyElement& element) { return element.Name == name; });
    return found == elements.end() ? nullptr : &*found;
  }

  void CheckElements()
  {
    const PlyElement* vertices = this->Find("vertex");
    const PlyElement* faces = this->Find("face");
    const PlyElement* strips = this->Find("tristrips");
    if (!this->HasFormat || !vertices || (!faces && !strips))
    {
      Reject(this->Path,
        "its header has no format, no element 'vertex' or neither 'face' nor 'tristrips'");
    }
    const auto hasCornersIn = [](const PlyElement* element)
    {
      return element == nullptr ||
        std::any_of(element->Properties.begin(), element->Properties.end(),
          [](const PlyProperty& property) { return property.IsCorners; });
    };
    const bool hasCorners = hasCornersIn(faces) && hasCornersIn(strips);
    if (!vertices->HasScalar("x") || !vertices->HasScalar("y") || !vertices->HasScalar("z") ||
      !hasCorners)
    {
      Reject(this->Path, "its header has no x, y, z or no list of vertex_indices");
    }
    this->Header.Vertices = vertices->Count;
    const auto isSurface = [](const PlyElement& element)
    { return element.Name == "vertex" || element.Name == "face" || element.Name == "tristrips"; };
    const std::vector<PlyElement>& elements = this->Header.Elements;
    const std::ptrdiff_t most = faces && strips ? 3 : 2;
    if (std::count_if(elements.begin(), elements.end(), isSurface) > most)
    {
      Reject(this->Path, "its header has an element 'vertex', 'face' or 'tristrips' twice");
    }
  }

  /// Before anything is read: what is announced must fit into the file at all.
  void CheckSize()
  {
    const auto size = static_cast<double>(std::filesystem::file_size(FilePath(this->Path)));
    double least = 0.0;
    for (const PlyElement& element : this->Header.Elements)
    {
      if (element.Count > 0 && element.Properties.empty())
      {
        Reject(this->Path,
          "its header has the element '" + PrintableText(element.Name) + "' without a property");
      }
      for (const PlyProperty& property : element.Properties)
      {
        const std::size_t binary =
          BytesOfPlyType(property.IsList() ? property.CountType : property.Type);
        least += static_cast<double>(element.Count) *
          (this->Header.IsText ? 2.0 : static_cast<double>(binary));
      }
    }
    if (least > size)
    {
      Reject(this->Path,
        "its header announces more than the file's " + std::to_string(std::uintmax_t(size)) +
          " bytes");
    }
  }

  const std::string& Path;
  LineReader& Lines;
  PlyHeader Header;
  bool HasFormat = false;
  int Properties = 0;
};
}

bool PlyProperty::IsList() const
{
  return this->CountType != VTK_VOID;
}

std::size_t PlyElement::IndexOf(const std::string& name) const
{
  const auto found = std::find_if(this->Properties.begin(), this->Properties.end(),
    [&](const PlyProperty& property) { return property.Name == name; });
  return static_cast<std::size_t>(found - this->Properties.begin());
}

bool PlyElement::HasScalar(const std::string& name) const
{
  const std::size_t index = this->IndexOf(name);
  return index < this->Properties.size() && !this->Properties[index].IsList();
}

PlyHeader ReadPlyHeader(const std::string& path, LineReader& lines)
{
  return HeaderReader(path, lines).Run();
}

std::size_t BytesOfPlyType(int type)
{
  return static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type));
}

bool IsWholeNumber(int type)
{
  return type != VTK_VOID && type != VTK_FLOAT && type != VTK_DOUBLE;
}
}
