// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreeMfModel.h"

#include "Base/Text.h"
#include "LineReader.h"

#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <cstdlib>

namespace bonedecimate
{
namespace
{
const std::pair<const char*, double> UnitsOfThreeMf[] = { { "micron", 1e-3 }, { "millimeter", 1.0 },
  { "centimeter", 10.0 }, { "inch", 25.4 }, { "foot", 304.8 }, { "meter", 1000.0 } };

constexpr std::string_view CoreNamespace =
  "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

/// Extensions that change no position of a mesh; parts of others (production) are read.
const std::string_view KnownExtensions[] = { CoreNamespace,
  "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
  "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
  "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07" };

/// Stacks of slices of an object, which may be finer than its mesh.
constexpr std::string_view SliceNamespace =
  "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07";

constexpr std::string_view BeamNamespace =
  "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02";

LabelColor ColorOfCode(std::string_view code)
{
  const auto number =
    code.size() >= 7 ? std::strtoul(std::string(code.substr(1, 6)).c_str(), nullptr, 16) : 0UL;
  return { static_cast<unsigned char>(number >> 16 & 0xFF),
    static_cast<unsigned char>(number >> 8 & 0xFF), static_cast<unsigned char>(number & 0xFF) };
}
}

/// What the model has, as its elements begin.
class ThreeMfParser::Elements : public vtkXMLParser
{
public:
  static Elements* New();
  vtkTypeMacro(Elements, vtkXMLParser);

  std::string Problem; ///< The first one, a sentence; empty: none.
  std::string StartPart;
  ThreeMfPart Part;

protected:
  using Attributes = const char**;

  static std::string_view ValueOf(Attributes attributes, std::string_view name)
  {
    for (; *attributes != nullptr; attributes += 2)
    {
      if (name == attributes[0])
      {
        return attributes[1];
      }
    }
    return {};
  }

  void StartElement(const char* element, Attributes attributes) override
  {
    const std::string_view full = element;
    const std::size_t colon = full.find(':');
    const std::string_view prefix =
      colon == std::string_view::npos ? std::string_view() : full.substr(0, colon);
    const std::string_view name = colon == std::string_view::npos ? full : full.substr(colon + 1);
    if (name == "model")
    {
      this->BeginModel(attributes);
    }
    if (prefix.empty())
    {
      if (this->IsPlainCore)
      {
        this->StartCoreElement(name, attributes);
      }
      return;
    }
    const std::string_view space = this->NamespaceOf(prefix);
    this->Part.HasBeams = this->Part.HasBeams || (name == "beam" && space == BeamNamespace);
    if (space == CoreNamespace)
    {
      this->StartCoreElement(name, attributes);
    }
  }

  void EndElement(const char*) override { this->IsApplication = false; }

  void CharacterDataHandler(const char* text, int length) override
  {
    if (this->IsApplication)
    {
      this->IsOwn =
        std::string_view(text, static_cast<std::size_t>(length)).rfind("bonedecimate ", 0) == 0;
      this->IsApplication = false;
    }
  }

private:
  void StartCoreElement(std::string_view name, Attributes attributes)
  {
    if (name == "vertex")
    {
      this->AddVertex(attributes);
    }
    else if (name == "triangle")
    {
      this->AddTriangle(attributes);
    }
    else if (name == "object" && this->CanKeepAnother())
    {
      this->AddObject(attributes);
    }
    else if (name == "base")
    {
      this->Colors.push_back(ColorOfCode(ValueOf(attributes, "displaycolor")));
    }
    else if (name == "metadata")
    {
      this->IsApplication = ValueOf(attributes, "name") == "Application";
    }
    else if (name == "component" && this->Object != nullptr && this->CanKeepAnother())
    {
      this->Object->Components.push_back(this->ReferenceOf(attributes));
    }
    else if (name == "item" && this->CanKeepAnother())
    {
      this->Part.Build.push_back(this->ReferenceOf(attributes));
    }
    else if (name == "Relationship")
    {
      const std::string_view type = ValueOf(attributes, "Type");
      const std::string_view ending = "/3dmodel";
      const bool isStart = type.size() > ending.size() &&
        type.substr(type.size() - ending.size()) == ending && this->StartPart.empty();
      this->StartPart = isStart ? std::string(ValueOf(attributes, "Target")) : this->StartPart;
    }
  }

  void Fail(const std::string& problem)
  {
    this->Problem = this->Problem.empty() ? problem : this->Problem;
  }

  /// Another object, component or item may be kept.
  bool CanKeepAnother()
  {
    constexpr std::int64_t most = 1000000;
    if (++this->Kept > most)
    {
      this->Fail("it has more than a million objects, components and items");
    }
    return this->Kept <= most;
  }

  std::string_view NamespaceOf(std::string_view prefix) const
  {
    const auto found = this->Namespaces.find(std::string(prefix));
    return found == this->Namespaces.end() ? std::string_view() : std::string_view(found->second);
  }

  void BeginModel(Attributes attributes)
  {
    for (Attributes a = attributes; *a != nullptr; a += 2)
    {
      const std::string_view name = a[0];
      if (name == "xmlns" || name.rfind("xmlns:", 0) == 0)
      {
        this->Namespaces[std::string(name.substr(std::min<std::size_t>(6, name.size())))] = a[1];
      }
    }
    const std::string_view plain = this->NamespaceOf({});
    this->IsPlainCore = plain.empty() || plain == CoreNamespace;
    for (const auto& [name, factor] : UnitsOfThreeMf)
    {
      this->Part.Factor = ValueOf(attributes, "unit") == name ? factor : this->Part.Factor;
    }
    std::vector<std::string_view> required;
    SplitWords(ValueOf(attributes, "requiredextensions"), required);
    for (const std::string_view prefix : required)
    {
      const std::string_view space = this->NamespaceOf(prefix);
      if (std::find(std::begin(KnownExtensions), std::end(KnownExtensions), space) ==
        std::end(KnownExtensions))
      {
        this->Fail("it requires the extension '" +
          std::string(space.empty() ? prefix : space).substr(0, 100) + "', which is not read");
      }
    }
  }

  /// The path of another part has the prefix of the production extension, whatever that is.
  ThreeMfReference ReferenceOf(Attributes attributes)
  {
    ThreeMfReference reference;
    reference.Object = std::string(ValueOf(attributes, "objectid"));
    for (Attributes a = attributes; *a != nullptr; a += 2)
    {
      const std::string_view name = a[0];
      const bool isPath = name.size() > 5 && name.substr(name.size() - 5) == ":path";
      reference.Path = isPath ? a[1] : reference.Path;
    }
    const std::string_view printable = ValueOf(attributes, "printable");
    reference.IsPrintable = printable != "0" && printable != "false";
    const std::optional<ThreeMfTransform> transform =
      ThreeMfTransform::FromText(ValueOf(attributes, "transform"));
    if (!transform)
    {
      this->Fail("a transform is not twelve numbers");
      return reference;
    }
    reference.Transform = *transform;
    return reference;
  }

  void AddObject(Attributes attributes)
  {
    ThreeMfObject object;
    const std::string_view type = ValueOf(attributes, "type");
    object.Type = type.empty() ? object.Type : std::string(type);
    this->ReadSlices(attributes);
    const std::optional<std::int64_t> label =
      ParseNumber<std::int64_t>(ValueOf(attributes, "partnumber"));
    if (this->IsOwn && label)
    {
      NamedLabel named;
      named.Value = *label;
      named.Name = std::string(ValueOf(attributes, "name"));
      const auto index = ParseNumber<std::int64_t>(ValueOf(attributes, "pindex")).value_or(-1);
      if (index >= 0 && index < static_cast<std::int64_t>(this->Colors.size()))
      {
        named.Color = this->Colors[static_cast<std::size_t>(index)];
      }
      object.Mesh.Label = named;
    }
    const std::string id = std::string(ValueOf(attributes, "id"));
    const auto [entry, isNew] = this->Part.Objects.emplace(id, std::move(object));
    if (!isNew)
    {
      this->Fail("two objects have the id '" + id.substr(0, 40) + "'");
    }
    this->Object = &entry->second;
  }

  void ReadSlices(Attributes attributes)
  {
    for (Attributes a = attributes; *a != nullptr; a += 2)
    {
      const std::string_view name = a[0];
      const std::size_t colon = name.find(':');
      if (colon == std::string_view::npos ||
        this->NamespaceOf(name.substr(0, colon)) != SliceNamespace)
      {
        continue;
      }
      this->Part.HasSlices = true;
      if (name.substr(colon + 1) == "meshresolution" && a[1] == std::string_view("lowres"))
      {
        this->Fail("an object has its shape in slices (meshresolution lowres), which are not read; "
                   "its mesh is a stand-in");
      }
    }
  }

  /// As readers of single precision have it.
  void AddVertex(Attributes attributes)
  {
    std::array<double, 3> point = {};
    const char* const names[] = { "x", "y", "z" };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::optional<double> coordinate =
        ParseNumber<double>(ValueOf(attributes, names[axis]));
      if (!coordinate || this->Object == nullptr)
      {
        this->Fail("a vertex is not three numbers");
        return;
      }
      point[axis] = static_cast<double>(static_cast<float>(*coordinate));
    }
    this->Object->Mesh.Points.push_back(point);
  }

  void AddTriangle(Attributes attributes)
  {
    for (const char* name : { "v1", "v2", "v3" })
    {
      const std::optional<std::int64_t> corner =
        ParseNumber<std::int64_t>(ValueOf(attributes, name));
      if (!corner || *corner < 0 || *corner > UINT32_MAX || this->Object == nullptr)
      {
        this->Fail("a triangle is not three indices");
        return;
      }
      this->Object->Mesh.Corners.push_back(static_cast<std::uint32_t>(*corner));
    }
  }

  std::map<std::string, std::string> Namespaces; // by prefix
  bool IsPlainCore = true; // whether elements without a prefix are those of the core specification
  std::int64_t Kept = 0;   // objects, components and items
  bool IsApplication = false;
  bool IsOwn = false;
  std::vector<LabelColor> Colors;
  ThreeMfObject* Object = nullptr; // that is read
};
vtkStandardNewMacro(ThreeMfParser::Elements);

ThreeMfParser::ThreeMfParser()
  : Internal(Elements::New())
{
}

ThreeMfParser::~ThreeMfParser()
{
  if (this->IsOpen)
  {
    this->Finish();
  }
  this->Internal->Delete();
}

void ThreeMfParser::Open()
{
  if (!this->IsOpen)
  {
    this->Internal->InitializeParser();
    this->IsOpen = true;
  }
}

std::string ThreeMfParser::Add(std::string_view piece)
{
  this->Open();
  const bool isValid =
    this->Internal->ParseChunk(piece.data(), static_cast<unsigned int>(piece.size())) != 0;
  return isValid || !this->Internal->Problem.empty() ? this->Internal->Problem
                                                     : "its model is damaged";
}

std::string ThreeMfParser::Finish()
{
  this->Open();
  const bool isValid = this->Internal->CleanupParser() != 0;
  this->IsOpen = false;
  return isValid || !this->Internal->Problem.empty() ? this->Internal->Problem
                                                     : "its model is damaged";
}

ThreeMfPart& ThreeMfParser::Part()
{
  return this->Internal->Part;
}

const std::string& ThreeMfParser::StartPart() const
{
  return this->Internal->StartPart;
}
}
