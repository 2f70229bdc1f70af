// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels/LabelTable.h"

#include "Base/Text.h"
#include "Readers/NiftiExtensions.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace bonedecimate
{
namespace
{
/// <Label Key="1" Red="1" Green="0" Blue="0">Name</Label> in a <LabelTable>.
class LabelElements : public vtkXMLParser
{
public:
  static LabelElements* New();
  vtkTypeMacro(LabelElements, vtkXMLParser);

  LabelTable Table;

protected:
  void StartElement(const char* element, const char** attributes) override
  {
    const std::string_view name = element;
    this->IsInTable = this->IsInTable || name == "LabelTable";
    this->IsLabel = this->IsInTable && name == "Label";
    if (this->IsLabel)
    {
      this->Text.clear();
      this->Begin(attributes);
    }
  }

  void EndElement(const char* element) override
  {
    const std::string_view name = element;
    if (this->IsLabel && name == "Label")
    {
      constexpr const char* blanks = " \t\r\n";
      this->Text.erase(this->Text.find_last_not_of(blanks) + 1);
      this->Text.erase(0, std::min(this->Text.find_first_not_of(blanks), this->Text.size()));
      this->Table.Labels.back().Name = this->Text;
      this->IsLabel = false;
    }
    this->IsInTable = this->IsInTable && name != "LabelTable";
  }

  void CharacterDataHandler(const char* text, int length) override
  {
    if (this->IsLabel)
    {
      this->Text.append(text, static_cast<std::size_t>(length));
    }
  }

  /// VTK would tell the terminal.
  void ReportXmlParseError() override {}

private:
  void Begin(const char** attributes)
  {
    std::optional<std::int64_t> key;
    LabelColor color = {};
    int components = 0;
    for (; *attributes != nullptr; attributes += 2)
    {
      const std::string_view name = attributes[0];
      const std::optional<double> number = ParseNumber<double>(attributes[1]);
      const std::size_t axis = name == "Red" ? 0 : name == "Green" ? 1 : name == "Blue" ? 2 : 3;
      if (name == "Key")
      {
        key = ParseNumber<std::int64_t>(attributes[1]);
      }
      else if (axis < 3 && number && *number >= 0.0 && *number <= 1.0)
      {
        color[axis] = static_cast<unsigned char>(std::lround(255.0 * *number));
        ++components;
      }
    }
    if (!key)
    {
      this->Table.Problem = "a label has no whole number";
    }
    this->Table.Labels.push_back(
      { key.value_or(0), {}, components == 3 ? std::optional<LabelColor>(color) : std::nullopt });
  }

  std::string Text;
  bool IsInTable = false;
  bool IsLabel = false;
};
vtkStandardNewMacro(LabelElements);
}

LabelTable ReadLabelsOfHeader(const std::string& path)
{
  for (const std::string& text : ReadNiftiExtensions(path))
  {
    if (text.find("<LabelTable") == std::string::npos)
    {
      continue;
    }
    const vtkNew<LabelElements> parser;
    const bool isValid = parser->Parse(text.c_str(), static_cast<unsigned int>(text.size())) != 0;
    LabelTable table = parser->Table;
    if (!isValid && table.Problem.empty())
    {
      table.Problem = "its XML is damaged";
    }
    if (table.Problem.empty())
    {
      CompleteTable(table);
    }
    return table;
  }
  return {};
}
}
