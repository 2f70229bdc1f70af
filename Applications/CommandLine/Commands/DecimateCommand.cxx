// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DecimateCommand.h"

#include "Arguments/Arguments.h"
#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "Batch/Batch.h"
#include "BoneVolume.h"
#include "CommandLine.h"
#include "Explain/Explain.h"
#include "FilePath.h"
#include "Formats/SurfaceFormat.h"
#include "Report/CountText.h"
#include "Run/Report/Report.h"
#include "Runs/RunOne.h"
#include "Segments/SegmentOutput.h"
#include "Settings/Settings.h"
#include "Tree/Descriptions.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <system_error>
#include <utility>

namespace bonedecimate
{
namespace
{
/// The three numbers of the thesis's program, in its order, as options of ours.
const std::vector<std::pair<const char*, const char*>> ThesisNumbers = {
  { "numbFaces", "TargetNumberOfTriangles" }, { "tolerance", "NormalTolerance" },
  { "errorThreshold", "MaximumError" }
};

/// With a surface as the output, a folder of folders, as a CD has it, is one volume and no batch.
void TakeFolderOfSeries(const Arguments& arguments)
{
  std::error_code error;
  const bool isOne = arguments.Inputs.size() == 1 && FindFormat(arguments.Output) != nullptr &&
    (arguments.Iso || arguments.Segments.IsRequested());
  if (isOne && std::filesystem::is_directory(FilePath(arguments.Inputs[0]), error))
  {
    TakeSeriesBelow(arguments.Inputs[0]);
  }
}

ExitCode RunOneBone(const Arguments& arguments)
{
  if (arguments.IsExplained)
  {
    return Explain(arguments);
  }
  CheckArguments(arguments);
  RunOne(arguments);
  return ExitCode::Done;
}

ExitCode Decimate(const Arguments& arguments, const std::string& self)
{
  if (arguments.IsExplained || !IsBatch(arguments))
  {
    return RunOneBone(arguments);
  }
  CheckArguments(arguments);
  return RunBatch(arguments, self);
}

void SetThesisWords(Arguments& arguments, const std::vector<std::string>& words)
{
  if (words.size() < 4 || words.size() > 5)
  {
    throw Failure(ExitCode::Usage,
      "thesis takes INPUT.obj numbFaces tolerance errorThreshold [OUTPUT.obj]; " +
        ThereAreText(words.size(), "word"));
  }
  for (std::size_t i = 0; i < ThesisNumbers.size(); ++i)
  {
    const OptionInfo& info = *FindOption(ThesisNumbers[i].second);
    ReadNumber(ThesisNumbers[i].first, words[i + 1], *RangeOf(info));
    GiveOption(arguments, info, words[i + 1]);
  }
  if (arguments.Options.TargetNumberOfTriangles == 0 && arguments.Options.MaximumError == 0.0)
  {
    throw Failure(
      ExitCode::Usage, "numbFaces and errorThreshold are both 0 (off): nothing would end the run");
  }
  GiveOption(arguments, *FindOption("Mode"), FindMode(Mode::Thesis).Name);
  const std::filesystem::path input = FilePath(words[0]);
  const std::string simplified = input.stem().string() + "_simplified.obj";
  arguments.ThesisForm = true;
  arguments.Inputs = { words[0],
    words.size() == 5 ? words[4] : (input.parent_path() / FilePath(simplified)).string() };
  TakeFiles(arguments);
}

std::string Delivery()
{
  const std::string given = BONEDECIMATE_DELIVERY;
  std::error_code none;
  const bool isInstalled =
    std::filesystem::read_symlink("/proc/self/exe", none) == "/usr/bin/bonedecimate";
  return !given.empty() ? given : isInstalled ? "Debian package" : "built from source";
}
}

void AddDecimateCommand(CLI::App& program, const std::string& self, ExitCode& code)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = AddCommand(program, DefaultCommand,
    { "INPUT OUTPUT [OPTIONS]", "INPUT... FOLDER [OPTIONS]",
      "LABELMAP FOLDER --segments all [OPTIONS]" },
    ProgramDescription());
  command.footer(HelpFooter());
  command.set_help_flag("-h,--help", "-h names the options on one screen, --help explains them.");
  command.set_version_flag("--version",
    std::string("bonedecimate ") + Version() + " (" + Delivery() + ")",
    "Print the version, and what the program came with.");
  AddDecimateOptions(command, *arguments);
  AddSettings(command, arguments->Settings);
  AddExplain(command, *arguments);
  AddDescriptions(command, program);
  command.final_callback(
    [&program, self, arguments, &code]
    {
      TakeFiles(*arguments);
      RequireCommandOrFile(program, arguments->Inputs[0]);
      TakeFolderOfSeries(*arguments);
      NameFilesOfFolder(*arguments);
      code = Decimate(*arguments, self);
    });
}

void AddSmoothCommand(CLI::App& program, ExitCode& code)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = AddCommand(program, "smooth", { "INPUT OUTPUT [OPTIONS]" },
    "Smooths a bone surface within a bound that is proved, and keeps all triangles. Without "
    "--smooth "
    "the bound is half of the smallest voxel spacing, found in the surface of a binary "
    "segmentation.");
  AddSmoothOptions(command, *arguments);
  AddSettings(command, arguments->Settings);
  AddExplain(command, *arguments);
  command.final_callback(
    [arguments, &code]
    {
      const bool isRequested = arguments->Options.Smooths();
      GiveOption(*arguments, *FindOption("Mode"), "Fast");
      GiveOption(*arguments, *FindOption("TargetReduction"), "0");
      if (!isRequested)
      {
        GiveOption(*arguments, *FindOption("AutomaticSmoothing"), "on");
      }
      TakeFiles(*arguments);
      code = RunOneBone(*arguments);
    });
}

void AddThesisCommand(CLI::App& program, ExitCode& code)
{
  const auto arguments = std::make_shared<Arguments>();
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App& command = AddCommand(program, "thesis",
    { "INPUT.obj numbFaces tolerance errorThreshold [OUTPUT.obj] [OPTIONS]" },
    "The thesis's program: number of triangles (0: off), tolerance w, largest error in mm (0: "
    "off).");
  command.add_option("THESIS", *words, WrappedHelp("The default output is INPUT_simplified.obj."))
    ->type_name("")
    ->allow_extra_args();
  AddThesisOptions(command, *arguments);
  AddSettings(command, arguments->Settings);
  AddExplain(command, *arguments);
  command.final_callback(
    [arguments, words, &code]
    {
      SetThesisWords(*arguments, *words);
      code = RunOneBone(*arguments);
    });
}
}
