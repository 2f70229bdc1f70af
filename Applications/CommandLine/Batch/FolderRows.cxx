// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FolderRows.h"

#include "ExitCode.h"
#include "FailureLog.h"
#include "FilePath.h"
#include "FolderEntries.h"
#include "Report/JsonReport.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
/// The name that a batch gives to the outputs: report.json lies in a folder of that name.
std::string NameOfReport(const fs::path& file, const fs::path& root)
{
  const fs::path below = file.lexically_relative(root);
  const bool isOfFolder = below.filename() == "report.json" && below.has_parent_path();
  return (isOfFolder ? below.parent_path() : fs::path(below).replace_extension()).generic_string();
}

void Fail(BatchRow& row, const std::string& message)
{
  row.Status = "failed";
  row.Code = ExitCode::InputRejected;
  row.Message = message;
  row.Figures = nullptr;
}

/// What a failed input left, unless a report of that name is there.
std::optional<BatchRow> FailedRow(const fs::path& log, const fs::path& root)
{
  const fs::path base = fs::path(log).replace_extension();
  std::error_code ignored;
  const bool isDone =
    fs::exists(fs::path(base) += ".json", ignored) || fs::exists(base / "report.json", ignored);
  std::optional<BatchRow> row = isDone ? std::nullopt : ReadFailureLog(log.string());
  if (row)
  {
    row->Name = base.lexically_relative(root).generic_string();
  }
  return row;
}

/// Says so in the row if the surfaces of a report are no longer what they were.
void CheckSurfaces(const fs::path& report, BatchRow& row)
{
  const bool isOfFolder = report.filename() == "report.json" &&
    FilePath(row.Output).filename() == report.parent_path().filename();
  const fs::path output =
    isOfFolder ? report.parent_path() : report.parent_path() / FilePath(row.Output).filename();
  if (!OutputMatches(report.string(), output.string()))
  {
    std::error_code ignored;
    const std::string what =
      isOfFolder ? "surfaces" : "surface '" + output.filename().string() + "'";
    Fail(row,
      "the " + what +
        (isOfFolder || fs::exists(output, ignored) ? " changed after the report" : " is missing"));
  }
}

/// The row of a report of this program, or of a file that is no JSON; none if it is other JSON.
std::optional<BatchRow> RowOfReport(const fs::path& file, const fs::path& root)
{
  std::ifstream stream(file, std::ios::binary);
  const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
  BatchRow row;
  row.Name = NameOfReport(file, root);
  if (json.is_discarded())
  {
    Fail(row, "the report '" + file.filename().string() + "' cannot be read");
    return row;
  }
  const nlohmann::json::json_pointer input("/files/input");
  if (!json.is_object() || !json.contains(input) || !json[input].is_string() ||
    !json.contains(nlohmann::json::json_pointer("/output/triangles")))
  {
    return std::nullopt;
  }
  const fs::path folder = fs::path(row.Name).parent_path();
  row.Input = (folder / FilePath(json[input].get<std::string>())).generic_string();
  row.Status = "done";
  row.Code = ExitCode::Done;
  TakeReport(row, file.string());
  CheckSurfaces(file, row);
  return row;
}

void AddRows(const fs::path& folder, const fs::path& root, std::vector<BatchRow>& rows)
{
  std::error_code error;
  for (const fs::path& path : FolderEntries(folder, error))
  {
    std::error_code ignored;
    const bool isHidden = path.filename().string()[0] == '.';
    if (!isHidden && fs::is_directory(path, ignored) && !fs::is_symlink(path, ignored))
    {
      AddRows(path, root, rows);
    }
    std::optional<BatchRow> row = isHidden ? std::nullopt
      : path.extension() == ".log"         ? FailedRow(path, root)
      : path.extension() == ".json"        ? RowOfReport(path, root)
                                           : std::nullopt;
    if (row)
    {
      rows.push_back(std::move(*row));
    }
  }
  if (error)
  {
    throw Failure(
      ExitCode::InputRejected, "'" + folder.string() + "' could not be read: " + error.message());
  }
}
}

std::vector<BatchRow> RowsOfFolder(const std::string& folder)
{
  const fs::path root = FilePath(folder);
  std::vector<BatchRow> rows;
  AddRows(root, root, rows);
  return rows;
}
}
