// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "ExitCode.h"
#include "HelpFormatter.h"
#include "Numbers.h"
#include "OptionTable.h"
#include "Report.h"
#include "Words.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace bonedecimate
{
namespace
{
/// The thesis's own form: the three numbers of its program, in its order, as options of ours.
const std::vector<std::pair<const char*, const char*>> ThesisNumbers = {
  { "numbFaces", "TargetNumberOfTriangles" }, { "tolerance", "NormalTolerance" },
  { "errorThreshold", "MaximumError" }
};

/// Sets an option from its text, and notes that it was asked for.
void GiveOption(
  Arguments& arguments, const OptionInfo& info, const std::string& name, const std::string& text)
{
  if (const std::optional<NumberRange> range = RangeOf(info))
  {
    const double value = ReadNumber(name, text, *range);
    // The range was checked.
    SetOption(arguments.Options, info,
      range->IsWhole ? OptionValue(static_cast<int>(value)) : OptionValue(value));
  }
  else
  {
    const std::string problem = SetOptionFromText(arguments.Options, info, text);
    if (!problem.empty())
    {
      throw Failure(ExitCode::Usage, name + ": " + problem);
    }
  }
  arguments.Given[info.Flag] = OptionText(arguments.Options, info);
}

void AddTableOption(CLI::App& app, Arguments& arguments, const OptionInfo& info)
{
  const std::string flag = "--" + info.Flag;
  app
    .add_option_function<std::string>(
      flag,
      [&arguments, &info, flag](const std::string& text)
      { GiveOption(arguments, info, flag, text); },
      OptionHelp(info))
    ->type_name(OptionValueName(info));
}

void AddIso(CLI::App& app, Arguments& arguments)
{
  AddNumber(app,
    { "--iso", "HU", HounsfieldRange,
      "The input is a CT volume (.vti, .mha, .mhd, .nrrd, .nhdr, a DICOM folder): take the bone "
      "surface at this Hounsfield value, for example 226." },
    [&arguments](double hounsfield)
    {
      arguments.Iso = hounsfield;
      std::ostringstream text;
      text << std::setprecision(17) << hounsfield;
      arguments.Given["iso"] = text.str();
    });
}

void AddIntensities(CLI::App& app, Arguments& arguments)
{
  app
    .add_option_function<std::string>(
      "--intensities",
      [&arguments](const std::string& text)
      {
        arguments.TakesLabels = text == "on";
        arguments.Given["intensities"] = text;
      },
      WrappedHelp(
        "Take the values of a volume for intensities even where they look like the labels "
        "of a segmentation, which is refused otherwise; default off."))
    ->type_name("on|off")
    ->check(CLI::IsMember({ "on", "off" }).description(""));
}

void AddRegions(CLI::App& app, Arguments& arguments)
{
  app
    .add_option_function<std::vector<std::string>>(
      "--region",
      [&arguments](const std::vector<std::string>& texts)
      {
        std::string all;
        for (const std::string& text : texts)
        {
          const std::string problem = ReadRegions(text, arguments.Regions);
          if (!problem.empty())
          {
            throw Failure(ExitCode::Usage, "--region " + problem);
          }
          all += (all.empty() ? "" : ";") + text;
        }
        arguments.Given["region"] = all;
      },
      WrappedHelp("How far the surface may move in a part of it, in mm: box:x0,x1,y0,y1,z0,z1=MM, "
                  "sphere:x,y,z,radius=MM, rest=MM for what is in none of them. 0 freezes; "
                  "where parts overlap the smallest counts, and --max-error caps all. May be "
                  "repeated."))
    ->type_name("SHAPE=MM")
    ->expected(1)
    ->take_all()
    ->allow_extra_args(false);
}

void AddCommonFlags(CLI::App& app, Arguments& arguments)
{
  const auto file = [&app](const char* flag, std::string& value, const char* help)
  { app.add_option(flag, value, WrappedHelp(help))->type_name("FILE"); };
  app
    .add_option("--also", arguments.Also,
      WrappedHelp("Write the surface to this file, too; may be repeated."))
    ->type_name("FILE")
    ->expected(1)
    ->take_all()
    ->allow_extra_args(false);
  file("--reference", arguments.Reference,
    "The surface from which INPUT was made by runs before: --max-error is promised and proved "
    "against it, and distances are measured to it.");
  AddUnit(app, arguments.Unit);
  file("--report", arguments.Report, "Write the report as JSON.");
  file("--page", arguments.Page,
    "Write a self-contained HTML page for people, with the picture in it.");
  file("--heatmap", arguments.Heatmap,
    "Write the input surface (.vtp or .vtk) with the distance in mm of each of its points to the "
    "result.");
  file("--picture", arguments.Picture,
    "Draw before, after and the distances as colours into a PNG. If it cannot be drawn everything "
    "else is written and the program ends with 3; for --page alone it is a warning.");
  app.add_flag("--quiet", arguments.Quiet, "Nothing on the standard output.");
}

void AddBatchFlags(CLI::App& app, Arguments& arguments)
{
  AddNumber(app,
    { "--jobs", "N", { 1, 1024, true, "processes" },
      "Many bones: how many at once, each a process of its own." },
    [&arguments](double jobs) { arguments.Jobs = static_cast<int>(jobs); });
  app.add_flag("--force", arguments.Force,
    WrappedHelp("Many bones: do those again that are finished already."));
  app
    .add_option("--format", arguments.Format,
      WrappedHelp("Many bones: format of the outputs by its extension; default that of each input, "
                  "vtp for volumes."))
    ->type_name("EXT");
}

std::unique_ptr<CLI::App> MakeApp(
  Arguments& arguments, std::vector<std::string>& files, bool& markdown)
{
  auto app = std::make_unique<CLI::App>(ProgramDescription(), "bonedecimate");
  app->formatter(
    std::make_shared<HelpFormatter>("INPUT OUTPUT [OPTIONS]\n"
                                    "       bonedecimate INPUT... FOLDER [OPTIONS]\n"
                                    "       bonedecimate thesis INPUT.obj numbFaces tolerance "
                                    "errorThreshold [OUTPUT.obj] [OPTIONS]\n"
                                    "       bonedecimate certify REFERENCE RESULT [OPTIONS]\n"
                                    "       bonedecimate tolerance INPUT --triangles N [OPTIONS]\n"
                                    "       bonedecimate curve INPUT --errors MM,... [OPTIONS]\n"
                                    "       bonedecimate levels INPUT [OPTIONS]\n"
                                    "       bonedecimate check FILE [OPTIONS]"));
  app->footer(HelpFooter());
  app->set_version_flag(
    "--version", std::string("bonedecimate ") + Version(), "Print the version.");
  app
    ->add_option("FILES", files,
      WrappedHelp("INPUT OUTPUT, or several inputs or a folder, and an output folder."))
    ->type_name("")
    ->allow_extra_args();
  for (const OptionInfo& info : OptionTable())
  {
    if (!info.Flag.empty())
    {
      AddTableOption(*app, arguments, info);
    }
  }
  AddIso(*app, arguments);
  AddIntensities(*app, arguments);
  AddRegions(*app, arguments);
  AddCommonFlags(*app, arguments);
  AddBatchFlags(*app, arguments);
  app->add_flag("--options-markdown", markdown, "Print the table of options as Markdown.");
  return app;
}

std::unique_ptr<CLI::App> MakeThesisApp(Arguments& arguments, std::vector<std::string>& words)
{
  auto app = std::make_unique<CLI::App>(
    "The thesis's program: number of triangles (0: off), tolerance w, largest "
    "error in mm (0: off).",
    "bonedecimate thesis");
  app->formatter(std::make_shared<HelpFormatter>(
    "INPUT.obj numbFaces tolerance errorThreshold [OUTPUT.obj] [OPTIONS]"));
  app->footer(ExitCodesText());
  app->add_option("WORDS", words, WrappedHelp("The default output is INPUT_simplified.obj."))
    ->type_name("")
    ->allow_extra_args();
  AddTableOption(*app, arguments, *FindOption("NumberOfThreads"));
  AddIso(*app, arguments);
  AddIntensities(*app, arguments);
  AddCommonFlags(*app, arguments);
  return app;
}

void SetThesisWords(Arguments& arguments, const std::vector<std::string>& words)
{
  if (words.size() < 4 || words.size() > 5)
  {
    throw Failure(ExitCode::Usage,
      "thesis takes INPUT.obj numbFaces tolerance errorThreshold [OUTPUT.obj]; there are " +
        std::to_string(words.size()) + " words");
  }
  for (std::size_t i = 0; i < ThesisNumbers.size(); ++i)
  {
    GiveOption(
      arguments, *FindOption(ThesisNumbers[i].second), ThesisNumbers[i].first, words[i + 1]);
  }
  if (arguments.Options.TargetNumberOfTriangles == 0 && arguments.Options.MaximumError == 0.0)
  {
    throw Failure(
      ExitCode::Usage, "numbFaces and errorThreshold are both 0 (off): nothing would end the run");
  }
  GiveOption(arguments, *FindOption("Mode"), "mode", "Thesis");
  const std::filesystem::path input(words[0]);
  const std::string simplified = input.stem().string() + "_simplified.obj";
  arguments.ThesisForm = true;
  arguments.Inputs = { words[0] };
  arguments.Output = words.size() == 5 ? words[4] : (input.parent_path() / simplified).string();
}

void SetFiles(Arguments& arguments, std::vector<std::string> files)
{
  if (files.size() < 2)
  {
    throw Failure(ExitCode::Usage, "an INPUT and an OUTPUT are needed; see bonedecimate --help");
  }
  arguments.Output = files.back();
  files.pop_back();
  arguments.Inputs = std::move(files);
}

bool ParseThesisForm(int argc, char* argv[], Arguments& arguments)
{
  std::vector<std::string> words;
  const std::unique_ptr<CLI::App> app = MakeThesisApp(arguments, words);
  if (!ParseWords(*app, WordsOf(argc, argv, 2)))
  {
    return false;
  }
  SetThesisWords(arguments, words);
  return true;
}

bool ParseOwnForm(int argc, char* argv[], Arguments& arguments)
{
  std::vector<std::string> files;
  bool markdown = false;
  const std::unique_ptr<CLI::App> app = MakeApp(arguments, files, markdown);
  if (!ParseWords(*app, WordsOf(argc, argv, 1)))
  {
    return false;
  }
  if (markdown)
  {
    std::cout << OptionTableMarkdown();
    return false;
  }
  SetFiles(arguments, std::move(files));
  return true;
}
}

std::optional<Arguments> ParseArguments(int argc, char* argv[])
{
  Arguments arguments;
  const bool thesis = argc > 1 && std::string(argv[1]) == "thesis";
  const bool run =
    thesis ? ParseThesisForm(argc, argv, arguments) : ParseOwnForm(argc, argv, arguments);
  if (!arguments.Unit.IsMillimeter())
  {
    arguments.Given["unit"] = arguments.Unit.Name;
  }
  return run ? std::optional<Arguments>(std::move(arguments)) : std::nullopt;
}
}
