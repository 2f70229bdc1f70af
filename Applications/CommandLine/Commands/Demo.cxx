// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Demo.h"

#include "Arguments/Arguments.h"
#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "CommandLine.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Files/StagedFile.h"
#include "PhantomScan.h"
#include "PlainText.h"
#include "Report/Summary.h"
#include "Runs/RunOne.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>

namespace bonedecimate
{
namespace
{
constexpr const char* ThresholdOfBone = "226"; // HU
constexpr const char* LargestError = "0.5";    // mm

bool HaveSameBytes(const std::string& a, const std::string& b)
{
  using Bytes = std::istreambuf_iterator<char>;
  std::ifstream one(FilePath(a), std::ios::binary);
  std::ifstream two(FilePath(b), std::ios::binary);
  return std::equal(Bytes(one), Bytes(), Bytes(two), Bytes());
}

/// @throws Failure(ExitCode::Usage) if another file of that name is there.
std::string WriteScan(const std::string& path, phantom::Content content)
{
  std::error_code error;
  std::filesystem::create_directories(FilePath(path).parent_path(), error);
  StagedFile file(path);
  if (error || !phantom::WriteScan(file.GetTemporary(), *phantom::FindScan("small"), content))
  {
    throw Failure(ExitCode::CouldNotWrite, "could not write '" + path + "'");
  }
  if (std::filesystem::exists(FilePath(path), error) && !HaveSameBytes(path, file.GetTemporary()))
  {
    throw Failure(ExitCode::Usage,
      "'" + path + "' is there and is not the phantom's; give demo another folder");
  }
  file.Commit();
  return path;
}

void Run(const std::string& folder)
{
  Arguments arguments;
  WriteScan(folder + "/labels.mha", phantom::Content::Labels);
  arguments.Inputs = { WriteScan(folder + "/ct.mha", phantom::Content::Intensities),
    folder + "/bone.vtp" };
  arguments.Also = { folder + "/bone.stl" };
  arguments.Report = folder + "/report.json";
  arguments.Page = folder + "/report.html";
  arguments.Iso = std::stod(ThresholdOfBone);
  arguments.Given["iso"] = ThresholdOfBone;
  GiveOption(arguments, *FindOption("MaximumError"), LargestError);
  arguments.Quiet = true;
  std::cout << "bonedecimate " << PlainText(arguments.Inputs[0]) << " "
            << PlainText(arguments.Inputs[1]) << " --iso " << ThresholdOfBone << " --max-error "
            << LargestError << " --also " << PlainText(arguments.Also[0]) << " --report "
            << PlainText(arguments.Report) << " --page " << PlainText(arguments.Page) << "\n"
            << std::flush;
  TakeFiles(arguments);
  CheckArguments(arguments);
  PrintShortSummary(RunOne(arguments));
  std::cout << "A label map of the same bones for trying --segments: "
            << PlainText(folder + "/labels.mha") << "\n"
            << "Open " << PlainText(arguments.Page) << " in a browser.\n";
}
}

void AddDemoCommand(CLI::App& program)
{
  const auto folder = std::make_shared<std::string>("bonedecimate-demo");
  CLI::App& command = AddCommand(program, "demo", { "[FOLDER]" },
    "Writes the CT of a phantom of a broken bone into a folder, its label map, and the bone with "
    "at most 0.5 mm of error, its report and its page; prints the command that does the same with "
    "another CT.");
  command
    .add_option("FOLDER", *folder, WrappedHelp("Where the files go. Default bonedecimate-demo."))
    ->type_name("");
  command.final_callback([folder] { Run(*folder); });
}
}
