// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PageTemplate.h"

#include <stdexcept>

namespace bonedecimate
{
namespace
{
std::string TextOf(const std::string& block)
{
  const std::string whole = PageTemplateText;
  const std::string head = "<!-- block " + block + " -->\n";
  const std::size_t begin = whole.find(head);
  if (begin == std::string::npos)
  {
    throw std::logic_error("page.html has no block '" + block + "'");
  }
  const std::size_t first = begin + head.size();
  return whole.substr(first, whole.find("<!-- end -->", first) - first);
}
}

std::string PageBlock(const std::string& block, const std::map<std::string, std::string>& values)
{
  const std::string text = TextOf(block);
  std::string page;
  std::size_t done = 0;
  for (std::size_t open = text.find("{{"); open != std::string::npos; open = text.find("{{", done))
  {
    const std::size_t close = text.find("}}", open);
    const auto value = values.find(text.substr(open + 2, close - open - 2));
    if (value == values.end())
    {
      throw std::logic_error("no value for " + text.substr(open, close + 2 - open));
    }
    page += text.substr(done, open - done) + value->second;
    const bool isLine =
      (open == 0 || text[open - 1] == '\n') && text.compare(close + 2, 1, "\n") == 0;
    done = close + (isLine ? 3 : 2);
  }
  return page + text.substr(done);
}
}
