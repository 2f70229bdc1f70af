// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunOurs.cxx
 * @brief One decimation by this project in a process of its own: the benchmark's contestant.
 *
 *     bonedecimate-run INPUT.ply OUTPUT.ply THROUGH MODE THREADS [--faces N] [--error MM]
 *       [--kernels NAME] [--NAME VALUE]
 *     bonedecimate-run --modes|--parallel-modes|--proving-modes
 *     bonedecimate-run --kernels
 *
 * THROUGH is core (the VTK-free call) or filter (vtkBoneDecimate, conversions included);
 * MeasureDistances is off. NAME is that of an option of the core. With an error, core has the
 * result checked by the certificate, outside of the measured time. Prints JSON; --modes prints the
 * modes that there are, --parallel-modes those that use several threads, --proving-modes those that
 * prove a largest error, --kernels the sets of kernels that this processor runs, a line each.
 */
#include "Meter.h"
#include "TriangleFile.h"

#include "Decimate/Kernels/Kernels.h"
#include "Options/OptionTable.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Decimate.h"
#include "vtkBoneDecimate.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

namespace
{
const bonedecimate::OptionInfo& Option(const char* name)
{
  const bonedecimate::OptionInfo* info = bonedecimate::FindOption(name);
  if (info == nullptr)
  {
    throw std::runtime_error(std::string("there is no option ") + name);
  }
  return *info;
}

void Set(bonedecimate::Options& options, const char* name, const std::string& text)
{
  const std::string complaint = bonedecimate::SetOptionFromText(options, Option(name), text);
  if (!complaint.empty())
  {
    throw std::runtime_error(complaint);
  }
}

void Choose(const std::string& name)
{
  for (const bonedecimate::Kernels* kernels : bonedecimate::AvailableKernels())
  {
    if (name == kernels->Name)
    {
      bonedecimate::ChooseKernels(kernels);
      return;
    }
  }
  throw std::runtime_error("no such kernels here: " + name);
}

bonedecimate::Options Requested(int count, char** words)
{
  bonedecimate::Options options;
  options.MeasureDistances = false;
  Set(options, "Mode", words[4]);
  Set(options, "NumberOfThreads", words[5]);
  for (int i = 6; i + 1 < count; i += 2)
  {
    if (std::strcmp(words[i], "--kernels") == 0)
    {
      Choose(words[i + 1]);
      continue;
    }
    const bool isFaces = std::strcmp(words[i], "--faces") == 0;
    const bool isError = std::strcmp(words[i], "--error") == 0;
    Set(options,
      isFaces     ? "TargetNumberOfTriangles"
        : isError ? "MaximumError"
                  : words[i] + 2,
      words[i + 1]);
  }
  return options;
}

/// Which knows nothing of how the result was made.
/// @param ownSeconds What the run took for a certificate of its own.
void PrintCertificate(
  const bonedecimate::Surface& input, const bonedecimate::Surface& result, double ownSeconds)
{
  const bonedecimate::Certificate found = bonedecimate::Certify(input, result);
  const auto& there = found.BoundaryOfReferenceToResult.Distance;
  const auto& back = found.BoundaryOfResultToReference.Distance;
  std::printf(
    "\"proved\": {\"lower\": %.9g, \"upper\": %.9g, \"boundaries\": %.9g, \"own_seconds\": %.3f}, ",
    found.Lower(), found.Upper(), std::max(there.Upper, back.Upper), ownSeconds);
}

Triangles RunCore(const char* input, const bonedecimate::Options& options, Meter& meter)
{
  bonedecimate::Surface surface;
  {
    const Triangles read = ReadPly(input);
    for (const auto& point : read.Points)
    {
      surface.Points.emplace_back(point[0], point[1], point[2]);
    }
    surface.Points.shrink_to_fit();
    surface.Triangles.assign(read.Corners.begin(), read.Corners.end());
  }
  meter.Start();
  const bonedecimate::Result result = bonedecimate::Decimate(surface, options, {}, { true });
  meter.Stop();
  if (options.MaximumError > 0.0)
  {
    PrintCertificate(surface, result.Surface, result.Report.Seconds.Prove);
  }
  Triangles written;
  for (const auto& point : result.Surface.Points)
  {
    written.Points.push_back({ point[0], point[1], point[2] });
  }
  written.Corners.assign(result.Surface.Triangles.begin(), result.Surface.Triangles.end());
  return written;
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const char* input)
{
  const Triangles read = ReadPly(input);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(read.Points.size()));
  for (std::size_t p = 0; p < read.Points.size(); ++p)
  {
    points->SetPoint(static_cast<vtkIdType>(p), read.Points[p].data());
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(
    static_cast<vtkIdType>(read.Corners.size()), static_cast<vtkIdType>(3 * read.Corners.size()));
  for (const auto& corners : read.Corners)
  {
    cells->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

Triangles RunFilter(const char* input, const bonedecimate::Options& options, Meter& meter)
{
  const vtkSmartPointer<vtkPolyData> surface = ReadPolyData(input);
  vtkNew<vtkBoneDecimate> filter;
  filter->SetInputData(surface);
  filter->MeasureDistancesOff();
  filter->SetMode(static_cast<int>(options.Mode));
  filter->SetNumberOfThreads(options.NumberOfThreads);
  filter->SetTargetNumberOfTriangles(options.TargetNumberOfTriangles);
  filter->SetMaximumError(options.MaximumError);
  meter.Start();
  filter->Update();
  meter.Stop();
  vtkPolyData* result = filter->GetOutput();
  Triangles written;
  for (vtkIdType p = 0; p < result->GetNumberOfPoints(); ++p)
  {
    const double* x = result->GetPoint(p);
    written.Points.push_back({ x[0], x[1], x[2] });
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < result->GetNumberOfPolys(); ++cell)
  {
    result->GetPolys()->GetCellAtId(cell, ids);
    written.Corners.push_back({ static_cast<std::int32_t>(ids->GetId(0)),
      static_cast<std::int32_t>(ids->GetId(1)), static_cast<std::int32_t>(ids->GetId(2)) });
  }
  return written;
}

/// FNV-1a over the bytes of points and corners: equal for equal results.
std::uint64_t Checksum(const Triangles& result)
{
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  const auto add = [&](const void* data, std::size_t size)
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
    {
      sum = (sum ^ bytes[i]) * 0x100000001b3ULL;
    }
  };
  add(result.Points.data(), result.Points.size() * sizeof(result.Points[0]));
  add(result.Corners.data(), result.Corners.size() * sizeof(result.Corners[0]));
  return sum;
}

void Run(int count, char** words)
{
  Meter meter;
  const bonedecimate::Options options = Requested(count, words);
  const bool isCore = std::strcmp(words[3], "core") == 0;
  std::printf("{");
  const Triangles result =
    isCore ? RunCore(words[1], options, meter) : RunFilter(words[1], options, meter);
  WritePly(words[2], result, Coordinates::Double);
  std::printf("\"triangles\": %zu, \"checksum\": \"%016llx\", \"version\": \"%s\", ",
    result.Corners.size(), static_cast<unsigned long long>(Checksum(result)),
    bonedecimate::Version());
  meter.Print();
  std::printf("}\n");
}

/// False if the word is none of those that print modes.
bool PrintModes(const std::string& word)
{
  using Property = bool (bonedecimate::ModeInfo::*)() const;
  const std::map<std::string, Property> lists = { { "--modes", nullptr },
    { "--parallel-modes", &bonedecimate::ModeInfo::NeedsQuadrics },
    { "--proving-modes", &bonedecimate::ModeInfo::ProvesError } };
  const auto list = lists.find(word);
  if (list == lists.end())
  {
    return false;
  }
  for (const bonedecimate::ModeInfo& mode : bonedecimate::ModeTable())
  {
    if (list->second == nullptr || (mode.*list->second)())
    {
      std::printf("%s\n", mode.Name);
    }
  }
  return true;
}
}

int main(int argumentCount, char** words)
{
  vtkObject::GlobalWarningDisplayOff(); // warnings about the bones repeat in every run
  try
  {
    if (argumentCount == 2 && PrintModes(words[1]))
    {
      return EXIT_SUCCESS;
    }
    if (argumentCount == 2 && std::strcmp(words[1], "--kernels") == 0)
    {
      for (const bonedecimate::Kernels* kernels : bonedecimate::AvailableKernels())
      {
        std::printf("%s\n", kernels->Name);
      }
      return EXIT_SUCCESS;
    }
    if (argumentCount < 8 || argumentCount % 2 != 0)
    {
      std::fputs("usage: bonedecimate-run INPUT.ply OUTPUT.ply core|filter MODE THREADS "
                 "--faces N | --error MM [--kernels NAME]\n",
        stderr);
      return EXIT_FAILURE;
    }
    Run(argumentCount, words);
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-run: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
