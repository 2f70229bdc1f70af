// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneDiagnostics.h"

#include "RejectedValues.h"
#include "Repair/Diagnostics/Diagnostics.h"
#include "Run/Report/ReportCells.h"
#include "SurfaceConversion.h"

#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

struct vtkBoneDiagnostics::Internals
{
  bool WasRun = false;
  std::vector<bonedecimate::Diagnostic> Diagnostics;
  std::vector<bonedecimate::LeftOutShape> LeftOut;

  /// The diagnostic of that index; null if there is none.
  const bonedecimate::Diagnostic* At(int diagnostic) const
  {
    return diagnostic >= 0 && diagnostic < static_cast<int>(this->Diagnostics.size())
      ? &this->Diagnostics[static_cast<std::size_t>(diagnostic)]
      : nullptr;
  }

  /// The entry of that index; an empty one if there is none.
  const bonedecimate::LeftOut& LeftOutAt(int entry) const
  {
    static const bonedecimate::LeftOut nothing = {};
    const bool isOne = entry >= 0 && entry < static_cast<int>(this->LeftOut.size());
    return isOne ? this->LeftOut[static_cast<std::size_t>(entry)].Entry : nothing;
  }

  const bonedecimate::DiagnosticInfo& InfoAt(int diagnostic) const
  {
    static const bonedecimate::DiagnosticInfo nothing = {};
    const bonedecimate::Diagnostic* found = this->At(diagnostic);
    return found ? bonedecimate::InfoOf(found->Kind) : nothing;
  }
};

vtkStandardNewMacro(vtkBoneDiagnostics);

vtkBoneDiagnostics::vtkBoneDiagnostics()
  : Internal(std::make_unique<Internals>())
{
}

vtkBoneDiagnostics::~vtkBoneDiagnostics() = default;

//------------------------------------------------------------------------------
/// Before the first run, and after an update that did not get here, nothing.
const vtkBoneDiagnostics::Internals& vtkBoneDiagnostics::Last() const
{
  static const Internals none;
  return this->IsOutdated() ? none : *this->Internal;
}

int vtkBoneDiagnostics::GetNumberOfDiagnostics() const
{
  return static_cast<int>(this->Last().Diagnostics.size());
}

bool vtkBoneDiagnostics::IsUsable() const
{
  const Internals& last = this->Last();
  return last.WasRun &&
    std::none_of(last.Diagnostics.begin(), last.Diagnostics.end(),
      [](const bonedecimate::Diagnostic& diagnostic) {
        return bonedecimate::InfoOf(diagnostic.Kind).Severity == bonedecimate::Severity::Rejected;
      });
}

std::string vtkBoneDiagnostics::GetWord(int diagnostic) const
{
  return this->Last().InfoAt(diagnostic).Word;
}

std::string vtkBoneDiagnostics::GetSentence(int diagnostic) const
{
  const bonedecimate::Diagnostic* found = this->Last().At(diagnostic);
  return found ? bonedecimate::DiagnosticSentence(*found) : std::string();
}

std::string vtkBoneDiagnostics::GetSeverity(int diagnostic) const
{
  return this->Last().At(diagnostic)
    ? bonedecimate::SeverityWord(this->Last().InfoAt(diagnostic).Severity)
    : "";
}

vtkIdType vtkBoneDiagnostics::GetCount(int diagnostic) const
{
  const bonedecimate::Diagnostic* found = this->Last().At(diagnostic);
  return found ? found->Count : 0;
}

double vtkBoneDiagnostics::GetLength(int diagnostic) const
{
  const bonedecimate::Diagnostic* found = this->Last().At(diagnostic);
  return found ? found->Length : std::numeric_limits<double>::quiet_NaN();
}

std::string vtkBoneDiagnostics::GetIdsOf(int diagnostic) const
{
  const std::string of = this->Last().InfoAt(diagnostic).IdKind;
  return of == "triangle" ? "cell" : of;
}

void vtkBoneDiagnostics::GetFirstIds(int diagnostic, vtkIdList* ids) const
{
  ids->Reset();
  const bonedecimate::Diagnostic* found = this->Last().At(diagnostic);
  if (found)
  {
    std::for_each(found->First.begin(), found->First.end(),
      [ids](bonedecimate::Index id) { ids->InsertNextId(id); });
  }
}

//------------------------------------------------------------------------------
int vtkBoneDiagnostics::GetNumberOfLeftOut() const
{
  return static_cast<int>(this->Last().LeftOut.size());
}

std::string vtkBoneDiagnostics::GetLeftOutKind(int entry) const
{
  return this->Last().LeftOutAt(entry).Kind;
}

vtkIdType vtkBoneDiagnostics::GetLeftOutCount(int entry) const
{
  return this->Last().LeftOutAt(entry).Count;
}

std::string vtkBoneDiagnostics::GetLeftOutSentence(int entry) const
{
  const bonedecimate::LeftOut& found = this->Last().LeftOutAt(entry);
  return found.Count > 0 ? found.Sentence() : std::string();
}

//------------------------------------------------------------------------------
void vtkBoneDiagnostics::SetNumberOfThreads(int threads)
{
  this->Rejected().SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

//------------------------------------------------------------------------------
int vtkBoneDiagnostics::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  *this->Internal = {};
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  const bonedecimate::ConvertedSurface converted =
    bonedecimate::ToSurface(input, this->NumberOfThreads);
  this->Internal->Diagnostics = bonedecimate::Diagnose(converted.Surface, this->NumberOfThreads);
  for (bonedecimate::Diagnostic& diagnostic : this->Internal->Diagnostics)
  {
    bonedecimate::NameCells(converted, diagnostic);
  }
  this->Internal->LeftOut = converted.LeftOut;
  this->Internal->WasRun = true;
  for (const std::string& warning : converted.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  vtkPolyData::GetData(outputVector)->ShallowCopy(input);
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneDiagnostics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  for (int i = 0; i < this->GetNumberOfDiagnostics(); ++i)
  {
    os << indent << this->GetWord(i) << ": " << this->GetCount(i) << "\n";
  }
}
