// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneDecimateAlgorithm.h"

#include "ImageLabels.h"
#include "LabelMapOfRun.h"
#include "Mesh/Checksum.h"
#include "Options/RunKinds.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Report/ReportFigures.h"
#include "Run/Report/ReportJson.h"
#include "RunState.h"
#include "SurfaceConversion.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkBoneDecimateAlgorithm::vtkBoneDecimateAlgorithm()
  : State(new RunState)
{
}

vtkBoneDecimateAlgorithm::~vtkBoneDecimateAlgorithm() = default;

//------------------------------------------------------------------------------
bool vtkBoneDecimateAlgorithm::HasReportOfItself(vtkPolyData* surface)
{
  auto* const checksum = vtkStringArray::SafeDownCast(
    surface->GetFieldData()->GetAbstractArray("bonedecimate.output.checksum"));
  return checksum != nullptr && checksum->GetNumberOfValues() > 0 &&
    checksum->GetValue(0) == GetTriangleChecksum(surface);
}

std::string vtkBoneDecimateAlgorithm::GetTriangleChecksum(vtkPolyData* surface)
{
  constexpr int allThreads = 0;
  return bonedecimate::TriangleChecksumText(bonedecimate::TriangleChecksum(
    bonedecimate::ToSurface(surface, allThreads).Surface, allThreads));
}

//------------------------------------------------------------------------------
bool vtkBoneDecimateAlgorithm::HasOption(const std::string&) const
{
  return false;
}

bool vtkBoneDecimateAlgorithm::SetOptionFromText(const std::string& name, const std::string& text)
{
  if (!this->HasOption(name))
  {
    vtkErrorMacro(<< "there is no option '" << name << "'");
    return false;
  }
  this->State->SetFromText(this, name, text);
  return this->GetRejectedValue(name).empty();
}

std::string vtkBoneDecimateAlgorithm::GetOptionAsText(const std::string& name) const
{
  return this->HasOption(name)
    ? bonedecimate::OptionText(this->State->Options, *bonedecimate::FindOption(name))
    : std::string();
}

//------------------------------------------------------------------------------
std::string vtkBoneDecimateAlgorithm::FindUnsupportedOption(
  const std::vector<std::string>& kinds, const std::vector<std::string>& alsoUsed) const
{
  std::vector<bonedecimate::RunKind> rows;
  rows.reserve(kinds.size());
  for (const std::string& kind : kinds)
  {
    rows.push_back(bonedecimate::FindRunKind(kind));
  }
  std::vector<bonedecimate::Request> requests = bonedecimate::RequestsOf(this->State->Options);
  for (bonedecimate::Request& request : requests)
  {
    request.IsUsed =
      request.IsUsed || std::find(alsoUsed.begin(), alsoUsed.end(), request.Name) != alsoUsed.end();
  }
  return bonedecimate::FindUnsupported(rows, requests);
}

//------------------------------------------------------------------------------
void vtkBoneDecimateAlgorithm::SetLabelMapData(vtkImageData* map)
{
  this->SetInputData(this->LabelMapPort, map);
}

void vtkBoneDecimateAlgorithm::SetLabelMapConnection(vtkAlgorithmOutput* map)
{
  this->SetInputConnection(this->LabelMapPort, map);
}

void vtkBoneDecimateAlgorithm::SetLabel(vtkTypeInt64 label)
{
  if (this->Label != label)
  {
    this->Label = label;
    this->Modified();
    this->OptionChanged("Label");
  }
}

void vtkBoneDecimateAlgorithm::AddLabelMapPort()
{
  this->LabelMapPort = this->GetNumberOfInputPorts();
  this->SetNumberOfInputPorts(this->LabelMapPort + 1);
}

bonedecimate::LabelMapRequest vtkBoneDecimateAlgorithm::GetLabelMapRequest(
  vtkInformationVector** inputs) const
{
  return { this->LabelMapPort < 0 ? nullptr : vtkImageData::GetData(inputs[this->LabelMapPort]),
    this->Label };
}

int vtkBoneDecimateAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port != this->LabelMapPort)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

/// The whole map.
int vtkBoneDecimateAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  vtkInformation* map =
    this->LabelMapPort < 0 ? nullptr : inputs[this->LabelMapPort]->GetInformationObject(0);
  if (map != nullptr)
  {
    bonedecimate::RequestWholeImage(map);
  }
  return result;
}

//------------------------------------------------------------------------------
/// Before the first run, and after an update that did not get here, a run without figures.
const vtkBoneDecimateAlgorithm::RunState& vtkBoneDecimateAlgorithm::Last() const
{
  static const RunState none;
  return this->IsOutdated() ? none : *this->State;
}

int vtkBoneDecimateAlgorithm::GetStopReason() const
{
  return static_cast<int>(this->Last().Report.Stop);
}

std::string vtkBoneDecimateAlgorithm::GetStopReasonAsString() const
{
  return bonedecimate::StopReasonSentence(this->Last().Report.Stop);
}

double vtkBoneDecimateAlgorithm::GetProvedError() const
{
  return bonedecimate::ProvedError(this->Last().Report);
}

int vtkBoneDecimateAlgorithm::GetProofStatus() const
{
  const bonedecimate::ErrorProof& proof = this->Last().Report.Proof;
  return proof.WasMade || proof.Status == bonedecimate::ProofStatus::Aborted
    ? static_cast<int>(proof.Status)
    : NO_PROOF;
}

std::string vtkBoneDecimateAlgorithm::GetProofStatusAsString() const
{
  const int status = this->GetProofStatus();
  return status == NO_PROOF && !this->Last().Report.Proof.WasMade
    ? "no_proof"
    : bonedecimate::ProofStatusWord(static_cast<bonedecimate::ProofStatus>(status));
}

double vtkBoneDecimateAlgorithm::GetMeasuredError() const
{
  return bonedecimate::MeasuredError(this->Last().Report);
}

vtkIdType vtkBoneDecimateAlgorithm::GetNumberOfInputTriangles() const
{
  return static_cast<vtkIdType>(this->Last().Report.Input.Faces);
}

vtkIdType vtkBoneDecimateAlgorithm::GetNumberOfOutputTriangles() const
{
  return static_cast<vtkIdType>(this->Last().Report.Output.Faces);
}

vtkIdType vtkBoneDecimateAlgorithm::GetNumberOfRejectedEdits() const
{
  return static_cast<vtkIdType>(bonedecimate::RejectedEdits(this->Last().Report));
}

vtkIdType vtkBoneDecimateAlgorithm::GetNumberOfRejectedEdits(const std::string& reason) const
{
  return static_cast<vtkIdType>(bonedecimate::RejectedEdits(this->Last().Report, reason));
}

//------------------------------------------------------------------------------
std::string vtkBoneDecimateAlgorithm::GetReportAsJson() const
{
  return bonedecimate::ReportJson(this->Last().Entries.All());
}

int vtkBoneDecimateAlgorithm::GetNumberOfReportEntries() const
{
  return this->Last().Entries.Count();
}

std::string vtkBoneDecimateAlgorithm::GetReportEntryName(int entry) const
{
  return this->Last().Entries.Name(entry);
}

std::string vtkBoneDecimateAlgorithm::GetReportEntryUnit(const std::string& name) const
{
  return this->Last().Entries.Unit(name);
}

double vtkBoneDecimateAlgorithm::GetReportValue(const std::string& name) const
{
  return this->Last().Entries.Value(name);
}

std::string vtkBoneDecimateAlgorithm::GetReportText(const std::string& name) const
{
  return this->Last().Entries.Text(name);
}

//------------------------------------------------------------------------------
std::string vtkBoneDecimateAlgorithm::OptionProblem(
  const bonedecimate::Options&, const std::string&) const
{
  return {};
}

void vtkBoneDecimateAlgorithm::OptionChanged(const std::string&) {}

//------------------------------------------------------------------------------
void vtkBoneDecimateAlgorithm::ForgetReport()
{
  this->State->Keep(bonedecimate::Report());
}

vtkTypeBool vtkBoneDecimateAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    this->ForgetReport();
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkBoneDecimateAlgorithm::Warn(const std::vector<std::string>& sentences)
{
  for (const std::string& sentence : sentences)
  {
    vtkWarningMacro(<< sentence);
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimateAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "StopReason: " << this->GetStopReasonAsString() << "\n";
  os << indent << "ProvedError: " << this->GetProvedError() << " mm\n";
}
