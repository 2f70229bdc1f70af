// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SummaryCommand.h"

#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "Batch/BatchTable.h"
#include "Batch/FolderRows.h"
#include "CommandLine.h"
#include "ExitCode.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace bonedecimate
{
namespace
{
struct SummaryArguments
{
  std::string Folder;
  bool Quiet = false;
};

ExitCode Run(const SummaryArguments& arguments)
{
  const std::vector<BatchRow> rows = RowsOfFolder(arguments.Folder);
  if (rows.empty())
  {
    throw Failure(ExitCode::InputRejected, "no report is in '" + arguments.Folder + "'");
  }
  const std::string table = WriteTables(arguments.Folder, rows);
  if (!arguments.Quiet)
  {
    const std::size_t width = WidthOfNames(rows);
    std::cout << BatchHeading(width) << "\n";
    for (const BatchRow& row : rows)
    {
      std::cout << BatchLine(row, width) << "\n";
    }
    std::cout << BatchCounts(rows) << "; table: " << table << "\n";
  }
  return WorstCodeOf(rows);
}
}

void AddSummaryCommand(CLI::App& program, ExitCode& code)
{
  const auto arguments = std::make_shared<SummaryArguments>();
  CLI::App& command = AddCommand(program, "summary", { "FOLDER [OPTIONS]" },
    "Writes summary.csv of a folder of results from the reports in it and the logs of failed "
    "inputs, whatever batches wrote them. A report that cannot be read, and a surface that is "
    "missing or of another size than in its report, counts as failed; the exit code is that of "
    "the worst input.");
  command.add_option("FOLDER", arguments->Folder, WrappedHelp("The output folder of batches."))
    ->type_name("")
    ->required();
  AddQuiet(command, arguments->Quiet);
  command.final_callback([arguments, &code] { code = Run(*arguments); });
}
}
