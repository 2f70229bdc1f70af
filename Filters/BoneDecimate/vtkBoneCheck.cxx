// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneCheck.h"

#include "Doctor/Doctor.h"
#include "RejectedValues.h"
#include "ReportCells.h"
#include "SurfaceConversion.h"

#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

struct vtkBoneCheck::Internals
{
  std::vector<bonedecimate::Finding> Findings;
  bonedecimate::RejectedValues Rejected;

  /// One that says nothing where there is no such number.
  const bonedecimate::Finding* At(int finding) const
  {
    return finding >= 0 && finding < static_cast<int>(this->Findings.size())
      ? &this->Findings[static_cast<std::size_t>(finding)]
      : nullptr;
  }

  const bonedecimate::FindingInfo& InfoAt(int finding) const
  {
    static const bonedecimate::FindingInfo nothing = {};
    const bonedecimate::Finding* found = this->At(finding);
    return found ? bonedecimate::InfoOf(found->Kind) : nothing;
  }
};

vtkStandardNewMacro(vtkBoneCheck);

vtkBoneCheck::vtkBoneCheck()
  : Internal(std::make_unique<Internals>())
{
}

vtkBoneCheck::~vtkBoneCheck() = default;

//------------------------------------------------------------------------------
int vtkBoneCheck::GetNumberOfFindings() const
{
  return static_cast<int>(this->Internal->Findings.size());
}

bool vtkBoneCheck::IsUsable() const
{
  return std::none_of(this->Internal->Findings.begin(), this->Internal->Findings.end(),
    [](const bonedecimate::Finding& finding)
    { return bonedecimate::InfoOf(finding.Kind).Severity == bonedecimate::Severity::Refused; });
}

std::string vtkBoneCheck::GetWord(int finding) const
{
  return this->Internal->InfoAt(finding).Word;
}

std::string vtkBoneCheck::GetSentence(int finding) const
{
  return this->Internal->InfoAt(finding).Sentence;
}

std::string vtkBoneCheck::GetSeverity(int finding) const
{
  return this->Internal->At(finding)
    ? bonedecimate::SeverityWord(this->Internal->InfoAt(finding).Severity)
    : "";
}

vtkIdType vtkBoneCheck::GetCount(int finding) const
{
  const bonedecimate::Finding* found = this->Internal->At(finding);
  return found ? found->Count : 0;
}

double vtkBoneCheck::GetLength(int finding) const
{
  const bonedecimate::Finding* found = this->Internal->At(finding);
  return found ? found->Length : std::numeric_limits<double>::quiet_NaN();
}

std::string vtkBoneCheck::GetIdsOf(int finding) const
{
  const std::string of = this->Internal->InfoAt(finding).Of;
  return of == "triangle" ? "cell" : of;
}

void vtkBoneCheck::GetFirstIds(int finding, vtkIdList* ids) const
{
  ids->Reset();
  const bonedecimate::Finding* found = this->Internal->At(finding);
  if (found)
  {
    std::for_each(found->First.begin(), found->First.end(),
      [ids](bonedecimate::Index id) { ids->InsertNextId(id); });
  }
}

//------------------------------------------------------------------------------
void vtkBoneCheck::SetNumberOfThreads(int threads)
{
  this->Internal->Rejected.SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

std::string vtkBoneCheck::GetRejectedValue(const std::string& property) const
{
  return this->Internal->Rejected.Of(property);
}

vtkMTimeType vtkBoneCheck::GetMTime()
{
  return this->Internal->Rejected.MTime(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
int vtkBoneCheck::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->Internal->Rejected.Report(this))
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  const bonedecimate::ConvertedSurface converted =
    bonedecimate::ToSurface(input, this->NumberOfThreads);
  this->Internal->Findings = bonedecimate::Examine(converted.Surface, this->NumberOfThreads);
  for (bonedecimate::Finding& finding : this->Internal->Findings)
  {
    bonedecimate::NameCells(converted, finding);
  }
  vtkPolyData::GetData(outputVector)->ShallowCopy(input);
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  for (int i = 0; i < this->GetNumberOfFindings(); ++i)
  {
    os << indent << this->GetWord(i) << ": " << this->GetCount(i) << "\n";
  }
}
