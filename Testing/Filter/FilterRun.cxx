// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
/// Keeps what VTK would have written to stderr.
class Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Text += text; }

  std::string Text;

protected:
  Window() = default;
};
vtkStandardNewMacro(Window);

Window* TheWindow()
{
  static const vtkNew<Window> window;
  if (vtkOutputWindow::GetInstance() != window)
  {
    vtkOutputWindow::SetInstance(window);
  }
  return window;
}
}

namespace bonedecimate::testsupport
{
FilterRun::FilterRun(vtkDataObject* input)
{
  TheWindow();
  this->Filter->SetInputDataObject(input);
  this->Filter->MeasureDistancesOff();
  for (const auto event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent,
         vtkCommand::ProgressEvent, vtkCommand::StartEvent })
  {
    this->Filter->AddObserver(event, this, &FilterRun::OnEvent);
  }
  // VTK's executive adds that the filter "returned failure": heard here as well, but not kept.
  this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &FilterRun::OnEvent);
}

//------------------------------------------------------------------------------
FilterRun::~FilterRun()
{
  EXPECT_EQ(TheWindow()->Text, "") << "reached stderr";
  TheWindow()->Text.clear();
}

//------------------------------------------------------------------------------
vtkPolyData* FilterRun::Output()
{
  this->Filter->Update();
  return this->Filter->GetOutput();
}

vtkPolyData* FilterRun::InputCopy()
{
  this->Filter->Update(1);
  return this->Filter->GetOutput(1);
}

double FilterRun::Value(const std::string& entry)
{
  this->Filter->Update();
  return this->Filter->GetReportValue(entry);
}

//------------------------------------------------------------------------------
int FilterRun::Said(const std::string& text) const
{
  const auto has = [&](const std::string& message)
  { return message.find(text) != std::string::npos; };
  return static_cast<int>(std::count_if(this->Errors.begin(), this->Errors.end(), has) +
    std::count_if(this->Warnings.begin(), this->Warnings.end(), has));
}

std::string FilterRun::AllMessages() const
{
  std::string all;
  for (const std::string& error : this->Errors)
  {
    all += "error: " + error + "\n";
  }
  for (const std::string& warning : this->Warnings)
  {
    all += "warning: " + warning + "\n";
  }
  return all;
}

//------------------------------------------------------------------------------
void FilterRun::OnEvent(vtkObject* caller, unsigned long event, void* data)
{
  if (caller != this->Filter)
  {
    return;
  }
  switch (event)
  {
    case vtkCommand::ErrorEvent:
      this->Errors.emplace_back(static_cast<const char*>(data));
      break;
    case vtkCommand::WarningEvent:
      this->Warnings.emplace_back(static_cast<const char*>(data));
      break;
    case vtkCommand::StartEvent:
      ++this->Executions;
      this->Progress.clear();
      break;
    default:
      this->OnProgress(*static_cast<const double*>(data));
  }
}

void FilterRun::OnProgress(double fraction)
{
  this->Progress.push_back(fraction);
  this->OnEachProgress(fraction);
  if (fraction >= this->AbortFraction)
  {
    this->Filter->SetAbortExecute(1);
  }
}
}
