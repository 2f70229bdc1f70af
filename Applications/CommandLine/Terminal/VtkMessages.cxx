// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VtkMessages.h"

#include "Arguments/FlagNames.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <mutex>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Takes "ERROR: In file, line 3\nvtkClass (0x12): text\n\n" to "text".
std::string WithoutOrigin(const std::string& text)
{
  std::string line = text;
  const std::size_t firstEnd = line.find('\n');
  if (firstEnd != std::string::npos && line.find(": In ") < firstEnd)
  {
    line.erase(0, firstEnd + 1);
  }
  const std::size_t address = line.find(" (0x");
  const std::size_t addressEnd = line.find("): ", address);
  if (address != std::string::npos && addressEnd != std::string::npos && line.find(' ') == address)
  {
    line.erase(0, addressEnd + 3);
  }
  while (!line.empty() && (line.back() == '\n' || line.back() == ' '))
  {
    line.pop_back();
  }
  for (char& c : line)
  {
    c = c == '\n' ? ' ' : c;
  }
  return line;
}

class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Add(this->Messages.Errors, text); }
  void DisplayWarningText(const char* text) override { this->Add(this->Messages.Warnings, text); }
  void DisplayGenericWarningText(const char* text) override
  {
    this->Add(this->Messages.Warnings, text);
  }

  VtkMessages Take()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return std::exchange(this->Messages, {});
  }

private:
  void Add(std::vector<std::string>& list, const char* text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    list.push_back(WithFlags(WithoutOrigin(text ? text : "")));
  }

  std::mutex Mutex; // VTK's threads may speak, too
  VtkMessages Messages;
};

vtkStandardNewMacro(Collector);
}

void CollectVtkMessages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Collector> collector;
  vtkOutputWindow::SetInstance(collector);
}

VtkMessages TakeVtkMessages()
{
  Collector* collector = Collector::SafeDownCast(vtkOutputWindow::GetInstance());
  return collector ? collector->Take() : VtkMessages{};
}
}
