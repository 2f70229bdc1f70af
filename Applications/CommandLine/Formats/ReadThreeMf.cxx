// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// The model passes from the archive to the parser in small pieces, so that a damaged archive cannot claim much memory.
#ifdef BONEDECIMATE_HAS_LIBZIP

#include "FileChecks.h"
#include "FileParts.h"
#include "Options/Text.h"
#include "ThreeMfFiles.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <zip.h>

namespace bonedecimate
{
namespace
{
const std::pair<const char*, double> Units[] = { { "micron", 1e-3 }, { "millimeter", 1.0 },
  { "centimeter", 10.0 }, { "inch", 25.4 }, { "foot", 304.8 }, { "meter", 1000.0 } };

/// What the model has, as its elements begin.
class ModelParser : public vtkXMLParser
{
public:
  static ModelParser* New();
  vtkTypeMacro(ModelParser, vtkXMLParser);

  std::string Problem; ///< The first one, a sentence; empty: none.
  std::vector<FilePart> Parts;

  /// Every index of a triangle is one of a vertex that was read.
  bool HasWholeTriangles() const
  {
    return std::all_of(this->Parts.begin(), this->Parts.end(),
      [](const FilePart& part)
      {
        return std::all_of(part.Corners.begin(), part.Corners.end(),
          [&part](std::uint32_t corner) { return corner < part.Points.size(); });
      });
  }

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
    const std::string_view name = element;
    if (name == "vertex")
    {
      this->AddVertex(attributes);
    }
    else if (name == "triangle")
    {
      this->AddTriangle(attributes);
    }
    else if (name == "object")
    {
      this->AddObject(attributes);
    }
    else if (name == "base")
    {
      this->Colors.push_back(ColorOf(ValueOf(attributes, "displaycolor")));
    }
    else if (name == "model")
    {
      this->SetUnit(ValueOf(attributes, "unit"));
    }
    else if (name == "metadata")
    {
      this->IsApplication = ValueOf(attributes, "name") == "Application";
    }
    else if (name == "component" || (name == "item" && !ValueOf(attributes, "transform").empty()))
    {
      this->Fail("it has components or transforms, which are not read");
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
  void Fail(const std::string& problem)
  {
    this->Problem = this->Problem.empty() ? problem : this->Problem;
  }

  void SetUnit(std::string_view unit)
  {
    for (const auto& [name, factor] : Units)
    {
      this->Factor = unit == name ? factor : this->Factor;
    }
  }

  static LabelColor ColorOf(std::string_view code)
  {
    const auto number =
      code.size() >= 7 ? std::strtoul(std::string(code.substr(1, 6)).c_str(), nullptr, 16) : 0UL;
    return { static_cast<unsigned char>(number >> 16 & 0xFF),
      static_cast<unsigned char>(number >> 8 & 0xFF), static_cast<unsigned char>(number & 0xFF) };
  }

  void AddObject(Attributes attributes)
  {
    FilePart part;
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
      part.Label = named;
    }
    this->Parts.push_back(std::move(part));
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
      if (!coordinate || this->Parts.empty())
      {
        this->Fail("a vertex is not three numbers");
        return;
      }
      point[axis] = this->Factor * static_cast<double>(static_cast<float>(*coordinate));
    }
    this->Parts.back().Points.push_back(point);
  }

  void AddTriangle(Attributes attributes)
  {
    for (const char* name : { "v1", "v2", "v3" })
    {
      const std::optional<std::int64_t> corner =
        ParseNumber<std::int64_t>(ValueOf(attributes, name));
      if (!corner || *corner < 0 || *corner > UINT32_MAX || this->Parts.empty())
      {
        this->Fail("a triangle is not three indices");
        return;
      }
      this->Parts.back().Corners.push_back(static_cast<std::uint32_t>(*corner));
    }
  }

  double Factor = 1.0; // mm of the unit
  bool IsApplication = false;
  bool IsOwn = false;
  std::vector<LabelColor> Colors;
};
vtkStandardNewMacro(ModelParser);

/// Passes the model to the parser; the problem is a sentence, empty if there is none.
std::string Parse(const std::string& path, ModelParser* parser)
{
  int error = 0;
  const std::unique_ptr<zip_t, void (*)(zip_t*)> archive(
    zip_open(path.c_str(), ZIP_RDONLY, &error), zip_discard);
  if (archive == nullptr)
  {
    return "it is not a ZIP archive, or it is cut off";
  }
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> model(
    zip_fopen(archive.get(), ThreeMfModel, 0), zip_fclose);
  if (model == nullptr)
  {
    return std::string("it has no ") + ThreeMfModel;
  }
  constexpr std::size_t pieceBytes = 1U << 16;
  std::string piece(pieceBytes, '\0');
  parser->InitializeParser();
  zip_int64_t count = 0;
  bool isValid = true;
  while (isValid && parser->Problem.empty() &&
    (count = zip_fread(model.get(), piece.data(), piece.size())) > 0)
  {
    isValid = parser->ParseChunk(piece.data(), static_cast<unsigned int>(count)) != 0;
  }
  isValid = parser->CleanupParser() != 0 && isValid && count == 0;
  return isValid || !parser->Problem.empty() ? parser->Problem : "its model is damaged";
}
}

vtkSmartPointer<vtkPolyData> ReadThreeMfFile(const std::string& path, std::vector<std::string>&)
{
  const vtkNew<ModelParser> parser;
  const std::string problem = Parse(path, parser);
  if (!problem.empty())
  {
    Reject(path, problem);
  }
  if (!parser->HasWholeTriangles())
  {
    Reject(path, "a triangle has a vertex that is not there");
  }
  return JoinParts(parser->Parts);
}
}

#endif
