// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelsCommand.h"

#include "BoundText.h"
#include "FileChecks.h"
#include "FileRounding.h"
#include "FilterOptions.h"
#include "Interruption.h"
#include "NumberRange.h"
#include "NumberText.h"
#include "ProgressBar.h"
#include "StagedFile.h"
#include "SurfaceFiles.h"
#include "SurfaceFormat.h"
#include "VtkMessages.h"

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

namespace bonedecimate
{
namespace
{
constexpr int DistanceDecimals = 4;

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
    this->Filter->SetAllowLargeError(arguments.AllowLargeError);
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
