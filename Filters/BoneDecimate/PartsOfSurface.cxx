// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartsOfSurface.cxx
 * @brief What vtkBoneDecimate offers to classes that simplify a surface in parts.
 */
#include "FilterProgress.h"
#include "Geometry/NearSurface.h"
#include "LabelArrays.h"
#include "LabelMapArrays.h"
#include "Partition/Slabs/ContinuedProof.h"
#include "Run/Input/ComponentCensus.h"
#include "Run/Input/InputSize.h"
#include "Run/Input/LabelMapInput.h"
#include "Run/Report/SizeText.h"
#include "RunInput.h"
#include "RunState.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>

namespace
{
using namespace bonedecimate;

template <typename Value>
void Append(std::vector<char>& bytes, const Value* values, std::size_t count)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  const char* first = reinterpret_cast<const char*>(values); // NOLINT: bytes of plain values
  bytes.insert(bytes.end(), first, first + count * sizeof(Value));
}

/// Reads what Append wrote, in the same order.
class ByteReader
{
public:
  explicit ByteReader(const std::vector<char>& bytes)
    : Next(bytes.data())
  {
  }

  template <typename Value>
  void Read(Value* values, std::size_t count)
  {
    const std::size_t size = count * sizeof(Value);
    std::copy(this->Next, this->Next + size, reinterpret_cast<char*>(values)); // NOLINT: the same
    this->Next += size;
  }

private:
  const char* Next;
};

std::vector<std::array<Index, 2>> ToEdges(const std::vector<std::array<vtkIdType, 2>>& ids)
{
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(ids.size());
  for (const auto& [from, to] : ids)
  {
    edges.push_back({ static_cast<Index>(from), static_cast<Index>(to) });
  }
  return edges;
}

/// The numbers of a comparison of voxels that have no list.
struct VoxelCounts
{
  std::int64_t WereGuarded = 0;
  std::int64_t WasChecked = 0;
  std::int64_t Compared = 0;
  std::int64_t Changed = 0;
  std::array<std::int64_t, 3> FirstChanged = { 0, 0, 0 };
  std::int64_t Labels = 0;
};
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::SetPart(
  const std::vector<char>& isShared, const std::vector<double>& smoothedPoints)
{
  this->Part = std::make_unique<PartOfSurface>();
  SurfacePart& part = this->Part->Part;
  part.IsShared = isShared;
  for (std::size_t i = 0; i + 2 < smoothedPoints.size(); i += 3)
  {
    part.SmoothedPoints.emplace_back(
      smoothedPoints[i], smoothedPoints[i + 1], smoothedPoints[i + 2]);
  }
  Options& options = this->Filter->State->Options;
  options = options.WithoutPruning(); // FindPrunedCells() was before
  options.AllowLargeError = true;     // the size of the whole has been accepted
  this->Filter->Modified();
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::SetNeighborsOfPart(vtkPolyData* neighbors, double distance)
{
  PartOfSurface& part = *this->Part;
  part.Neighbors =
    UsableTriangles(ToSurface(neighbors, this->Filter->State->Options.NumberOfThreads).Surface);
  part.Part.Neighbors = &part.Neighbors;
  part.Part.NeighborDistance = distance;
  this->Filter->Modified();
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::SetOriginalOfPart(
  vtkPolyData* original, const EdgesOfPart& cuts, const EdgesOfPart& originalCuts)
{
  PartOfSurface& part = *this->Part;
  part.Original = ToSurface(original, this->Filter->State->Options.NumberOfThreads);
  part.LabelsOfOriginal = ReadLabelMapArrays(original, part.Original).Source;
  part.Part.Reference = &part.Original.Surface;
  part.Part.ReferenceLabels = &part.LabelsOfOriginal;
  if (this->HasInputArray(LABEL_ARRAY))
  {
    int association = -1;
    vtkDataArray* array = this->GetInputArray(LABEL_ARRAY, original, association);
    part.PatchesOfOriginal = ReadLabels(original, part.Original, array, association);
    part.Part.ReferencePatches = part.PatchesOfOriginal ? &*part.PatchesOfOriginal : nullptr;
  }
  part.Part.CutEdges = ToEdges(cuts);
  part.Part.ReferenceCutEdges = ToEdges(originalCuts);
  this->Filter->Modified();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkBoneDecimate::Internals::GetCellLabels(vtkPolyData* input)
{
  int association = -1;
  vtkDataArray* array = this->GetInputArray(LABEL_ARRAY, input, association);
  const vtkSmartPointer<vtkDataArray> labels = LabelsOfCells(
    input, ToSurface(input, this->Filter->State->Options.NumberOfThreads), array, association);
  if (!labels)
  {
    this->RejectArray(input, LABEL_ARRAY);
  }
  return labels;
}

//------------------------------------------------------------------------------
/// The report then has the proof of what the run has changed, and the result the bounds of changed
/// points.
void vtkBoneDecimate::Internals::ProveContinuedPart(const RunInput& read, Result& result)
{
  Options options = this->Filter->State->Options;
  Report& report = result.Report;
  if (!this->Part || this->Part->Part.Reference == nullptr || !options.ProveResult ||
    report.Status != InputStatus::Good || report.Stop == StopReason::Aborted)
  {
    return;
  }
  const Surface& original = this->Part->Original.Surface;
  const Surface& before = read.Converted.Surface;
  ContinuedProof found = ProveContinued({ original, original, before, result.Surface }, options,
    true, [this](double) { return bonedecimate::ShouldContinue(*this->Filter); });
  report.Proof.WasMade = true;
  report.Proof.Status = found.Status;
  report.Proof.Tolerance = options.MaximumError;
  report.Proof.InputToOutput = found.OriginalToResult;
  report.Proof.OutputToInput = found.ResultToOriginal;
  result.ErrorBound = std::move(found.Bounds);
}

//------------------------------------------------------------------------------
std::vector<bool> vtkBoneDecimate::Internals::CellsWithoutArea(vtkPolyData* surface) const
{
  const int threads = this->Filter->State->Options.NumberOfThreads;
  std::vector<bool> are(static_cast<std::size_t>(surface->GetNumberOfCells()), false);
  const ConvertedSurface converted = ToSurface(surface, threads);
  const CensusOfPart census = TakeCensus(converted.Surface, Vector3::Zero(), {}, threads);
  for (std::size_t t = 0; t < census.OfTriangle.size(); ++t)
  {
    are[static_cast<std::size_t>(converted(t))] = census.OfTriangle[t] == None;
  }
  return are;
}

//------------------------------------------------------------------------------
std::vector<bool> vtkBoneDecimate::Internals::CellsNear(
  vtkPolyData* surface, vtkPolyData* others, double distance) const
{
  const int threads = this->Filter->State->Options.NumberOfThreads;
  std::vector<bool> are(static_cast<std::size_t>(surface->GetNumberOfCells()), false);
  const ConvertedSurface converted = ToSurface(surface, threads);
  const std::vector<char> triangles =
    TrianglesNear(converted.Surface, ToSurface(others, threads).Surface, distance, threads);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto cell = static_cast<std::size_t>(converted(t));
    are[cell] = are[cell] || triangles[t] != 0;
  }
  return are;
}

//------------------------------------------------------------------------------
std::vector<double> vtkBoneDecimate::Internals::SmoothPoints(vtkPolyData* whole)
{
  RunInput read;
  if (!this->ReadInput(whole, nullptr, {}, read))
  {
    return {};
  }
  const Options options =
    this->Filter->State->Options.WithoutPruning(); // FindPrunedCells() was before
  FilterProgress progress(*this->Filter, "Smoothing the surface");
  const SmoothedInput smoothed =
    SmoothOnly(read.Converted.Surface, options, std::ref(progress), read.Inputs);
  this->Filter->State->Report.Smoothing = smoothed.Report.Smoothing;
  const std::string problem = InputMessage(smoothed.Report);
  if (!problem.empty())
  {
    vtkErrorWithObjectMacro(this->Filter, << problem);
    return {};
  }
  Report figures;
  figures.Smoothing = smoothed.Report.Smoothing;
  figures.Parts = smoothed.Report.Parts;
  this->Filter->Warn(InputWarnings(figures));
  std::vector<double> points;
  points.reserve(3 * smoothed.Points.size());
  for (const Vector3& point : smoothed.Points)
  {
    points.insert(points.end(), point.begin(), point.end());
  }
  return points;
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::Internals::GuardsVoxels(vtkPolyData* input, double largestError)
{
  const ConvertedSurface converted = ToSurface(input, this->Filter->State->Options.NumberOfThreads);
  const ReadLabelMap map = ReadLabelMapArrays(input, converted);
  Options options = this->Filter->State->Options;
  options.MaximumError = largestError;
  return map.Problem.empty() && bonedecimate::GuardsVoxels(&map.Source, options);
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::CompareVoxels(
  vtkPolyData* whole, vtkPolyData* result, bool wereGuarded)
{
  const int threads = this->Filter->State->Options.NumberOfThreads;
  const ConvertedSurface before = ToSurface(whole, threads);
  const ConvertedSurface after = ToSurface(result, threads);
  const ReadLabelMap map = ReadLabelMapArrays(whole, before);
  result->GetFieldData()->ShallowCopy(
    whole->GetFieldData()); // so that labels have the same indices
  const ReadLabelMap ofResult = ReadLabelMapArrays(result, after);
  if (map.Problem.empty() && ofResult.Problem.empty())
  {
    this->Filter->State->Report.Voxels = CompareWithInput(
      before.Surface, after.Surface, ofResult.Source.OfTriangle, map.Source, threads, {});
    this->Filter->State->Report.Voxels.WereGuarded = wereGuarded;
  }
}

//------------------------------------------------------------------------------
std::vector<char> vtkBoneDecimate::Internals::FiguresOfSegmentation() const
{
  const VoxelReport& voxels = this->Filter->State->Report.Voxels;
  const VoxelChanges& changes = voxels.Changes;
  const VoxelCounts counts = { voxels.WereGuarded, voxels.WasChecked, changes.Compared,
    changes.Changed, changes.FirstChanged, static_cast<std::int64_t>(voxels.Values.size()) };
  std::vector<char> bytes;
  Append(bytes, &this->Filter->State->Report.Smoothing, 1);
  Append(bytes, &counts, 1);
  Append(bytes, voxels.Values.data(), voxels.Values.size());
  Append(bytes, changes.OfLabel.data(), changes.OfLabel.size());
  return bytes;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::TakeFiguresOfSegmentation(const std::vector<char>& bytes)
{
  ByteReader reader(bytes);
  VoxelReport voxels;
  VoxelCounts counts;
  reader.Read(&this->Filter->State->Report.Smoothing, 1);
  reader.Read(&counts, 1);
  voxels.WereGuarded = counts.WereGuarded != 0;
  voxels.WasChecked = counts.WasChecked != 0;
  voxels.Changes.Compared = counts.Compared;
  voxels.Changes.Changed = counts.Changed;
  voxels.Changes.FirstChanged = counts.FirstChanged;
  voxels.Values.resize(static_cast<std::size_t>(counts.Labels));
  voxels.Changes.OfLabel.resize(voxels.Values.size());
  reader.Read(voxels.Values.data(), voxels.Values.size());
  reader.Read(voxels.Changes.OfLabel.data(), voxels.Changes.OfLabel.size());
  this->Filter->State->Report.Voxels = std::move(voxels);
}

//------------------------------------------------------------------------------
bool vtkBoneDecimate::Internals::AcceptSize(double diagonal, double largestError)
{
  const SizeFigures size = { diagonal, largestError, -1, std::min(diagonal, largestError) };
  const InputStatus status = CheckSize(size, this->Filter->State->Options);
  if (status != InputStatus::Good)
  {
    vtkErrorWithObjectMacro(this->Filter, << SizeMessage(size, status));
    return false;
  }
  this->Filter->Warn(SizeWarnings(size));
  return true;
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::TakeReport(const vtkBoneDecimate& from)
{
  this->Filter->State->Keep(from.State->Report);
}
