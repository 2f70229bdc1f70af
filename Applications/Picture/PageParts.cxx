// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PageParts.h"

#include "vtkBase64Utilities.h"

#include <fstream>
#include <iterator>

namespace bonedecimate
{
std::string Escape(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    switch (letter)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

namespace
{
std::string Cell(const std::string& content, const std::string& tag, const std::string& attributes)
{
  return "<" + tag + attributes + ">" + content + "</" + tag + ">";
}
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

std::string EmbeddedPng(const std::string& file, const std::string& alternative)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  if (bytes.empty())
  {
    return {};
  }
  std::string text(4 * (bytes.size() / 3 + 1), '\0');
  const unsigned long length =
    vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
      static_cast<unsigned long>(bytes.size()), reinterpret_cast<unsigned char*>(text.data()));
  text.resize(length);
  return "<img alt=\"" + Escape(alternative) + "\" src=\"data:image/png;base64," + text + "\">";
}

std::string StyleSheet()
{
  return R"(
:root { color-scheme: light dark;
  --ink: #20242a; --quiet: #5b626b; --paper: #ffffff; --line: #d5d9de; --mark: #b43a75; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7ea; --quiet: #a3abb4; --paper: #16191d; --line: #3a4149; --mark: #ee8a8a; }
}
body { margin: 0 auto; padding: 1rem; max-width: 60rem; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, "Liberation Sans", Arial, sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: .5rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin: 1.8rem 0 .5rem; }
p { margin: .5rem 0; }
ul { margin: .5rem 0; padding-left: 1.3rem; }
.notice { border-left: .3rem solid var(--mark); padding: .3rem .8rem; margin: 1rem 0; }
.figures { display: flex; flex-wrap: wrap; gap: .8rem; margin: 1rem 0; }
.figures div { flex: 1 1 12rem; border: 1px solid var(--line); border-radius: .4rem; padding: .6rem .9rem; }
.figures strong { display: block; font-size: 1.5rem; line-height: 1.3; }
.picture { overflow-x: auto; margin: 1rem 0; border: 1px solid var(--line); background: #ffffff; }
.picture img { display: block; width: 100%; min-width: 42rem; height: auto; }
.table { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { border-bottom: 1px solid var(--line); padding: .3rem .5rem; text-align: right; vertical-align: top; }
th { font-weight: 600; }
th[scope=row], tr > :first-child { text-align: left; font-weight: 400; }
.words th, .words td { text-align: left; overflow-wrap: anywhere; }
.words ul { margin: 0; }
.note, figcaption { color: var(--quiet); font-size: .9rem; }
figure { margin: 1rem 0; }
svg { display: block; width: 100%; max-width: 40rem; height: auto; }
svg text { font: 12px system-ui, "Liberation Sans", Arial, sans-serif; fill: var(--ink); }
svg .grid { stroke: var(--line); fill: none; }
svg .curve { stroke: var(--mark); stroke-width: 2.5; fill: none; }
svg .mark { fill: var(--mark); }
@page { size: A4; margin: 14mm; }
@media print {
  :root { --ink: #000000; --quiet: #444444; --paper: #ffffff; --line: #bbbbbb; --mark: #b43a75; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  .picture img { min-width: 0; }
  h2 { break-after: avoid; }
  figure, table, .figures, .notice { break-inside: avoid; }
}
)";
}
}
