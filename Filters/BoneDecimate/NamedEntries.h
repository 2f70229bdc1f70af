// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NamedEntries.h
 * @brief The entries of a report as the filters hand them out: by number, by name, as number, as
 * text.
 */
#ifndef NamedEntries_h
#define NamedEntries_h

#include "Run/Report/ReportTable.h"

#include <string>
#include <vector>

namespace bonedecimate
{
class NamedEntries
{
public:
  explicit NamedEntries(std::vector<ReportEntry> entries)
    : Entries(std::move(entries))
  {
  }

  const std::vector<ReportEntry>& All() const { return this->Entries; }
  int Count() const { return static_cast<int>(this->Entries.size()); }
  std::string Name(int entry) const;               ///< Empty beyond them.
  std::string Unit(const std::string& name) const; ///< Empty where there is none.
  double Value(const std::string& name) const;     ///< NaN if unknown or a text.
  std::string Text(
    const std::string& name) const; ///< Numbers with all their digits; empty if unknown.

private:
  const ReportEntry* Find(const std::string& name) const;

  std::vector<ReportEntry> Entries;
};
}

#endif
