// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartComparison.h"

#include "Mesh/ManifoldPatches.h"
#include "Proof/Measure/Thickness.h"
#include "Run/Input/LabelMapInput.h"
#include "Run/Input/Labels.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bonedecimate
{
namespace
{
/// One line for 16 triangles, within these limits: thickness is a median and a percentile.
constexpr std::int64_t TrianglesOfLine = 16;
constexpr std::int64_t FewestLines = 32;
constexpr std::int64_t MaxLines = 500;

/// The background is no part.
SurfaceParts PartsOfPairs(const CleanSurface& clean, const LabelMapSource& map)
{
  SurfaceParts parts;
  parts.Count = map.Background();
  for (const BoundaryLabels& pair : BoundaryLabelsOf(clean, map))
  {
    parts.OfTriangle.push_back({ pair[0], pair[1] < parts.Count ? pair[1] : None });
  }
  return parts;
}

SurfaceParts PartsOfLabels(const CleanSurface& clean, const Labels& labels)
{
  SurfaceParts parts;
  parts.Count = static_cast<Index>(labels.Names.size());
  for (const Index label : LabelsOf(clean, labels))
  {
    parts.OfTriangle.push_back({ label, None });
  }
  return parts;
}

/// The triangles of a part, normals out of it.
std::vector<std::vector<Triangle>> TrianglesOf(
  const Surface& surface, const SurfaceParts& parts, const std::vector<Index>& wanted)
{
  std::vector<Index> positions(static_cast<std::size_t>(parts.Count), None);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    positions[wanted[i]] = static_cast<Index>(i);
  }
  std::vector<std::vector<Triangle>> triangles(wanted.size());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& c = surface.Triangles[t];
    const auto& [front, back] = parts.OfTriangle[t];
    if (front != None && positions[front] != None)
    {
      triangles[positions[front]].push_back(c);
    }
    if (back != None && positions[back] != None)
    {
      triangles[positions[back]].push_back({ c[0], c[2], c[1] });
    }
  }
  return triangles;
}
}

PartComparer::PartComparer(const CleanSurface& clean, const RunInputs& inputs)
  : Clean(clean)
{
  const LabelMapSource* map = inputs.LabelMap;
  this->EncloseLabels = map != nullptr && !map->OfTriangle.empty();
  if (this->EncloseLabels)
  {
    this->Before = PartsOfPairs(clean, *map);
    std::transform(map->Values.begin(), map->Values.end() - 1, std::back_inserter(this->Labels),
      [](std::int64_t value) { return std::to_string(value); });
  }
  else if (inputs.Labels != nullptr)
  {
    this->Before = PartsOfLabels(clean, *inputs.Labels);
    this->Labels = inputs.Labels->Names;
  }
  else
  {
    this->Before = WithJoined(clean, ComponentsAsParts);
  }
  this->Kind =
    this->Labels.empty() ? PartComparison::Kind::Components : PartComparison::Kind::Labels;
}

//------------------------------------------------------------------------------
PartComparison PartComparer::Compare(
  const HalfEdgeMesh& mesh, const Surface& result, double smallestVolume)
{
  this->After.Count = this->Before.Count;
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      this->After.OfTriangle.push_back(this->Before.OfTriangle[face]);
    }
  }
  PartComparison compared;
  compared.Of = this->Kind;
  compared.MinVolume = smallestVolume;
  this->Describe(WithJoined(this->Clean,
                   [&](const Surface& joined)
                   { return MeasureParts(joined.Points, joined.Triangles, this->Before); }),
    compared);
  const std::vector<PartExtent> after = MeasureParts(result.Points, result.Triangles, this->After);
  for (std::size_t i = 0; i < compared.Parts.size(); ++i)
  {
    PartFigures& part = compared.Parts[i];
    const PartExtent& extent = after[this->Order[i]];
    part.Output.Area = extent.Area;
    part.Output.Volume = std::isnan(part.Input.Volume) ? part.Input.Volume : extent.Volume;
  }
  return compared;
}

//------------------------------------------------------------------------------
void PartComparer::Describe(const std::vector<PartExtent>& extents, PartComparison& compared)
{
  this->Order.clear();
  for (std::size_t part = 0; part < extents.size(); ++part)
  {
    if (extents[part].Triangles > 0) // a label may be nowhere
    {
      this->Order.push_back(static_cast<Index>(part));
    }
  }
  std::stable_sort(this->Order.begin(), this->Order.end(),
    [&](Index a, Index b) { return extents[a].Area > extents[b].Area; });
  for (const Index part : this->Order)
  {
    const PartExtent& extent = extents[part];
    PartFigures& figures = compared.Parts.emplace_back();
    figures.Label = this->Labels.empty() ? std::string() : this->Labels[part];
    figures.Triangles = extent.Triangles;
    figures.Center = 0.5 * (extent.Low + extent.High) + this->Clean.Origin;
    figures.Input.Area = extent.Area;
    figures.Input.Volume = extent.IsClosed ? extent.Volume : figures.Input.Volume;
  }
}

//------------------------------------------------------------------------------
void PartComparer::MeasureThickness(const BoundingTree& before, const BoundingTree& after,
  const Surface& result, int threads, PartComparison& compared) const
{
  // Other parts may lie in a component, such as cavities; labels enclose what belongs to them.
  const SolidSurface ofInput = { this->Clean.Surface, before,
    this->EncloseLabels ? &this->Before.OfTriangle : nullptr };
  const SolidSurface ofResult = { result, after,
    this->EncloseLabels ? &this->After.OfTriangle : nullptr };
  const std::size_t count = std::min(this->Order.size(), PartComparison::MaxListed);
  const std::vector<Index> wanted(
    this->Order.begin(), this->Order.begin() + static_cast<std::ptrdiff_t>(count));
  const std::vector<std::vector<Triangle>> triangles = TrianglesOf(result, this->After, wanted);
  for (std::size_t i = 0; i < count; ++i)
  {
    PartFigures& part = compared.Parts[i];
    const std::int64_t lines = std::clamp(part.Triangles / TrianglesOfLine, FewestLines, MaxLines);
    const ThicknessChange found = CompareThickness(ofInput, ofResult, triangles[i],
      this->EncloseLabels ? wanted[i] : 0, static_cast<std::size_t>(lines), threads);
    part.Input.Thickness = found.Before;
    part.Output.Thickness = found.After;
  }
}
}
