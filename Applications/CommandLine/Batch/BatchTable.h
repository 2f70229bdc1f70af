// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchTable.h
 * @brief What became of every bone of a batch: summary.csv for programs, a line of a table for
 * people.
 */
#ifndef BoneDecimate_Applications_BatchTable_h
#define BoneDecimate_Applications_BatchTable_h

#include "ExitCode.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bonedecimate
{
struct BatchRow
{
  std::string Name;
  std::string Input; ///< Below the folder that was searched; of a named file its base name.
  std::string Status = "not run"; ///< Or "done", "skipped", "failed", "interrupted".
  ExitCode Code = ExitCode::Interrupted;
  std::string Message;    ///< Why it failed or was skipped, and what its report warns of.
  std::string Note;       ///< Is printed before the message and in no file.
  nlohmann::json Figures; ///< Figures of its report, by column of summary.csv; null: none.
  /// Figures of each segment of a label map, by column of segments.csv.
  std::vector<nlohmann::json> Segments;
  std::string Report;  ///< Path; empty: none.
  std::string Output;  ///< The surface beside the report; empty: there are several.
  std::string Options; ///< Those of its run: "iso=226 max-error=0.5".
};

/// Takes figures and warnings from the file of a report. A report that cannot be read gives none.
void TakeReport(BatchRow& row, const std::string& report);

std::string ComposeCsv(const std::string& folder, const std::vector<BatchRow>& rows);

/// A row for each segment of each input; empty if no input has segments.
std::string ComposeSegmentsCsv(const std::vector<BatchRow>& rows);

/// Writes summary.csv, summary.html, and segments.csv if there are segments, into a folder.
/// @return The path of summary.csv.  @throws Failure(ExitCode::CouldNotWrite)
std::string WriteTables(const std::string& folder, const std::vector<BatchRow>& rows);

/// Characters of the longest name, but at most 60: longer ones move the rest of their lines.
std::size_t WidthOfNames(const std::vector<BatchRow>& rows);

/// The first line of the table.
std::string BatchHeading(std::size_t nameWidth);

/// The line of a row.
/// @param nameWidth Characters of the first column; a longer name moves the rest of its line.
std::string BatchLine(const BatchRow& row, std::size_t nameWidth);

/// What was left out counts less than what failed.
ExitCode WorstCodeOf(const std::vector<BatchRow>& rows);

/// "12 files: 10 done, 1 skipped, 1 failed".
std::string BatchCounts(const std::vector<BatchRow>& rows);
}

#endif
