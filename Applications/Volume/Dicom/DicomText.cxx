// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomText.h"

#include "Readers/Encoding.h"
#include "Readers/TextNumbers.h"

#include <algorithm>
#include <map>

namespace bonedecimate::volume
{
namespace
{
/// Defined terms of DICOM and what iconv calls them. Files without one are to be ASCII, but those
/// with more are Latin 1 as a rule.
std::string NameForIconv(const std::string& term)
{
  static const std::map<std::string, std::string> names{ { "", "ISO-8859-1" },
    { "ISO_IR 6", "ISO-8859-1" }, { "ISO_IR 100", "ISO-8859-1" }, { "ISO_IR 101", "ISO-8859-2" },
    { "ISO_IR 109", "ISO-8859-3" }, { "ISO_IR 110", "ISO-8859-4" }, { "ISO_IR 144", "ISO-8859-5" },
    { "ISO_IR 127", "ISO-8859-6" }, { "ISO_IR 126", "ISO-8859-7" }, { "ISO_IR 138", "ISO-8859-8" },
    { "ISO_IR 148", "ISO-8859-9" }, { "ISO_IR 203", "ISO-8859-15" }, { "ISO_IR 166", "TIS-620" },
    { "ISO_IR 192", "UTF-8" }, { "GB18030", "GB18030" }, { "GBK", "GBK" } };
  const auto found = names.find(term);
  return found == names.end() ? "ASCII" : found->second;
}

/// From the defined term of one encoding or of its variant with extensions.
std::string FirstTerm(const std::string& characterSet)
{
  std::string term = Trimmed(characterSet.substr(0, characterSet.find('\\')));
  const std::string extended = "ISO 2022 IR";
  return term.compare(0, extended.size(), extended) == 0 ? "ISO_IR" + term.substr(extended.size())
                                                         : term;
}
}

std::string Utf8Of(const std::string& text, const std::string& characterSet)
{
  return Utf8From(text, NameForIconv(FirstTerm(characterSet)));
}
}
