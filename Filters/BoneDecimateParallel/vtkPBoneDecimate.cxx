// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPBoneDecimate.h"

#include "BoundaryStrips.h"
#include "LabelMapParts.h"
#include "Plan.h"
#include "WholeInput.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr int PortOfLabelMap = 2;
}

vtkStandardNewMacro(vtkPBoneDecimate);
vtkCxxSetObjectMacro(vtkPBoneDecimate, Controller, vtkMultiProcessController);

vtkPBoneDecimate::vtkPBoneDecimate()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPBoneDecimate::~vtkPBoneDecimate()
{
  this->SetController(nullptr);
}

vtkMultiProcessController* vtkPBoneDecimate::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
int vtkPBoneDecimate::FillInputPortInformation(int port, vtkInformation* info)
{
  const int known = this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    // First: by the first type the pipeline decides whether to hand over block by block.
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  return known;
}

//------------------------------------------------------------------------------
int vtkPBoneDecimate::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const bool isRejected = this->ReportRejectedValues();
  if (this->IsTrueAnywhere(isRejected))
  {
    if (!isRejected)
    {
      vtkErrorMacro(<< "another process rejected a value of a property");
    }
    return 0;
  }
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!this->HasProcesses() && vtkPolyData::SafeDownCast(input))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const vtkIdType outOfRange = bonedecimate::CellsOutOfRange(input);
  if (this->IsTrueAnywhere(outOfRange > 0))
  {
    if (outOfRange > 0)
    {
      vtkErrorMacro(<< outOfRange << " polygons or strips have point ids out of range");
    }
    else
    {
      vtkErrorMacro(<< "the part of another process has point ids out of range");
    }
    return 0;
  }
  if (this->IsTrueAnywhere(this->GetNumberOfInputConnections(PortOfLabelMap) > 0))
  {
    vtkErrorMacro(<< "a label map is for one surface on one process alone");
    return 0;
  }
  const bonedecimate::LabelMapOfParts map =
    bonedecimate::CompareLabelMaps(input, this->HasProcesses() ? this->Controller : nullptr);
  if (!map.IsOne)
  {
    vtkErrorMacro(<< "the parts of the surface differ in the voxel grid, in LabelValues, or in "
                     "having the arrays BoundaryLabels and GridPoint");
    return 0;
  }
  const vtkSmartPointer<vtkPolyData> whole = bonedecimate::WholeInput(input);
  vtkPolyData* reference = vtkPolyData::GetData(inputVector[1]);
  return this->HasProcesses() ? this->RunTogether(whole, reference, map.VoxelSize, outputVector)
                              : this->RunAlone(whole, reference, outputVector);
}

//------------------------------------------------------------------------------
bool vtkPBoneDecimate::HasProcesses() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
/// Sum, least or largest number of all processes.
double vtkPBoneDecimate::OfAll(double own, int operation) const
{
  double all = own;
  this->Controller->AllReduce(&own, &all, 1, operation);
  return all;
}

//------------------------------------------------------------------------------
bool vtkPBoneDecimate::IsTrueAnywhere(bool own) const
{
  return this->HasProcesses() ? this->OfAll(own ? 1.0 : 0.0, vtkCommunicator::MAX_OP) > 0.0 : own;
}

//------------------------------------------------------------------------------
/// False if the input was rejected; the reason has been reported.
bool vtkPBoneDecimate::Run(vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference)
{
  run->SetController(nullptr);
  run->SetInputData(0, input);
  run->SetInputData(1, reference);
  run->AddObserver(vtkCommand::ProgressEvent, this, &vtkPBoneDecimate::PassProgress);
  run->Update();
  return input->GetNumberOfPolys() == 0 || run->GetOutput()->GetNumberOfPolys() > 0;
}

//------------------------------------------------------------------------------
void vtkPBoneDecimate::PassProgress(
  vtkObject* caller, unsigned long vtkNotUsed(event), void* vtkNotUsed(data))
{
  auto* run = static_cast<vtkPBoneDecimate*>(caller);
  this->SetProgressText(run->GetProgressText());
  this->UpdateProgress(run->GetProgress());
  run->SetAbortExecute(this->GetAbortExecute());
}

//------------------------------------------------------------------------------
int vtkPBoneDecimate::RunAlone(
  vtkPolyData* input, vtkPolyData* reference, vtkInformationVector* outputVector)
{
  vtkNew<vtkPBoneDecimate> run;
  run->Internal->CopyOptions(*this);
  const bool isDone = this->Run(run, input, reference);
  this->Internal->TakeReport(*run);
  vtkPolyData::GetData(outputVector, 0)->ShallowCopy(run->GetOutput());
  vtkPolyData::GetData(outputVector, 1)->ShallowCopy(run->GetOutputDataObject(1));
  return isDone ? 1 : 0;
}

//------------------------------------------------------------------------------
/// The kinds of run that this one is, on several processes.
std::vector<std::string> vtkPBoneDecimate::KindsOfRun(
  vtkPolyData* input, vtkPolyData* reference, double voxelSize) const
{
  const bool hasPoints = input->GetNumberOfPoints() > 0;
  const bool isDouble = hasPoints && input->GetPoints()->GetDataType() == VTK_DOUBLE;
  const bool hasSingle = this->IsTrueAnywhere(hasPoints && !isDouble);
  const bool hasDouble = this->IsTrueAnywhere(isDouble);
  const std::pair<bool, const char*> kinds[] = { { this->GetVoxelSize() == 0.0 && voxelSize == 0.0,
                                                   "RanksWithoutVoxelSize" },
    { voxelSize == 0.0, "RanksWithoutVoxelGrid" },
    { this->IsTrueAnywhere(reference != nullptr), "RanksWithReference" },
    { hasSingle && hasDouble, "RanksOfTwoPrecisions" },
    { !this->GetPassArrays(), "RanksWithoutPassedArrays" }, { true, "Ranks" } };
  std::vector<std::string> names;
  for (const auto& [isOfKind, name] : kinds)
  {
    if (isOfKind)
    {
      names.emplace_back(name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
/// False if a run on several processes cannot follow an option; the reason has been reported.
bool vtkPBoneDecimate::AcceptOptions(vtkPolyData* input, vtkPolyData* reference, double voxelSize)
{
  std::vector<std::string> arrays;
  if (this->Internal->HasInputArray(LABEL_ARRAY))
  {
    arrays.emplace_back("LabelArrayName");
  }
  const std::string problem =
    this->FindUnsupportedOption(this->KindsOfRun(input, reference, voxelSize), arrays);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
  }
  return problem.empty();
}

//------------------------------------------------------------------------------
int vtkPBoneDecimate::RunTogether(
  vtkPolyData* input, vtkPolyData* reference, double voxelSize, vtkInformationVector* outputVector)
{
  this->Internal->TakeReport(
    *vtkSmartPointer<vtkPBoneDecimate>::New()); // forgets that of an earlier run
  if (!this->AcceptOptions(input, reference, voxelSize))
  {
    return 0;
  }
  const vtkSmartPointer<vtkPolyData> unpruned = input;
  const vtkSmartPointer<vtkPolyData> labeled = this->WithCellLabels(input);
  const vtkSmartPointer<vtkPolyData> kept = labeled ? this->PruneTogether(labeled) : nullptr;
  if (!kept)
  {
    return 0;
  }
  input = kept;
  const double diagonal = this->WholeDiagonal(input);
  if (std::isfinite(diagonal) &&
    !this->Internal->AcceptSize(diagonal, this->Internal->LargestErrorOf(voxelSize)))
  {
    return 0;
  }
  Plan plan = this->MakePlan(input, reference, voxelSize);
  plan.Unpruned = unpruned;
  this->Internal->AddComponents("input", input, this->MeetingOf(input), plan.Figures);
  if (!this->SmoothTogether(input, plan))
  {
    return 0;
  }
  vtkNew<vtkPBoneDecimate> run;
  const bool isDone = this->ReducePart(run, input, reference, plan);
  if (this->OfAll(isDone ? 1.0 : 0.0, vtkCommunicator::MIN_OP) == 0.0)
  {
    if (isDone)
    {
      vtkErrorMacro(<< "another process rejected its part of the surface");
    }
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* inputCopy = vtkPolyData::GetData(outputVector, 1);
  output->ShallowCopy(run->GetOutput());
  inputCopy->ShallowCopy(run->GetOutputDataObject(1));
  this->AddRuns(run, plan);
  if (plan.ReducesStrips)
  {
    this->ReduceSharedStrips(input, plan, output, inputCopy);
  }
  else if (this->Internal->Prunes())
  {
    this->FillInputCopy(unpruned, { output }, inputCopy);
  }
  this->CompareVoxelsTogether(output, plan);
  output->GetCellData()->RemoveArray(bonedecimate::CellLabelsName);
  inputCopy->GetCellData()->RemoveArray(bonedecimate::CellLabelsName);
  this->Report(plan, output, inputCopy);
  return 1;
}

//------------------------------------------------------------------------------
/// mm; NaN if no process proved anything. Processes without triangles do not count.
double vtkPBoneDecimate::ProvedByAll(vtkPBoneDecimate* run) const
{
  const double proved = run->GetProvedError();
  const double most = this->OfAll(std::isnan(proved) ? -1.0 : proved, vtkCommunicator::MAX_OP);
  return most < 0.0 ? std::nan("") : most;
}

//------------------------------------------------------------------------------
/// What the runs of a phase on all processes found. A run without triangles has no proof.
void vtkPBoneDecimate::AddRuns(vtkPBoneDecimate* run, Plan& plan)
{
  const int status = run->GetProofStatus();
  const bool isViolated = this->IsTrueAnywhere(status == VIOLATED) || plan.ProofStatus == VIOLATED;
  const int worst = static_cast<int>(this->OfAll(status, vtkCommunicator::MAX_OP));
  plan.ProofStatus = isViolated ? static_cast<int>(VIOLATED) : std::max(plan.ProofStatus, worst);
  const int reason = run->GetStopReason();
  const bool isAborted = this->IsTrueAnywhere(reason == ABORTED) || plan.StopReason == ABORTED;
  const int ended =
    static_cast<int>(this->OfAll(reason == ABORTED ? NOT_RUN : reason, vtkCommunicator::MAX_OP));
  plan.StopReason = isAborted ? ABORTED : ended == NOT_RUN ? plan.StopReason : ended;
  plan.Proved = std::fmax(plan.Proved, this->ProvedByAll(run));
  this->Internal->AddRun(*run);
}

//------------------------------------------------------------------------------
void vtkPBoneDecimate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
