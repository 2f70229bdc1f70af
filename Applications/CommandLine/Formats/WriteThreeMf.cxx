// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifdef BONEDECIMATE_HAS_LIBZIP

#include "Base/Text.h"
#include "ExitCode.h"
#include "FileParts.h"
#include "Run/Report/Report.h"
#include "TextOutput.h"
#include "ThreeMfFiles.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <string_view>
#include <zip.h>

namespace bonedecimate
{
namespace
{
constexpr const char* ContentTypes =
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
  "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
  "<Default Extension=\"rels\" "
  "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
  "<Default Extension=\"model\" "
  "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
constexpr const char* Relationships =
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
  "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
  "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
  "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
constexpr int MaterialId = 1;

/// The model in XML.
class ModelComposer
{
public:
  std::string Compose(const std::vector<FilePart>& parts)
  {
    this->Text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" "
                 "xml:lang=\"en-US\" "
                 "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                 "<metadata name=\"Application\">bonedecimate " +
      std::string(Version()) + "</metadata>\n<resources>\n";
    this->AddMaterials(parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      this->AddObject(parts[i], i);
    }
    this->Text += "</resources>\n<build>\n";
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      this->Text += "<item objectid=\"" + IdOf(i) + "\"/>\n";
    }
    return this->Text + "</build>\n</model>\n";
  }

private:
  static std::string IdOf(std::size_t part) { return std::to_string(MaterialId + 1 + part); }

  static std::string NameOf(const NamedLabel& label)
  {
    return EscapedXml(label.Name.empty() ? std::to_string(label.Value) : label.Name);
  }

  void AddMaterials(const std::vector<FilePart>& parts)
  {
    std::string materials;
    for (const FilePart& part : parts)
    {
      if (part.Label)
      {
        const LabelColor color = part.Label->Color.value_or(LabelColor{});
        std::array<char, 8> code = {};
        std::snprintf(code.data(), code.size(), "#%02X%02X%02X", color[0], color[1], color[2]);
        materials +=
          "<base name=\"" + NameOf(*part.Label) + "\" displaycolor=\"" + code.data() + "\"/>";
      }
    }
    if (!materials.empty())
    {
      this->Text += "<basematerials id=\"" + std::to_string(MaterialId) + "\">" + materials +
        "</basematerials>\n";
    }
  }

  void AddObject(const FilePart& part, std::size_t number)
  {
    this->Text +=
      "<object id=\"" + IdOf(number) + "\" type=\"" + (IsClosed(part) ? "model" : "surface") + "\"";
    if (part.Label)
    {
      this->Text += " name=\"" + NameOf(*part.Label) + "\" partnumber=\"" +
        std::to_string(part.Label->Value) + "\" pid=\"" + std::to_string(MaterialId) +
        "\" pindex=\"" + std::to_string(number) + "\"";
    }
    this->Text += "><mesh>\n<vertices>\n";
    for (const std::array<double, 3>& point : part.Points)
    {
      this->Text += "<vertex";
      this->AddAttribute(" x=\"", point[0]);
      this->AddAttribute(" y=\"", point[1]);
      this->AddAttribute(" z=\"", point[2]);
      this->Text += "/>\n";
    }
    this->Text += "</vertices>\n<triangles>\n";
    for (std::size_t i = 0; i + 2 < part.Corners.size(); i += 3)
    {
      this->Text += "<triangle v1=\"" + std::to_string(part.Corners[i]) + "\" v2=\"" +
        std::to_string(part.Corners[i + 1]) + "\" v3=\"" + std::to_string(part.Corners[i + 2]) +
        "\"/>\n";
    }
    this->Text += "</triangles>\n</mesh></object>\n";
  }

  /// The decimal that equals the nearest single number, so that readers of any precision have the
  /// same one.
  void AddAttribute(const char* begin, double coordinate)
  {
    const float single = static_cast<float>(coordinate);
    constexpr int mantissaBits = std::numeric_limits<float>::digits - 1;
    constexpr int mostDigits = 149; // of the smallest number
    const int digitsBehindPoint =
      single == 0.0F ? 0 : std::clamp(mantissaBits - std::ilogb(single), 0, mostDigits);
    std::array<char, 256> digits = {};
    const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(),
      static_cast<double>(single), std::chars_format::fixed, digitsBehindPoint);
    std::string_view text(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
    while (digitsBehindPoint > 0 && text.back() == '0')
    {
      text.remove_suffix(1);
    }
    text.remove_suffix(text.back() == '.' ? 1 : 0);
    this->Text += begin;
    this->Text += text;
    this->Text += '"';
  }

  std::string Text;
};

[[noreturn]] void Fail(const char* what)
{
  throw Failure(ExitCode::CouldNotWrite, std::string("the archive could not be made: ") + what);
}

/// An archive in memory, so that the file is written in place.
class Archive
{
public:
  Archive()
    : Source(zip_source_buffer_create(nullptr, 0, 0, nullptr))
    , Zip(this->Source ? zip_open_from_source(this->Source, ZIP_TRUNCATE, nullptr) : nullptr)
  {
    if (this->Zip == nullptr)
    {
      Fail("no memory");
    }
    zip_source_keep(this->Source);
  }
  ~Archive()
  {
    if (this->Zip != nullptr)
    {
      zip_discard(this->Zip);
    }
    zip_source_free(this->Source);
  }
  Archive(const Archive&) = delete;
  void operator=(const Archive&) = delete;

  /// @param content Must live until Bytes(). The time is always the same, and so are the bytes.
  void Add(const char* name, const std::string& content)
  {
    constexpr zip_uint16_t firstDay = 0x21; // of 1980
    zip_source_t* const part = zip_source_buffer(this->Zip, content.data(), content.size(), 0);
    const zip_int64_t index = part ? zip_file_add(this->Zip, name, part, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0 ||
      zip_file_set_dostime(this->Zip, static_cast<zip_uint64_t>(index), 0, firstDay, 0) != 0)
    {
      Fail(zip_strerror(this->Zip));
    }
  }

  std::string Bytes()
  {
    if (zip_close(this->Zip) != 0)
    {
      Fail(zip_strerror(this->Zip));
    }
    this->Zip = nullptr;
    zip_stat_t status;
    zip_stat_init(&status);
    if (zip_source_stat(this->Source, &status) != 0 || zip_source_open(this->Source) != 0)
    {
      Fail("its bytes are lost");
    }
    std::string bytes(status.size, '\0');
    const zip_int64_t count = zip_source_read(this->Source, bytes.data(), bytes.size());
    zip_source_close(this->Source);
    if (count != static_cast<zip_int64_t>(bytes.size()))
    {
      Fail("its bytes are lost");
    }
    return bytes;
  }

private:
  zip_source_t* Source;
  zip_t* Zip;
};
}

void WriteThreeMfFile(vtkPolyData* surface, const std::string& path)
{
  const std::string model = ModelComposer().Compose(PartsOf(surface));
  const std::string types = ContentTypes;
  const std::string relationships = Relationships;
  Archive archive;
  archive.Add("[Content_Types].xml", types);
  archive.Add("_rels/.rels", relationships);
  archive.Add(ThreeMfModel, model);
  const std::string bytes = archive.Bytes();
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream)
  {
    throw Failure(ExitCode::CouldNotWrite, WriteProblem());
  }
}
}

#endif
