// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneSlabs.h"

#include "IntensityChecks.h"
#include "LayerDivision.h"
#include "OutwardContour.h"
#include "Readers/DataFile.h"
#include "VolumeFile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bonedecimate
{
using namespace volume;

namespace
{
constexpr std::int64_t TrianglesPerPoint = 2; // of a closed surface of few handles
}

BoneSlabs::BoneSlabs(
  const std::string& path, double hounsfield, LabelPolicy policy, const VoxelSpacing& spacing)
  : Path(path)
  , Value(hounsfield)
  , Spacing(spacing)
  , View(hounsfield)
{
  SlabReader reader(OpenVolume(path, spacing));
  const VolumeHeader& header = reader.GetHeader();
  this->Size = header.Size;
  this->BytesInALayer = header.BytesInALayer();
  this->ReadsWhole = header.IsReadWhole;
  this->Geometry = header.Geometry;
  this->Layers = header.Layers;
  this->Note = header.Note;
  this->Remark = header.Remark;
  this->Problem = header.Problem;
  if (this->Problem.empty())
  {
    this->Survey(reader, policy);
  }
}

void BoneSlabs::Survey(SlabReader& reader, LabelPolicy policy)
{
  ValueSurvey survey;
  this->Problem = VisitSlabs(reader,
    [&](const Volume& slab)
    {
      survey.Add(slab);
      this->View.Add(slab);
      AppendCounts(CountContourPoints(slab, this->Value), this->Points);
      return std::string();
    });
  if (!this->Problem.empty())
  {
    return;
  }
  this->Problem = FirstOf({ this->View.Problem(), IntensityProblem(survey, this->Value, policy) });
  AppendNote(this->Note, MaskNote(survey));
  AppendNote(this->Note, this->View.Note());
}

double BoneSlabs::GetVoxelSize() const
{
  return LeastSide(this->Geometry, this->Layers);
}

std::int64_t BoneSlabs::GetBytesOfVoxels() const
{
  return static_cast<std::int64_t>(this->BytesInALayer) * this->Size[2];
}

std::int64_t BoneSlabs::GetNumberOfTriangles() const
{
  return TrianglesPerPoint *
    std::accumulate(this->Points.begin(), this->Points.end(), std::int64_t(0));
}

Vector3 BoneSlabs::GetAxis() const
{
  const auto& steps = this->Geometry.Steps;
  const Vector3 normal = Cross(steps[0], steps[1]);
  const double length = Dot(normal, steps[2]) < 0.0 ? -Length(normal) : Length(normal);
  return { { normal[0] / length, normal[1] / length, normal[2] / length } };
}

double BoneSlabs::PositionOf(std::int64_t layer) const
{
  const Vector3 axis = this->GetAxis();
  return Dot(this->Geometry.Origin, axis) +
    (this->Layers.empty() ? static_cast<double>(layer)
                          : this->Layers[static_cast<std::size_t>(layer)]) *
    Dot(this->Geometry.Steps[2], axis);
}

std::size_t BoneSlabs::Divide(std::int64_t triangles, std::int64_t largestBytes)
{
  std::vector<std::int64_t> inLayers = this->Points;
  std::transform(inLayers.begin(), inLayers.end(), inLayers.begin(),
    [](std::int64_t points) { return TrianglesPerPoint * points; });
  this->LastLayers = DivideLayers(inLayers, triangles,
    std::max<std::int64_t>(1, largestBytes / static_cast<std::int64_t>(this->BytesInALayer) - 1));
  this->NextSlab = 0;
  this->Reader = std::make_unique<SlabReader>(OpenVolume(this->Path, this->Spacing));
  return this->LastLayers.size();
}

BoneSlab BoneSlabs::ReadNext()
{
  BoneSlab slab;
  const std::int64_t last = this->LastLayers[this->NextSlab++];
  slab.Top = this->PositionOf(last);
  slab.Problem = ProblemOfSecondReading(this->Reader->GetHeader(), this->Size, this->BytesInALayer);
  if (slab.Problem.empty())
  {
    const Volume voxels = this->Reader->ReadTo(last);
    slab.Problem = voxels.Problem;
    if (voxels.Image && this->View.HasPadding())
    {
      this->View.Clear(voxels);
    }
    slab.Surface = voxels.Image ? OutwardContour(voxels, this->Value) : nullptr;
  }
  return slab;
}
}
