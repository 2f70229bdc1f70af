// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerParts.h"

#include "NamedLabels.h"
#include "NumberText.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MostComponents = 40;
constexpr const char* RegionName = "RegionId";

/// The surface with the number of the component of each point.
vtkSmartPointer<vtkPolyData> WithRegions(vtkPolyData* triangles)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(triangles->GetPoints());
  bare->SetPolys(triangles->GetPolys());
  vtkNew<vtkPolyDataConnectivityFilter> connectivity;
  connectivity->SetInputData(bare);
  connectivity->SetExtractionModeToAllRegions();
  connectivity->ColorRegionsOn();
  connectivity->Update();
  return connectivity->GetOutput();
}

/// The component of each point of WithRegions().
std::vector<std::size_t> RegionsOf(vtkPolyData* regions)
{
  vtkDataArray* const numbers = regions->GetPointData()->GetArray(RegionName);
  std::vector<std::size_t> ofPoints;
  ofPoints.reserve(static_cast<std::size_t>(regions->GetNumberOfPoints()));
  for (vtkIdType point = 0; point < regions->GetNumberOfPoints(); ++point)
  {
    ofPoints.push_back(static_cast<std::size_t>(numbers->GetComponent(point, 0)));
  }
  return ofPoints;
}

/// The first corner of each triangle.
std::vector<vtkIdType> FirstCorners(vtkPolyData* triangles)
{
  std::vector<vtkIdType> corners;
  const auto cells = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    corners.push_back(ids[0]);
  }
  return corners;
}

/// The component of each triangle of WithRegions(), which keeps their order.
std::vector<std::size_t> RegionsOfTriangles(
  vtkPolyData* regions, const std::vector<std::size_t>& ofPoints)
{
  std::vector<std::size_t> ofTriangles;
  for (const vtkIdType corner : FirstCorners(regions))
  {
    ofTriangles.push_back(ofPoints[static_cast<std::size_t>(corner)]);
  }
  return ofTriangles;
}

std::vector<vtkIdType> Counts(const std::vector<std::size_t>& regions)
{
  std::vector<vtkIdType> counts;
  for (const std::size_t region : regions)
  {
    counts.resize(std::max(counts.size(), region + 1));
    ++counts[region];
  }
  return counts;
}

std::vector<ViewerPiece> Values(std::map<std::vector<std::size_t>, ViewerPiece>&& pieces)
{
  std::vector<ViewerPiece> values;
  for (auto& [parts, piece] : pieces)
  {
    piece.Parts = parts;
    values.push_back(std::move(piece));
  }
  return values;
}
}

ViewerDivision::ViewerDivision(vtkPolyData* original, const std::vector<NamedLabel>& labels)
{
  if (!labels.empty() && original->GetCellData()->GetArray(LabelsOfSidesName))
  {
    this->AddLabels(labels);
  }
  else
  {
    this->AddComponents(original);
  }
}

void ViewerDivision::AddLabels(const std::vector<NamedLabel>& labels)
{
  for (const NamedLabel& label : labels.size() > 1 ? WithColors(labels) : labels)
  {
    this->PartOfLabel[label.Value] = this->Parts.size();
    this->Parts.push_back({ "label " + LabelText(label), label.Color });
  }
}

void ViewerDivision::AddComponents(vtkPolyData* original)
{
  const auto regions = WithRegions(original);
  const std::vector<std::size_t> regionOfPoint = RegionsOf(regions);
  const std::vector<vtkIdType> counts = Counts(RegionsOfTriangles(regions, regionOfPoint));
  std::vector<std::size_t> order(counts.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&counts](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
  const std::size_t listed = order.size() > MostComponents ? MostComponents - 1 : order.size();
  std::vector<std::size_t> partOfRegion(order.size(), listed);
  for (std::size_t i = 0; i < listed; ++i)
  {
    partOfRegion[order[i]] = i;
    this->Parts.push_back({ std::to_string(i + 1) + ": " +
        GroupedText(static_cast<double>(counts[order[i]])) + " triangles",
      {} });
  }
  if (listed < order.size())
  {
    this->Parts.push_back({ std::to_string(order.size() - listed) + " smaller components", {} });
  }
  for (const std::size_t region : regionOfPoint)
  {
    this->PartOfPoint.push_back(partOfRegion[region]);
  }
  this->NearestPoint = vtkSmartPointer<vtkStaticPointLocator>::New();
  this->NearestPoint->SetDataSet(regions); // numbers points in another order than the original
  this->NearestPoint->BuildLocator();
}

std::vector<ViewerPiece> ViewerDivision::Divide(vtkPolyData* triangles) const
{
  return this->PartOfLabel.empty() ? this->DivideByComponent(triangles)
                                   : this->DivideByLabel(triangles);
}

std::vector<ViewerPiece> ViewerDivision::DivideByLabel(vtkPolyData* triangles) const
{
  vtkDataArray* const labels = triangles->GetCellData()->GetArray(LabelsOfSidesName);
  std::map<std::vector<std::size_t>, ViewerPiece> pieces;
  for (vtkIdType cell = 0; labels && cell < labels->GetNumberOfTuples(); ++cell)
  {
    std::vector<std::size_t> parts;
    for (int side = 0; side < labels->GetNumberOfComponents(); ++side)
    {
      const auto part =
        this->PartOfLabel.find(static_cast<std::int64_t>(labels->GetComponent(cell, side)));
      if (part != this->PartOfLabel.end())
      {
        parts.push_back(part->second);
      }
    }
    pieces[parts].Triangles.push_back(cell);
  }
  return Values(std::move(pieces));
}

std::vector<std::size_t> ViewerDivision::PartsOfRegions(
  vtkPolyData* regions, const std::vector<std::size_t>& regionOfPoint) const
{
  std::vector<std::map<std::size_t, vtkIdType>> votes;
  for (vtkIdType point = 0; point < regions->GetNumberOfPoints(); ++point)
  {
    const std::size_t region = regionOfPoint[static_cast<std::size_t>(point)];
    votes.resize(std::max(votes.size(), region + 1));
    const vtkIdType nearest = this->NearestPoint->FindClosestPoint(regions->GetPoint(point));
    ++votes[region][this->PartOfPoint[static_cast<std::size_t>(nearest)]];
  }
  std::vector<std::size_t> parts;
  for (const auto& ofRegion : votes)
  {
    const auto most = std::max_element(ofRegion.begin(), ofRegion.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    parts.push_back(most == ofRegion.end() ? 0 : most->first);
  }
  return parts;
}

std::vector<ViewerPiece> ViewerDivision::DivideByComponent(vtkPolyData* triangles) const
{
  const auto regions = WithRegions(triangles);
  const std::vector<std::size_t> regionOfPoint = RegionsOf(regions);
  const std::vector<std::size_t> parts = this->PartsOfRegions(regions, regionOfPoint);
  std::map<std::vector<std::size_t>, ViewerPiece> pieces;
  vtkIdType cell = 0;
  for (const std::size_t region : RegionsOfTriangles(regions, regionOfPoint))
  {
    pieces[{ parts[region] }].Triangles.push_back(cell++);
  }
  return Values(std::move(pieces));
}
}
