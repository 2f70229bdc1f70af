// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentSlabs.h"

#include "ImageLabels.h"
#include "IntensityChecks.h"
#include "LabelFieldOrder.h"
#include "LabelMapArrays.h"
#include "LabelMaps/LabelVolume.h"
#include "LabelMaps/WholeLabels.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Layers/LayerDivision.h"
#include "Mesh/SurfaceAssembly.h"
#include "NamedLabels.h"
#include "SegmentChoice.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>

namespace bonedecimate
{
using volume::SlabReader;
using volume::Volume;
using volume::VolumeHeader;

namespace
{
constexpr std::int64_t TrianglesPerChange = 2; // of a closed surface of few handles

ImageLabels LabelsOfSlab(const Volume& slab)
{
  return ReadImageLabels(
    slab.Image, slab.Image->GetPointData()->GetScalars(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
}

/// As an extraction takes it.
VoxelGrid GridOf(const VolumeHeader& header)
{
  const vtkNew<vtkImageData> corner; // its first voxel
  corner->SetDimensions(1, 1, 1);
  corner->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  corner->GetPointData()->GetScalars()->Fill(1.0);
  SetLabelGrid(header.Geometry, {}, corner);
  const ImageLabels labels =
    ReadImageLabels(corner, corner->GetPointData()->GetScalars(), vtkDataObject::POINT);
  VoxelGrid grid = ExtractLabelSurfaces(labels.Image, {}).Source.Grid;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.Dimensions[axis] = static_cast<Index>(header.Size[axis]);
  }
  if (!header.Layers.empty())
  {
    const vtkNew<vtkImageData> layers;
    SetLabelGrid(header.Geometry, header.Layers, layers);
    grid.Spacing[2] = layers->GetSpacing()[2];
    vtkDataArray* const positions = layers->GetFieldData()->GetArray(GridLayersName);
    for (vtkIdType k = 0; k < positions->GetNumberOfTuples(); ++k)
    {
      grid.Layers.push_back(positions->GetComponent(k, 0));
    }
  }
  return grid;
}

/// As vtkBoneSurfaces stores them.
void RoundToSingle(std::vector<Vector3>& points)
{
  for (Vector3& p : points)
  {
    p = RoundedToSingle(p);
  }
}
}

SegmentSlabs::SegmentSlabs(const Arguments& arguments)
  : Requested(arguments)
{
  SlabReader reader(this->Open());
  const VolumeHeader& header = reader.GetHeader();
  this->BytesInALayer = header.BytesInALayer();
  this->ReadsWhole = header.IsReadWhole;
  this->Note = header.Note;
  this->Problem = header.Problem;
  if (this->Problem.empty())
  {
    this->Map.Grid = GridOf(header);
    volume::AppendNote(this->Note, LabelGridNote(header.Geometry, header.Size));
    const std::set<std::int64_t> labels = this->Survey(reader);
    if (this->Problem.empty())
    {
      this->Choose(labels, header.Fields);
    }
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<volume::IsolatedReader> SegmentSlabs::Open() const
{
  return volume::OpenVolume(this->Requested.Inputs[0], this->Requested.LabelMap.GetSpacing(),
    SelectionOf(this->Requested.Segments, this->Requested.Inputs[0]));
}

//------------------------------------------------------------------------------
std::set<std::int64_t> SegmentSlabs::Survey(SlabReader& reader)
{
  std::set<std::int64_t> labels;
  std::string rounding;
  this->Problem = volume::VisitSlabs(reader,
    [&](const Volume& slab)
    {
      const volume::WholeLabels whole = volume::MakeWholeLabels(slab.Image);
      const std::string problem =
        whole.Problem.empty() ? LabelsOfSlab(slab).Problem : whole.Problem;
      rounding = rounding.empty() ? whole.Note : rounding;
      if (problem.empty())
      {
        CollectLabels(slab.Image, labels);
        volume::AppendCounts(volume::CountLabelChanges(slab), this->Changes);
      }
      return problem;
    });
  volume::AppendNote(this->Note, rounding);
  return labels;
}

//------------------------------------------------------------------------------
void SegmentSlabs::Choose(const std::set<std::int64_t>& labels, vtkFieldData* fields)
{
  const std::string& path = this->Requested.Inputs[0];
  const FoundSegments found = FindSegments(labels, fields, this->Requested.Segments, path);
  this->Remark = found.Note;
  WriteNamedLabels(found.Present, this->Fields);
  std::vector<std::string> warnings;
  const std::vector<NamedLabel> chosen =
    ChooseSegments(found, this->Requested.Segments, path, warnings);
  for (const NamedLabel& label : chosen)
  {
    this->Map.Values.push_back(label.Value);
  }
  for (LeftOut& entry : SegmentsLeftOut(found, this->Requested.Segments, chosen))
  {
    this->NotChosen.push_back({ std::move(entry), {} });
  }
  for (const std::string& warning : warnings)
  {
    volume::AppendNote(this->Note, warning);
  }
  this->Map.Values.push_back(0); // the background
}

//------------------------------------------------------------------------------
SlabSource::Extent SegmentSlabs::GetExtent() const
{
  const std::int64_t layers = this->Map.Grid.Dimensions[2];
  std::int64_t changes = 0;
  for (const std::int64_t inLayer : this->Changes)
  {
    changes += inLayer;
  }
  return { layers, layers * static_cast<std::int64_t>(this->BytesInALayer),
    TrianglesPerChange * changes, this->ReadsWhole };
}

double SegmentSlabs::GetVoxelSize() const
{
  return this->Map.Grid.Spacing.minCoeff();
}

/// Surfaces are closed half a voxel outside of the outermost centers.
SlabAxis SegmentSlabs::GetAxis() const
{
  const Vector3 axis = this->Map.Grid.LayerNormal();
  return { axis, Dot(axis, this->Map.Grid.ToMillimeters({ 0.0, 0.0, -1.0 })) };
}

SlabInputs SegmentSlabs::GetInputs() const
{
  return { true, this->Map, this->NotChosen };
}

//------------------------------------------------------------------------------
std::size_t SegmentSlabs::Divide(std::int64_t triangles, std::int64_t largestBytes)
{
  std::vector<std::int64_t> inLayers = this->Changes;
  std::transform(inLayers.begin(), inLayers.end(), inLayers.begin(),
    [](std::int64_t changes) { return TrianglesPerChange * changes; });
  this->LastLayers = volume::DivideLayers(inLayers, triangles,
    std::max<std::int64_t>(1, largestBytes / static_cast<std::int64_t>(this->BytesInALayer) - 1));
  this->NextSlab = 0;
  this->NextLayer = 0;
  this->Reader = std::make_unique<SlabReader>(this->Open());
  return this->LastLayers.size();
}

//------------------------------------------------------------------------------
SlabSource::ReadSlab SegmentSlabs::ReadNext()
{
  const auto last = static_cast<Index>(this->LastLayers[this->NextSlab++]);
  ReadSlab read;
  const auto& [columns, rows, layers] = this->Map.Grid.Dimensions;
  read.Problem = volume::ProblemOfSecondReading(
    this->Reader->GetHeader(), { columns, rows, layers }, this->BytesInALayer);
  if (!read.Problem.empty())
  {
    return read;
  }
  const Volume slab = this->Reader->ReadTo(last);
  if (slab.Image)
  {
    volume::MakeWholeLabels(slab.Image);
  }
  ImageLabels labels = slab.Problem.empty() ? LabelsOfSlab(slab) : ImageLabels();
  read.Problem = slab.Problem.empty() ? labels.Problem : slab.Problem;
  if (!read.Problem.empty())
  {
    return read;
  }
  labels.Image.Grid = this->Map.Grid;
  LabelSurfaceOptions options;
  options.Labels = this->Map.Values;
  options.Threads = this->Requested.Options.NumberOfThreads;
  options.Slab = LayerRange{ this->NextLayer, last };
  LabelSurfaces surfaces = ExtractLabelSurfaces(labels.Image, options);
  read.Problem = LabelSurfaceMessage(surfaces.Status);
  this->NextLayer = last;
  RoundToSingle(surfaces.Surface.Points);
  const double end = this->IsLast(last) ? last + 1.0 : last;
  read.Slab.Top = Dot(this->GetAxis().Direction, this->Map.Grid.ToMillimeters({ 0.0, 0.0, end }));
  read.Slab.Surface = std::move(surfaces.Surface);
  read.Slab.BoundaryLabels = std::move(surfaces.Source.OfTriangle);
  return read;
}

//------------------------------------------------------------------------------
void SegmentSlabs::AddArrays(const Result& result, vtkPolyData* surface) const
{
  AddLabelMapArrays({ this->Map.Grid, this->Map.Values, result.BoundaryLabels, {} },
    this->Requested.Options.NumberOfThreads, surface);
  PassLabelMapArrays(this->Map, result.BoundaryLabels, surface);
  OrderLabelFields(this->Fields, this->Map, surface->GetFieldData());
}
}
