// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelsCommand.h"

#include "Arguments/FileGrid.h"
#include "Arguments/FilterOptions.h"
#include "Figures/BoundText.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Files/FileRounding.h"
#include "Files/StagedFile.h"
#include "Files/SurfaceFiles.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "LevelsPageFile.h"
#include "NumberText.h"
#include "Options/NumberRange.h"
#include "Options/Options.h"
#include "Report/CountText.h"
#include "Runs/FilterRun.h"
#include "Terminal/Interruption.h"

#include "vtkBoneDecimateLevels.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <list>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr int DistanceDecimals = 4;

vtkSmartPointer<vtkUnsignedCharArray> ReadBytes(const std::string& path)
{
  CheckFile(path);
  const std::uintmax_t size = std::filesystem::file_size(FilePath(path));
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetNumberOfValues(static_cast<vtkIdType>(size));
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes->GetPointer(0)), static_cast<std::streamsize>(size));
  if (!stream)
  {
    Reject(path, "it could not be read");
  }
  return bytes;
}

std::string NameOfLevel(const std::string& output, vtkIdType triangles)
{
  const std::filesystem::path path = FilePath(output);
  const std::string name =
    path.stem().string() + "-" + std::to_string(triangles) + path.extension().string();
  return (path.parent_path() / FilePath(name)).string();
}

/// One command; the verbs are in the order of RunLevels().
class LevelsRun
{
public:
  explicit LevelsRun(const LevelsArguments& arguments)
    : Requested(arguments)
  {
    this->Filter->SetMode(ModeNumber(arguments.Mode));
    this->Filter->SetMaximumError(arguments.MaximumError);
    this->Filter->SetAllowLargeError(arguments.AllowLargeError);
    this->Filter->SetMeasureDistances(!arguments.WithoutErrors);
    this->Filter->SetNumberOfThreads(arguments.Threads);
  }

  void Read()
  {
    this->Filter->SetInputData(ApplyInputArguments(this->Requested.Input, this->Requested.Files[0],
      this->ReadOne(this->Requested.Files[0]), this->Filter, this->Warnings));
    this->Filter->SetReferenceData(ReadReference(this->Requested.Input, this->Requested.Unit));
    ApplyVoxelArguments(this->Requested.Voxels, this->Filter, this->Warnings);
    this->Filter->SetTargetNumberOfTriangles(this->Coarsest());
    this->SetGrid();
    if (this->Requested.MaximumError > 0.0)
    {
      this->Filter->SetMaximumError(this->ErrorOfRun());
    }
    if (!this->Requested.Log.empty())
    {
      this->Filter->SetLog(ReadBytes(this->Requested.Log));
    }
    if (!this->Requested.Record.empty())
    {
      this->Record.emplace(this->Requested.Record);
    }
    if (!this->Requested.Page.empty())
    {
      this->Page.emplace(this->Requested.Page);
    }
  }

  void Run()
  {
    const bool isRun = this->Requested.Log.empty();
    this->Update(isRun ? this->Requested.Files[0] : this->Requested.Log,
      this->Requested.Quiet || !isRun ? Progress::Hidden : Progress::Bar);
    this->RequireDistances();
    if (!this->Requested.On.empty())
    {
      this->Filter->SetInputData(1, this->ReadOne(this->Requested.On));
      this->SetGrid(); // of that surface
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
    for (const int triangles : this->Requested.Triangles)
    {
      this->WriteLevel(triangles, 0.0, files);
    }
    for (const double error : this->Requested.Errors)
    {
      this->WriteLevel(0, error, files);
    }
    this->WritePage();
    for (StagedFile& file : files)
    {
      file.Flush();
    }
    for (StagedFile& file : files)
    {
      file.Commit();
    }
    for (std::optional<StagedFile>* file : { &this->Page, &this->Record })
    {
      if (file->has_value())
      {
        (*file)->Commit();
      }
    }
  }

  void Tell() const
  {
    if (this->Requested.Quiet)
    {
      return;
    }
    for (int mark = 0; mark < this->Filter->GetNumberOfMarks(); ++mark)
    {
      std::cout << CountText(this->Filter->GetMarkTriangles(mark), "triangle");
      if (!std::isnan(this->Filter->GetMarkLargestDistance(mark)))
      {
        std::cout << ", largest distance "
                  << FixedText(this->Filter->GetMarkLargestDistance(mark), DistanceDecimals)
                  << " mm, mean "
                  << FixedText(this->Filter->GetMarkMeanDistance(mark), DistanceDecimals) << " mm";
      }
      const vtkTypeInt64 changed = this->Filter->GetMarkChangedVoxels(mark);
      std::cout << (changed < 0 ? ""
                                : ", " + CountText(changed, "voxel") +
                         (changed == 1 ? " has another label" : " have another label"))
                << "\n";
    }
    for (const auto& [name, requests] : this->Written)
    {
      std::cout << "wrote " << name << (requests.empty() ? "" : ": " + requests) << "\n";
    }
    if (this->Written.empty() && !this->Record)
    {
      std::cout << "wrote nothing: --triangles or --errors with --output writes levels, --record "
                   "the log, --page a page\n";
    }
    PrintWarnings(this->Warnings);
  }

private:
  /// The run goes on to the smallest level that was requested by its number. 0: the default, or as
  /// few as the error allows.
  int Coarsest() const
  {
    const std::vector<int>& requested = this->Requested.Triangles;
    if (this->Requested.Coarsest > 0 || this->Requested.MaximumError > 0.0 || requested.empty())
    {
      return this->Requested.Coarsest;
    }
    auto* const input = vtkPolyData::SafeDownCast(this->Filter->GetInput());
    const int least = *std::min_element(requested.begin(), requested.end());
    const auto byDefault =
      static_cast<double>(input->GetNumberOfPolys()) * (1.0 - Options{}.TargetReduction);
    return least < byDefault ? least : 0;
  }

  vtkSmartPointer<vtkPolyData> ReadOne(const std::string& path)
  {
    const MillimeterSurface loaded = ReadInput(path, this->Requested.Unit, this->Warnings);
    RequireUnitOfFile(loaded, path, this->Requested.Unit);
    this->InFile = loaded.InFile;
    this->IsSingle = loaded.IsSingle();
    return loaded.Surface;
  }

  /// Levels in files that have a grid are rounded to it.
  void SetGrid()
  {
    const SurfaceFormat* const format = FindFormat(this->Requested.Output);
    if (format != nullptr && format->HasGrid)
    {
      vtkDataObject* const other = this->Filter->GetInputDataObject(1, 0); // of --on
      vtkDataObject* const own = this->Filter->GetInput();
      this->GridStep = GridStepFor(vtkPolyData::SafeDownCast(other != nullptr ? other : own),
        this->Requested.MaximumError, MostPositionBits, this->Requested.Files[0]);
    }
  }

  /// The level as its file has it.
  vtkSmartPointer<vtkPolyData> InFormat(vtkPolyData* level)
  {
    const LengthUnit unit = UnitOfFile(this->Requested.Output, this->Requested.Unit);
    const vtkSmartPointer<vtkPolyData> inUnit =
      FromMillimeters(level, unit, this->IsSingle, this->InFile);
    if (this->GridStep == 0.0)
    {
      return inUnit;
    }
    const vtkSmartPointer<vtkPolyData> rounded = RoundedToGrid(inUnit, this->GridStep);
    for (const std::string& warning : GridWarnings(rounded, this->GridStep, true))
    {
      this->Warnings.push_back(warning);
    }
    return rounded;
  }

  /// Levels are rounded once more if their files are in another unit or have a grid.
  double ErrorOfRun()
  {
    const SurfaceFormat* const format = FindFormat(this->Requested.Output);
    const LengthUnit unit = UnitOfFile(this->Requested.Output, this->Requested.Unit);
    const bool writesSingle = this->IsSingle || (format != nullptr && !format->HoldsDoubles);
    auto* input = vtkPolyData::SafeDownCast(this->Filter->GetInput());
    return ErrorBeforeRounding(this->Requested.MaximumError,
      MaxRounding(input, unit, writesSingle) + LargestGridRounding(this->GridStep),
      this->GridStep > 0.0 ? format->Extension : unit.Name, this->Requested.Files[0]);
  }

  /// @param source The file that an error is about.
  void Update(const std::string& source, Progress progress)
  {
    AcceptMessages(UpdateFilter(this->Filter, progress, "simplifying"), source, this->Warnings,
      this->Requested.Unit);
  }

  void WriteLevel(int triangles, double error, std::list<StagedFile>& files)
  {
    this->Filter->SetNumberOfTriangles(triangles);
    this->Filter->SetLevelError(error);
    this->Update(
      this->Requested.On.empty() ? this->Requested.Files[0] : this->Requested.On, Progress::Hidden);
    vtkPolyData* level = this->Filter->GetOutput();
    this->WarnOutOfReach(triangles, error, level->GetNumberOfPolys());
    const std::string name = NameOfLevel(this->Requested.Output, level->GetNumberOfPolys());
    const std::string request =
      error > 0.0 ? "--errors " + NumberText(error) : "--triangles " + std::to_string(triangles);
    const auto written = std::find_if(this->Written.begin(), this->Written.end(),
      [&name](const auto& one) { return one.first == name; });
    if (written != this->Written.end())
    {
      written->second += ", " + request;
      return;
    }
    KeepSurfaces(this->Requested, name);
    StagedFile& file = files.emplace_back(name);
    WriteSurface(
      this->InFormat(level), file.GetTemporary(), file.GetTarget(), this->Requested.CompressesGlb);
    this->Written.emplace_back(name, request);
  }

  void WritePage()
  {
    if (this->Page)
    {
      WriteLevelsPage(
        this->Filter, BaseName(this->Requested.Files[0]), *this->Page, this->Warnings);
      this->Page->Flush();
      this->Written.emplace_back(this->Requested.Page, "");
    }
  }

  std::string WhatEndedTheRun() const
  {
    return !this->Requested.Log.empty() ? "where --coarsest or --max-error ended the run of the log"
      : this->Requested.MaximumError > 0.0 ? "where --max-error ended the run"
                                           : "where no edit was left to the run";
  }

  /// Warns where the log has another level than requested.
  void WarnOutOfReach(int triangles, double error, vtkIdType found)
  {
    if (triangles > 0 && found > triangles)
    {
      this->Warnings.push_back("no level has as few as " + GroupedText(triangles) +
        " triangles; the coarsest has " + GroupedText(static_cast<double>(found)) + ", " +
        this->WhatEndedTheRun());
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
    if (!this->Requested.Errors.empty() && !this->Requested.Log.empty() &&
      std::isnan(this->Filter->GetMarkLargestDistance(last)))
    {
      throw Failure(ExitCode::Usage,
        "--errors needs measured distances; '" + BaseName(this->Requested.Log) +
          "' was recorded with --no-errors");
    }
  }

  const LevelsArguments& Requested;
  std::vector<std::string> Warnings;
  std::vector<std::pair<std::string, std::string>> Written; // a file, and the requests it is for
  std::optional<StagedFile> Record;
  std::optional<StagedFile> Page;
  double GridStep = 0.0;               // mm; 0: none
  bool IsSingle = false;               // whether the file that was read last is in single precision
  vtkSmartPointer<vtkPolyData> InFile; // surface that was read last, in the unit of its file
  vtkNew<vtkBoneDecimateLevels> Filter;
};
}

void RunLevels(const LevelsArguments& arguments)
{
  LevelsRun run(arguments);
  run.Read();
  StopIfInterrupted();
  run.Run();
  run.Write();
  run.Tell();
}
}
