// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneDecimate.h"

#include "Decimate.h"
#include "FilterProgress.h"
#include "InputSize.h"
#include "LabelArrays.h"
#include "NamedEntries.h"
#include "OptionTable.h"
#include "RejectedValues.h"
#include "ReportCells.h"
#include "ReportTable.h"
#include "SurfaceConversion.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <optional>

vtkStandardNewMacro(vtkBoneDecimate);

//------------------------------------------------------------------------------
struct vtkBoneDecimate::Internals
{
  bonedecimate::Options Options;
  bonedecimate::Report Report;
  bonedecimate::NamedEntries Entries{ bonedecimate::ReportEntries(bonedecimate::Report()) };

  bonedecimate::RejectedValues Rejected;
  bool IsPart = false; // of a surface whose size is another one

  void Keep(const bonedecimate::Report& report)
  {
    this->Report = report;
    if (this->IsPart)
    {
      this->Report.Size = {};
      this->Report.Asked = {}; // its options are made from those of the whole
    }
    this->Entries = bonedecimate::NamedEntries{ bonedecimate::ReportEntries(this->Report) };
  }

  bool WritesSingle(bool inputIsSingle) const
  {
    using Precision = bonedecimate::PointsPrecision;
    const Precision precision = this->Options.OutputPointsPrecision;
    return precision == Precision::Single || (precision == Precision::Default && inputIsSingle);
  }

  /// Sets an option of the table, or rejects its value.
  void Set(vtkBoneDecimate* filter, const char* name, const bonedecimate::OptionValue& value)
  {
    const bonedecimate::OptionInfo& info = *bonedecimate::FindOption(name);
    const bonedecimate::OptionValue before = bonedecimate::GetOption(this->Options, info);
    const bool wasExplicit = this->Options.TargetReductionIsExplicit;
    const bool isValid =
      this->Rejected.Check(filter, name, bonedecimate::SetOption(this->Options, info, value));
    if (isValid &&
      (before != bonedecimate::GetOption(this->Options, info) ||
        wasExplicit != this->Options.TargetReductionIsExplicit))
    {
      filter->Modified();
    }
  }
};

vtkBoneDecimate::vtkBoneDecimate()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkBoneDecimate::~vtkBoneDecimate() = default;

//------------------------------------------------------------------------------
// One line a property: range and default stand in the core's table of options.
#define vtkBoneDecimateOption(name, argument, travel, result)                                      \
  void vtkBoneDecimate::Set##name(argument value)                                                  \
  {                                                                                                \
    this->Internal->Set(this, #name, static_cast<travel>(value));                                  \
  }                                                                                                \
  result vtkBoneDecimate::Get##name() const                                                        \
  {                                                                                                \
    return static_cast<result>(this->Internal->Options.name);                                      \
  }

// clang-format off
vtkBoneDecimateOption(Mode, int, int, int)
vtkBoneDecimateOption(TargetNumberOfTriangles, int, int, int)
vtkBoneDecimateOption(TargetReduction, double, double, double)
vtkBoneDecimateOption(MaximumError, double, double, double)
vtkBoneDecimateOption(AllowLargeError, bool, bool, bool)
vtkBoneDecimateOption(KeepClearance, bool, bool, bool)
vtkBoneDecimateOption(NormalTolerance, double, double, double)
vtkBoneDecimateOption(AutomaticNormalTolerance, bool, bool, bool)
vtkBoneDecimateOption(MergePoints, bool, bool, bool)
vtkBoneDecimateOption(MeasureDistances, bool, bool, bool)
vtkBoneDecimateOption(MeasureInputDistances, bool, bool, bool)
vtkBoneDecimateOption(NumberOfThreads, int, int, int)
vtkBoneDecimateOption(OutputPointsPrecision, int, int, int)
vtkBoneDecimateOption(PassArrays, bool, bool, bool)
vtkBoneDecimateOption(MakeMaps, bool, bool, bool)
vtkBoneDecimateOption(RecomputeNormals, bool, bool, bool)
vtkBoneDecimateOption(DistanceArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(RunningErrorArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(PointCountArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(InputDistanceArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(ProveResult, bool, bool, bool)
vtkBoneDecimateOption(ErrorBoundArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(InputErrorBoundArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(ErrorPreset, int, int, int)
vtkBoneDecimateOption(VoxelSize, double, double, double)
vtkBoneDecimateOption(ToleranceArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(LabelArrayName, const std::string&, std::string, std::string)
vtkBoneDecimateOption(PruneSize, double, double, double)
vtkBoneDecimateOption(PruneArea, double, double, double)
vtkBoneDecimateOption(PruneVolume, double, double, double)
vtkBoneDecimateOption(PruneTriangles, int, int, int)
vtkBoneDecimateOption(ExamineInput, bool, bool, bool)
// clang-format on
#undef vtkBoneDecimateOption

  //------------------------------------------------------------------------------
  int vtkBoneDecimate::GetStopReason() const
{
  return static_cast<int>(this->Internal->Report.Stop);
}

std::string vtkBoneDecimate::GetStopReasonAsString() const
{
  return bonedecimate::StopReasonSentence(this->Internal->Report.Stop);
}

int vtkBoneDecimate::GetNumberOfReportEntries() const
{
  return this->Internal->Entries.Count();
}

std::string vtkBoneDecimate::GetReportEntryName(int entry) const
{
  return this->Internal->Entries.Name(entry);
}

std::string vtkBoneDecimate::GetReportEntryUnit(const std::string& name) const
{
  return this->Internal->Entries.Unit(name);
}

double vtkBoneDecimate::GetReportValue(const std::string& name) const
{
  return this->Internal->Entries.Value(name);
}

std::string vtkBoneDecimate::GetReportText(const std::string& name) const
{
  return this->Internal->Entries.Text(name);
}

//------------------------------------------------------------------------------
std::string vtkBoneDecimate::GetRejectedValue(const std::string& property) const
{
  return this->Internal->Rejected.Of(property);
}

vtkMTimeType vtkBoneDecimate::GetMTime()
{
  return this->Internal->Rejected.MTime(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::ReportRejectedValues()
{
  return this->Internal->Rejected.Report(this);
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::ForgetTargetReduction()
{
  this->Internal->Rejected.Check(this, "TargetReduction", {});
  bonedecimate::Options& options = this->Internal->Options;
  if (options.TargetReductionIsExplicit)
  {
    options.TargetReduction = bonedecimate::Options().TargetReduction;
    options.TargetReductionIsExplicit = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::IsTargetReductionSet() const
{
  return this->Internal->Options.TargetReductionIsExplicit;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::CopyOptions(const vtkBoneDecimate& from, bool isPart)
{
  this->Internal->Options = from.Internal->Options;
  this->Internal->Rejected = from.Internal->Rejected;
  this->Internal->IsPart = isPart;
  this->Internal->Options.AllowLargeError |= isPart;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::AcceptSize(double diagonal, double largestError)
{
  const bonedecimate::SizeFigures size = { diagonal, largestError, -1,
    std::min(diagonal, largestError) };
  const bonedecimate::InputStatus status = bonedecimate::CheckSize(size, this->Internal->Options);
  if (status != bonedecimate::InputStatus::Good)
  {
    vtkErrorMacro(<< bonedecimate::SizeMessage(size, status));
    return false;
  }
  this->Warn(bonedecimate::SizeWarnings(size));
  return true;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(1, reference);
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

//------------------------------------------------------------------------------
int vtkBoneDecimate::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkBoneDecimate::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  const bonedecimate::Options& options = this->Internal->Options;
  const std::string& toleranceName = options.ToleranceArrayName;
  const bool hasTolerances = !toleranceName.empty() && input->GetNumberOfPoints() > 0;
  const std::optional<std::vector<double>> tolerances =
    hasTolerances ? bonedecimate::ReadPointValues(input, toleranceName) : std::vector<double>();
  if (!tolerances)
  {
    vtkErrorMacro(<< "the input has no point array '" << toleranceName << "' of one component");
    return 0;
  }
  const bonedecimate::ConvertedSurface converted =
    bonedecimate::ToSurface(input, options.NumberOfThreads);
  const std::string& labelName = options.LabelArrayName;
  const bool hasLabels = !labelName.empty() && input->GetNumberOfPoints() > 0;
  const std::optional<bonedecimate::Labels> labels =
    hasLabels ? bonedecimate::ReadLabels(input, converted, labelName) : bonedecimate::Labels();
  if (!labels)
  {
    vtkErrorMacro(<< "the input has no cell or point array '" << labelName << "' of whole numbers");
    return 0;
  }
  vtkPolyData* reference = vtkPolyData::GetData(inputVector[1]);
  const bonedecimate::ConvertedSurface first = reference != nullptr
    ? bonedecimate::ToSurface(reference, options.NumberOfThreads)
    : bonedecimate::ConvertedSurface();
  bonedecimate::Companions companions = { converted.IsSingle,
    bonedecimate::NeedsOrigins(input, options) };
  companions.Tolerances = hasTolerances ? &*tolerances : nullptr;
  companions.Reference = reference != nullptr ? &first.Surface : nullptr;
  companions.Labels = hasLabels ? &*labels : nullptr;
  bonedecimate::Result result = bonedecimate::Decimate(
    converted.Surface, options, [this](double fraction) { return this->GoesOn(fraction); },
    companions);
  bonedecimate::NameCells(converted, result.Report);
  this->Internal->Keep(result.Report);
  if (!this->Accept(bonedecimate::InputMessage(result.Report)))
  {
    return 0;
  }
  this->Warn(converted.Warnings);
  this->Warn(bonedecimate::InputWarnings(this->Internal->Report));
  const bool single = this->Internal->WritesSingle(converted.IsSingle);
  bonedecimate::FillOutput(
    result, converted, options, single, input, vtkPolyData::GetData(outputVector, 0));
  bonedecimate::FillInputCopy(result, options, input, vtkPolyData::GetData(outputVector, 1));
  const std::string contradiction = bonedecimate::ProofMessage(result.Report);
  if (!contradiction.empty())
  {
    vtkErrorMacro(<< contradiction);
  }
  return 1;
}

//------------------------------------------------------------------------------
/// False if the input was refused. An empty one is no failure, one without triangles only deserves a warning.
bool vtkBoneDecimate::Accept(const std::string& problem)
{
  switch (this->Internal->Report.Status)
  {
    case bonedecimate::InputStatus::Good:
    case bonedecimate::InputStatus::Empty:
      return true;
    case bonedecimate::InputStatus::NoTriangles:
      vtkWarningMacro(<< problem);
      return true;
    default:
      vtkErrorMacro(<< problem);
      return false;
  }
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Warn(const std::vector<std::string>& sentences)
{
  for (const std::string& sentence : sentences)
  {
    vtkWarningMacro(<< sentence);
  }
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::GoesOn(double fraction)
{
  const bool goesOn = bonedecimate::GoesOn(*this, fraction);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  if (!goesOn)
  {
    this->SetAbortOutput(false); // the output is a valid surface and stays
  }
#endif
  return goesOn;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const bonedecimate::OptionInfo& info : bonedecimate::OptionTable())
  {
    os << indent << info.Name << ": " << bonedecimate::OptionText(this->Internal->Options, info)
       << (info.Unit.empty() ? "" : " ") << info.Unit << "\n";
  }
  os << indent << "StopReason: " << this->GetStopReasonAsString() << "\n";
}
