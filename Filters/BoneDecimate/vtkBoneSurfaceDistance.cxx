// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneSurfaceDistance.h"

#include "FilterProgress.h"
#include "NamedArrays.h"
#include "NamedEntries.h"
#include "Pieces.h"
#include "RejectedValues.h"
#include "Run/Input/Tolerances.h"
#include "Run/Output/ComparedSurface.h"
#include "Run/Report/CertificateTable.h"
#include "Run/Report/PairWarnings.h"
#include "Run/Report/ReportJson.h"
#include "Run/Report/SizeText.h"
#include "SurfaceConversion.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"

#include <functional>
#include <limits>

vtkStandardNewMacro(vtkBoneSurfaceDistance);

namespace
{
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
struct vtkBoneSurfaceDistance::Internals
{
  bonedecimate::CertificateOptions Options;
  bonedecimate::Certificate Result;
  bonedecimate::NamedEntries Entries{ {} };
  double LowerBound = NotKnown; // mm
  double UpperBound = NotKnown; // mm

  void Take(std::vector<bonedecimate::ReportEntry> entries)
  {
    this->Entries = bonedecimate::NamedEntries(std::move(entries));
    this->LowerBound = this->Entries.Value("lower");
    this->UpperBound = this->Entries.Value("upper");
  }
};

namespace
{
constexpr double NoTolerance = -1.0; // mm

/// Triangles that bounds name become the cells from which they came.
void NameCells(const bonedecimate::ConvertedSurface& from, const bonedecimate::ConvertedSurface& to,
  bonedecimate::DirectedCertificate& directed)
{
  const auto name = [](bonedecimate::Index& triangle, const std::vector<vtkIdType>& cells)
  {
    triangle = triangle < 0
      ? triangle
      : static_cast<bonedecimate::Index>(cells[static_cast<std::size_t>(triangle)]);
  };
  for (bonedecimate::DistanceBounds* bounds : { &directed.Distance, &directed.Excess })
  {
    name(bounds->Triangle, from.CellOfTriangle);
    name(bounds->NearestTriangle, to.CellOfTriangle);
  }
}
}

vtkBoneSurfaceDistance::vtkBoneSurfaceDistance()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkBoneSurfaceDistance::~vtkBoneSurfaceDistance() = default;

//------------------------------------------------------------------------------
void vtkBoneSurfaceDistance::SetTolerance(double millimeters)
{
  this->Rejected().SetNumber(
    this, "Tolerance", { 0.0, bonedecimate::MaxNumber, false, "mm" }, millimeters, this->Tolerance);
}

void vtkBoneSurfaceDistance::RemoveTolerance()
{
  this->Rejected().Set(this, "Tolerance", {}, NoTolerance, this->Tolerance);
}

void vtkBoneSurfaceDistance::SetToleranceOrNone(double millimeters)
{
  millimeters == NoTolerance ? this->RemoveTolerance() : this->SetTolerance(millimeters);
}

void vtkBoneSurfaceDistance::SetRelativeGap(double gap)
{
  this->Rejected().SetNumber(this, "RelativeGap", { 1e-12, 1.0 }, gap, this->RelativeGap);
}

void vtkBoneSurfaceDistance::SetMeanPrecision(double precision)
{
  this->Rejected().SetNumber(this, "MeanPrecision", { 1e-4, 1.0 }, precision, this->MeanPrecision);
}

void vtkBoneSurfaceDistance::SetNumberOfThreads(int threads)
{
  this->Rejected().SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

//------------------------------------------------------------------------------
/// Before the first run, and after an update that did not get here, a run without figures.
const vtkBoneSurfaceDistance::Internals& vtkBoneSurfaceDistance::Last() const
{
  static const Internals none;
  return this->IsOutdated() ? none : *this->Internal;
}

int vtkBoneSurfaceDistance::GetStatus() const
{
  return static_cast<int>(this->Last().Result.Proof);
}

std::string vtkBoneSurfaceDistance::GetStatusAsString() const
{
  return bonedecimate::ProofStatusWord(this->Last().Result.Proof);
}

double vtkBoneSurfaceDistance::GetLowerBound() const
{
  return this->Last().LowerBound;
}

double vtkBoneSurfaceDistance::GetUpperBound() const
{
  return this->Last().UpperBound;
}

bool vtkBoneSurfaceDistance::GetWasStopped() const
{
  return this->Last().Result.Status == bonedecimate::CertificateStatus::Aborted;
}

std::string vtkBoneSurfaceDistance::GetReportAsJson() const
{
  return bonedecimate::ReportJson(this->Last().Entries.All());
}

int vtkBoneSurfaceDistance::GetNumberOfReportEntries() const
{
  return this->Last().Entries.Count();
}

std::string vtkBoneSurfaceDistance::GetReportEntryName(int entry) const
{
  return this->Last().Entries.Name(entry);
}

std::string vtkBoneSurfaceDistance::GetReportEntryUnit(const std::string& name) const
{
  return this->Last().Entries.Unit(name);
}

double vtkBoneSurfaceDistance::GetReportValue(const std::string& name) const
{
  return this->Last().Entries.Value(name);
}

std::string vtkBoneSurfaceDistance::GetReportText(const std::string& name) const
{
  return this->Last().Entries.Text(name);
}

//------------------------------------------------------------------------------
int vtkBoneSurfaceDistance::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Internal->Result = {};
  this->Internal->Take({});
  if (bonedecimate::RequestedPiece(inputVector[0]).Pieces > 1)
  {
    vtkErrorMacro(<< "vtkBoneSurfaceDistance is for one process alone: what is nearest to a point "
                     "of a part may lie in another; gather both surfaces first");
    return 0;
  }
  vtkPolyData* reference = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* result = vtkPolyData::GetData(inputVector[1]);
  if (this->ReportRejectedValues() || !this->TakeTolerances(reference) ||
    !this->Compare(reference, result))
  {
    return 0;
  }
  this->FillOutput(reference, vtkPolyData::GetData(outputVector, 0), true);
  this->FillOutput(result, vtkPolyData::GetData(outputVector, 1), false);
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneSurfaceDistance::Warn(
  const std::string& surface, const std::vector<std::string>& sentences)
{
  for (const std::string& sentence : sentences)
  {
    vtkWarningMacro(<< surface << sentence);
  }
}

//------------------------------------------------------------------------------
bool vtkBoneSurfaceDistance::TakeTolerances(vtkPolyData* reference)
{
  bonedecimate::CertificateOptions& options = this->Internal->Options;
  options = bonedecimate::CertificateOptions();
  if (this->Tolerance >= 0.0)
  {
    options.Tolerance = this->Tolerance;
  }
  const std::string& name = this->ToleranceArrayName;
  if (name.empty())
  {
    return true;
  }
  std::optional<std::vector<double>> values =
    bonedecimate::ReadNumbers(reference->GetPointData()->GetArray(name.c_str()));
  if (!values)
  {
    vtkErrorMacro(<< "the reference has no point array '" << name
                  << "' of one component (there are: "
                  << bonedecimate::ListOfArrays(reference->GetPointData()) << ")");
    return false;
  }
  bonedecimate::Report found;
  found.Status = bonedecimate::CheckTolerances(
    *values, static_cast<std::size_t>(reference->GetNumberOfPoints()), true, found.Cleaning);
  if (found.Status != bonedecimate::InputStatus::Good)
  {
    vtkErrorMacro(<< bonedecimate::InputMessage(found));
    return false;
  }
  options.ToleranceMap = std::move(*values);
  return true;
}

//------------------------------------------------------------------------------
bool vtkBoneSurfaceDistance::Compare(vtkPolyData* reference, vtkPolyData* result)
{
  const bonedecimate::ConvertedSurface one =
    bonedecimate::ToSurface(reference, this->NumberOfThreads);
  const bonedecimate::ConvertedSurface two = bonedecimate::ToSurface(result, this->NumberOfThreads);
  this->Warn("reference: ", one.Warnings);
  this->Warn("result: ", two.Warnings);
  this->Warn("", bonedecimate::PairSizeWarnings(one.Surface, two.Surface, this->Tolerance));
  bonedecimate::CertificateOptions& options = this->Internal->Options;
  options.TightBounds = this->TightBounds;
  options.RelativeGap = this->RelativeGap;
  options.WithBoundaries = this->MeasureBoundaries;
  options.WithMeans = this->MeasureMeans;
  options.MeanPrecision = this->MeanPrecision;
  options.WithPointDistances = !this->SignedDistanceArrayName.empty();
  options.NumberOfThreads = this->NumberOfThreads;
  options.OnBounds = nullptr;
  if (this->FollowBounds)
  {
    options.OnBounds = [this](double lower, double upper)
    {
      this->Internal->LowerBound = lower;
      this->Internal->UpperBound = upper;
    };
  }
  bonedecimate::Certificate& certificate = this->Internal->Result;
  bonedecimate::FilterProgress progress(*this, "Proving the distance");
  bonedecimate::PairFigures figures;
  certificate = bonedecimate::CertifyPair({ one.Surface, one.LeftOut },
    { two.Surface, two.LeftOut }, options, this->MeasureSurfaces, std::ref(progress), figures);
  NameCells(one, two, certificate.ReferenceToResult);
  NameCells(two, one, certificate.ResultToReference);
  NameCells(one, two, certificate.BoundaryOfReferenceToResult);
  NameCells(two, one, certificate.BoundaryOfResultToReference);
  this->Warn("", bonedecimate::PairWarnings(figures));
  this->Internal->Take(bonedecimate::CertificateEntries(certificate, figures));
  return this->Accept(static_cast<int>(certificate.Status));
}

//------------------------------------------------------------------------------
/// False if there is nothing to return.
bool vtkBoneSurfaceDistance::Accept(int status)
{
  const auto found = static_cast<bonedecimate::CertificateStatus>(status);
  switch (found)
  {
    case bonedecimate::CertificateStatus::Good:
    case bonedecimate::CertificateStatus::Aborted:
      return true;
    case bonedecimate::CertificateStatus::EmptyReference:
    case bonedecimate::CertificateStatus::EmptyResult:
      vtkWarningMacro(<< bonedecimate::StatusSentence(found));
      return true;
    default:
      vtkErrorMacro(<< bonedecimate::StatusSentence(found));
      return false;
  }
}

//------------------------------------------------------------------------------
void vtkBoneSurfaceDistance::FillOutput(vtkPolyData* input, vtkPolyData* output, bool isReference)
{
  output->ShallowCopy(input);
  const bonedecimate::Certificate& certificate = this->Internal->Result;
  const bonedecimate::SignedDistances& points =
    isReference ? certificate.ReferenceToResult.Points : certificate.ResultToReference.Points;
  if (!points.Distance.empty())
  {
    vtkNew<vtkDoubleArray> distances;
    distances->SetName(this->SignedDistanceArrayName.c_str());
    distances->SetComponentName(0, "mm");
    vtkNew<vtkSignedCharArray> sides;
    sides->SetName(this->SideArrayName.c_str());
    for (std::size_t i = 0; i < points.Distance.size(); ++i)
    {
      distances->InsertNextValue(points.Side[i] < 0 ? -points.Distance[i] : points.Distance[i]);
      sides->InsertNextValue(points.Side[i]);
    }
    vtkPointData* data = output->GetPointData();
    data->AddArray(distances);
    data->SetActiveScalars(distances->GetName()); // what a view colors by
    data->AddArray(sides);
  }
  bonedecimate::SetReport(
    this->Internal->Entries.All(), bonedecimate::ArraysOfCertificate(), output->GetFieldData());
}

//------------------------------------------------------------------------------
void vtkBoneSurfaceDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << " mm\n";
  os << indent << "ToleranceArrayName: " << this->ToleranceArrayName << "\n";
  os << indent << "TightBounds: " << this->TightBounds << "\n";
  os << indent << "RelativeGap: " << this->RelativeGap << "\n";
  os << indent << "MeasureBoundaries: " << this->MeasureBoundaries << "\n";
  os << indent << "MeasureMeans: " << this->MeasureMeans << "\n";
  os << indent << "MeasureSurfaces: " << this->MeasureSurfaces << "\n";
  os << indent << "FollowBounds: " << this->FollowBounds << "\n";
  os << indent << "MeanPrecision: " << this->MeanPrecision << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "SignedDistanceArrayName: " << this->SignedDistanceArrayName << "\n";
  os << indent << "SideArrayName: " << this->SideArrayName << "\n";
  os << indent << "Status: " << this->GetStatusAsString() << "\n";
}
