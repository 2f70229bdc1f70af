// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"

#include "ExitCode.h"
#include "Formats/FileChecks.h"
#include "Terminal/Interruption.h"
#include "Terminal/ProgressBar.h"

#include "vtkCommand.h"
#include "vtkNew.h"

#include <algorithm>
#include <iostream>
#include <iterator>

namespace bonedecimate
{
MillimeterSurface ReadInput(
  const std::string& path, const LengthUnit& unit, std::vector<std::string>& warnings)
{
  MillimeterSurface loaded = ReadInMillimeters(path, unit);
  warnings.insert(warnings.end(), loaded.Warnings.begin(), loaded.Warnings.end());
  return loaded;
}

void RequireUnitOfFile(
  const MillimeterSurface& loaded, const std::string& path, const LengthUnit& unit)
{
  if (!unit.IsMillimeter() && !loaded.TakesUnit)
  {
    throw Failure(
      ExitCode::Usage, "--unit is for files that do not name their unit; '" + path + "' does");
  }
}

VtkMessages UpdateFilter(vtkAlgorithm* filter, Progress progress, const std::string& phase)
{
  VtkMessages messages = UpdateUntilInterrupted(filter, progress, phase);
  StopIfInterrupted();
  return messages;
}

VtkMessages UpdateUntilInterrupted(vtkAlgorithm* filter, Progress progress,
  const std::string& phase, const std::function<std::string()>& detail)
{
  ProgressDisplay display(progress);
  display.Begin(phase);
  vtkNew<ProgressBar> bar;
  bar->SetDisplay(&display, detail);
  const unsigned long observer = filter->AddObserver(vtkCommand::ProgressEvent, bar);
  TakeVtkMessages();
  filter->Update();
  display.Clear();
  filter->RemoveObserver(observer);
  return TakeVtkMessages();
}

void AcceptMessages(const VtkMessages& messages, const std::string& source,
  std::vector<std::string>& warnings, const LengthUnit& unit)
{
  if (!messages.Errors.empty())
  {
    Reject(source, WithUnitHint(messages.Errors.front(), source, unit));
  }
  std::transform(messages.Warnings.begin(), messages.Warnings.end(), std::back_inserter(warnings),
    [&](const std::string& warning) { return WithUnitHint(warning, source, unit); });
}

void PrintWarnings(const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    std::cout << "warning: " << warning << "\n";
  }
}
}
