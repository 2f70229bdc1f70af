// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelsCommand.h"

#include "BoundText.h"
#include "FileChecks.h"
#include "FileRounding.h"
#include "FilterOptions.h"
#include "HelpFormatter.h"
#include "Interruption.h"
#include "NumberText.h"
#include "Numbers.h"
#include "ProgressBar.h"
#include "StagedFile.h"
#include "SurfaceFiles.h"
#include "SurfaceFormat.h"
#include "VtkMessages.h"
#include "Words.h"

#include "vtkBoneDecimateLevels.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <list>
#include <memory>

namespace bonedecimate
{
namespace
{
constexpr int DistanceDecimals = 4;

void AddRunOptions(CLI::App& app, LevelsArguments& arguments)
{
  app
    .add_option("--log", arguments.Log,
      WrappedHelp("Take the levels from this log, recorded on the same INPUT, instead of a run."))
    ->type_name("FILE");
  app.add_option("--record", arguments.Record, WrappedHelp("Write the log of the run."))
    ->type_name("FILE");
  AddNumber(app,
    { "--coarsest", "N", TriangleRange,
      "Triangles of the coarsest level; default a tenth of the input's, or with --max-error as few "
      "as that allows." },
    [&arguments](double value) { arguments.Coarsest = static_cast<int>(value); });
  app.add_option("--mode", arguments.Mode, "Of the run, default Balanced.")
    ->type_name("Thesis|Fast|Balanced|Accurate")
    ->check(CLI::IsMember({ "Thesis", "Fast", "Balanced", "Accurate" }, CLI::ignore_case)
              .description(""));
  AddNumber(app,
    { "--max-error", "MM", PositiveLengthRange,
      "Largest distance that the run may cause; every level keeps it." },
    [&arguments](double value) { arguments.MaximumError = value; });
  app.add_flag("--no-errors", arguments.WithoutErrors,
    WrappedHelp("Do not measure how far levels are from the input."));
}

void AddLevelOptions(CLI::App& app, LevelsArguments& arguments)
{
  AddNumberList(app,
    { "--triangles", "N,...", TriangleRange, "Levels by their numbers of triangles." },
    [&arguments](double value) { arguments.Triangles.push_back(static_cast<int>(value)); });
  AddNumberList(app,
    { "--errors", "MM,...", PositiveLengthRange, "Levels by their largest measured distances." },
    [&arguments](double error) { arguments.Errors.push_back(error); });
  app
    .add_option("--output", arguments.Output,
      WrappedHelp("Where levels go: with NAME.EXT, a level to NAME-TRIANGLES.EXT."))
    ->type_name("NAME.EXT");
  app
    .add_option("--on", arguments.On,
      WrappedHelp("Put the levels on this surface, which has the triangles of INPUT and other "
                  "points, such as a bone registered to it."))
    ->type_name("FILE");
  AddThreads(app, arguments.Threads);
  AddUnit(app, arguments.Unit);
  app.add_flag("--quiet", arguments.Quiet, "Nothing on the standard output.");
}

vtkSmartPointer<vtkUnsignedCharArray> ReadBytes(const std::string& path)
{
  CheckFile(path);
  const std::uintmax_t size = std::filesystem::file_size(path);
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetNumberOfValues(static_cast<vtkIdType>(size));
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes->GetPointer(0)), static_cast<std::streamsize>(size));
  if (!stream)
  {
    Refuse(path, "it could not be read");
  }
  return bytes;
}

std::string NameOfLevel(const std::string& output, vtkIdType triangles)
{
  const std::filesystem::path path(output);
  const std::string name =
    path.stem().string() + "-" + std::to_string(triangles) + path.extension().string();
  return (path.parent_path() / name).string();
}

/// No output takes the place of a surface that was read.
void KeepSurfaces(const LevelsArguments& arguments, const std::string& output)
{
  for (const std::string* input : { &arguments.Input, &arguments.On })
  {
    std::error_code error;
    if (std::filesystem::equivalent(output, *input, error))
    {
      throw Failure(ExitCode::Usage, "'" + output + "' is a surface; it is not overwritten");
    }
  }
}

/// One command; the verbs are in the order of RunLevels().
class LevelsRun
{
public:
  explicit LevelsRun(const LevelsArguments& arguments)
    : Asked(arguments)
  {
    this->Filter->SetMode(ModeNumber(arguments.Mode));
    this->Filter->SetCoarsestNumberOfTriangles(arguments.Coarsest);
    this->Filter->SetMaximumError(arguments.MaximumError);
    this->Filter->SetMeasureErrors(!arguments.WithoutErrors);
    this->Filter->SetNumberOfThreads(arguments.Threads);
  }

  void Read()
  {
    this->Filter->SetInputData(this->ReadOne(this->Asked.Input));
    if (this->Asked.MaximumError > 0.0)
    {
      this->Filter->SetMaximumError(this->ErrorOfRun());
    }
    if (!this->Asked.Log.empty())
    {
      this->Filter->SetLog(ReadBytes(this->Asked.Log));
    }
    if (!this->Asked.Record.empty())
    {
      this->Record.emplace(this->Asked.Record);
    }
  }

  void Run()
  {
    vtkNew<ProgressBar> bar;
    bar->SetShown(!this->Asked.Quiet && this->Asked.Log.empty());
    this->Filter->AddObserver(vtkCommand::ProgressEvent, bar);
    this->Update(this->Asked.Log.empty() ? this->Asked.Input : this->Asked.Log);
    bar->Clear();
    this->Filter->RemoveObserver(bar);
    StopIfInterrupted();
    this->RequireDistances();
    if (!this->Asked.On.empty())
    {
      this->Filter->SetInputData(1, this->ReadOne(this->Asked.On));
    }
  }

  /// Whole or not at all: no file gets its name before all are written.
  void Write()
  {
    if (this->Record)
    {
      vtkUnsignedCharArray* log = this->Filter->GetLog();
      const auto* bytes = reinterpret_cast<const char*>(log->GetPointer(0));
      this->Record->WriteText(
        std::string(bytes, static_cast<std::size_t>(log->GetNumberOfValues())));
      this->Record->Flush();
    }
    std::list<StagedFile> files;
    for (const int triangles : this->Asked.Triangles)
    {
      this->WriteLevel(triangles, 0.0, files);
    }
    for (const double error : this->Asked.Errors)
    {
      this->WriteLevel(0, error, files);
    }
    for (StagedFile& file : files)
    {
      file.Flush();
    }
    for (StagedFile& file : files)
    {
      file.Commit();
    }
    if (this->Record)
    {
      this->Record->Commit();
    }
  }

  void Tell() const
  {
    if (this->Asked.Quiet)
    {
      return;
    }
    for (int mark = 0; mark < this->Filter->GetNumberOfMarks(); ++mark)
    {
      std::cout << GroupedText(this->Filter->GetMarkTriangles(mark)) << " triangles";
      if (!std::isnan(this->Filter->GetMarkLargestDistance(mark)))
      {
        std::cout << ", largest distance "
                  << FixedText(this->Filter->GetMarkLargestDistance(mark), DistanceDecimals)
                  << " mm, mean "
                  << FixedText(this->Filter->GetMarkMeanDistance(mark), DistanceDecimals) << " mm";
      }
      std::cout << "\n";
    }
    for (const std::string& name : this->Written)
    {
      std::cout << "wrote " << name << "\n";
    }
    for (const std::string& warning : this->Warnings)
    {
      std::cout << "warning: " << warning << "\n";
    }
  }

private:
  vtkSmartPointer<vtkPolyData> ReadOne(const std::string& path)
  {
    const MillimeterSurface loaded = ReadInMillimeters(path, this->Asked.Unit);
    this->InFile = loaded.InFile;
    this->IsSingle = loaded.IsSingle();
    this->Warnings.insert(this->Warnings.end(), loaded.Warnings.begin(), loaded.Warnings.end());
    return loaded.Surface;
  }

  /// Levels are rounded once more if their files are in another unit.
  double ErrorOfRun()
  {
    const LengthUnit& unit = this->Asked.Unit;
    const bool writesSingle = this->IsSingle ||
      (!this->Asked.Output.empty() && !HoldsDoubles(FormatOf(this->Asked.Output)));
    auto* input = vtkPolyData::SafeDownCast(this->Filter->GetInput());
    return ErrorWithRoom(this->Asked.MaximumError, LargestRounding(input, unit, writesSingle), unit,
      this->Asked.Input);
  }

  /// @param source Who is to blame for an error.
  void Update(const std::string& source)
  {
    TakeVtkMessages();
    this->Filter->Update();
    const VtkMessages messages = TakeVtkMessages();
    if (!messages.Errors.empty())
    {
      Refuse(source, WithUnitHint(messages.Errors.front()));
    }
    std::transform(messages.Warnings.begin(), messages.Warnings.end(),
      std::back_inserter(this->Warnings), WithUnitHint);
  }

  void WriteLevel(int triangles, double error, std::list<StagedFile>& files)
  {
    this->Filter->SetNumberOfTriangles(triangles);
    this->Filter->SetLevelError(error);
    this->Update(this->Asked.On.empty() ? this->Asked.Input : this->Asked.On);
    StopIfInterrupted();
    vtkPolyData* level = this->Filter->GetOutput();
    this->WarnOutOfReach(triangles, error, level->GetNumberOfPolys());
    const std::string name = NameOfLevel(this->Asked.Output, level->GetNumberOfPolys());
    if (std::find(this->Written.begin(), this->Written.end(), name) == this->Written.end())
    {
      KeepSurfaces(this->Asked, name);
      StagedFile& file = files.emplace_back(name);
      WriteSurface(FromMillimeters(level, this->Asked.Unit, this->IsSingle, this->InFile),
        file.GetTemporary(), file.GetTarget());
      this->Written.push_back(name);
    }
  }

  /// What the log has instead of what was asked for.
  void WarnOutOfReach(int triangles, double error, vtkIdType found)
  {
    if (triangles > 0 && found > triangles)
    {
      this->Warnings.push_back("no level has as few as " + GroupedText(triangles) +
        " triangles; the coarsest has " + GroupedText(static_cast<double>(found)));
    }
    bool isWithin = false;
    for (int mark = 0; mark < this->Filter->GetNumberOfMarks(); ++mark)
    {
      isWithin = isWithin || this->Filter->GetMarkLargestDistance(mark) <= error;
    }
    if (error > 0.0 && !isWithin)
    {
      this->Warnings.push_back("no measured level is within " + NumberText(error) +
        " mm; the input itself, " + GroupedText(static_cast<double>(found)) +
        " triangles, was written");
    }
  }

  /// A log whose distances were not measured has no level by a distance.
  void RequireDistances() const
  {
    const int last = this->Filter->GetNumberOfMarks() - 1;
    if (!this->Asked.Errors.empty() && !this->Asked.Log.empty() &&
      std::isnan(this->Filter->GetMarkLargestDistance(last)))
    {
      throw Failure(ExitCode::Usage,
        "--errors needs measured distances; '" + BaseName(this->Asked.Log) +
          "' was recorded with --no-errors");
    }
  }

  const LevelsArguments& Asked;
  std::vector<std::string> Warnings;
  std::vector<std::string> Written;
  std::optional<StagedFile> Record;
  bool IsSingle = false;               // the file that was read last
  vtkSmartPointer<vtkPolyData> InFile; // the same, in its unit
  vtkNew<vtkBoneDecimateLevels> Filter;
};

void CheckTogether(const CLI::App& app, const LevelsArguments& arguments)
{
  for (const char* flag : { "--record", "--coarsest", "--mode", "--max-error", "--no-errors" })
  {
    if (!arguments.Log.empty() && app.count(flag) > 0)
    {
      throw Failure(
        ExitCode::Usage, std::string(flag) + " is for a run, and --log takes its place");
    }
  }
  const bool wantsLevels = !arguments.Triangles.empty() || !arguments.Errors.empty();
  if (wantsLevels == arguments.Output.empty())
  {
    throw Failure(ExitCode::Usage,
      wantsLevels ? "--output is needed for the levels" : "--output needs --triangles or --errors");
  }
  if (wantsLevels && FormatOf(arguments.Output) == SurfaceFormat::Unknown)
  {
    throw Failure(ExitCode::Usage,
      "--output '" + arguments.Output + "' needs one of the extensions " + SurfaceExtensions);
  }
  for (const int triangles : arguments.Triangles)
  {
    if (triangles < arguments.Coarsest)
    {
      throw Failure(ExitCode::Usage,
        "--triangles " + std::to_string(triangles) +
          " is out of reach; --coarsest ends the run at " + std::to_string(arguments.Coarsest));
    }
  }
  if (arguments.WithoutErrors && !arguments.Errors.empty())
  {
    throw Failure(ExitCode::Usage, "--errors needs the distances that --no-errors leaves out");
  }
  KeepSurfaces(arguments, arguments.Record);
}
}

std::optional<LevelsArguments> ParseLevelsArguments(int argc, char* argv[])
{
  LevelsArguments arguments;
  std::vector<std::string> files;
  CLI::App app("Levels of detail: one run, recorded, and any stage of it at once, by a number of "
               "triangles or by a measured distance.",
    "bonedecimate levels");
  app.formatter(std::make_shared<HelpFormatter>("INPUT [OPTIONS]"));
  app.footer(ExitCodesText());
  app.add_option("FILES", files, WrappedHelp("A surface (obj, stl, ply, vtp, vtk), mm."))
    ->type_name("")
    ->allow_extra_args();
  AddRunOptions(app, arguments);
  AddLevelOptions(app, arguments);
  if (!ParseWords(app, WordsOf(argc, argv, 2)))
  {
    return {};
  }
  if (files.size() != 1)
  {
    throw Failure(
      ExitCode::Usage, "levels takes one INPUT; there are " + std::to_string(files.size()));
  }
  arguments.Input = files[0];
  CheckTogether(app, arguments);
  return arguments;
}

ExitCode RunLevels(const LevelsArguments& arguments)
{
  LevelsRun run(arguments);
  run.Read();
  StopIfInterrupted();
  run.Run();
  run.Write();
  run.Tell();
  return ExitCode::Done;
}
}
