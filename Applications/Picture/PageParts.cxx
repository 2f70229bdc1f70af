// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PageParts.h"

#include "Base/Text.h"
#include "NumberText.h"
#include "PageTemplate.h"

#include "vtkBase64Utilities.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>

namespace bonedecimate
{
namespace
{
std::string Cell(const std::string& content, const std::string& tag, const std::string& attributes)
{
  return "<" + tag + attributes + ">" + content + "</" + tag + ">";
}
}

std::string PositionText(const ReportFields& report, const std::string& path)
{
  std::string position;
  for (const std::string& name : report.NamesBelow(path))
  {
    position += (position.empty() ? "" : ", ") +
      EscapedXml(MillimeterText(report.Number(name).value_or(0.0)));
  }
  return position;
}

std::string Table(const std::vector<std::vector<std::string>>& rows)
{
  std::string html = "<table>\n";
  bool isHead = true;
  for (const std::vector<std::string>& row : rows)
  {
    std::string line;
    for (const std::string& cell : row)
    {
      if (isHead)
      {
        line += Cell(cell, "th", " scope=\"col\"");
      }
      else
      {
        line += line.empty() ? Cell(cell, "th", " scope=\"row\"") : Cell(cell, "td", "");
      }
    }
    html += Cell(line, "tr", "") + "\n";
    isHead = false;
  }
  return html + "</table>\n";
}

std::string FigureTile(const std::string& figure, const std::string& words, bool hasLoss)
{
  return std::string(hasLoss ? "<div class=\"lost\">" : "<div>") + "<strong>" + figure +
    "</strong>" + words + "</div>\n";
}

//------------------------------------------------------------------------------
std::string Base64(const std::string& bytes)
{
  std::string text(4 * (bytes.size() / 3 + 1), '\0');
  const unsigned long length =
    vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
      static_cast<unsigned long>(bytes.size()), reinterpret_cast<unsigned char*>(text.data()));
  text.resize(bytes.empty() ? 0 : length);
  return text;
}

std::string Base64Of(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return Base64({ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() });
}

std::string EmbeddedPicture(const std::string& file, const std::string& surfaces)
{
  const std::string png = Base64Of(file);
  return png.empty() ? PageBlock("no picture")
                     : PageBlock("picture", { { "png", png }, { "surfaces", surfaces } });
}

std::string DateText()
{
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t time =
    fixed && *fixed ? std::time_t{ std::strtoll(fixed, nullptr, 10) } : std::time(nullptr);
  const std::tm* const utc = std::gmtime(&time);
  char text[40] = "";
  return utc && std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M UTC", utc) > 0 ? text
                                                                                 : "not known";
}

std::size_t BytesOfViewer(std::size_t bytesOfPicture)
{
  constexpr std::size_t most = 20000000;
  constexpr std::size_t text = 200000;
  return most - std::min(most, text + bytesOfPicture);
}
}
