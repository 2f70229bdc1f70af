// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabSource.h"

#include "Layers/BoneSlabs.h"
#include "Segments/SegmentSlabs.h"
#include "SurfaceConversion.h"

namespace bonedecimate
{
namespace
{
class BoneSource : public SlabSource
{
public:
  explicit BoneSource(const Arguments& arguments)
    : Bone(arguments.Inputs[0], *arguments.Iso,
        arguments.TakesLabels ? LabelPolicy::AsIntensities : LabelPolicy::Reject,
        arguments.LabelMap.GetSpacing())
    , Threads(arguments.Options.NumberOfThreads)
  {
  }

  std::string GetProblem() const override { return this->Bone.GetProblem(); }
  std::string GetNote() const override { return this->Bone.GetNote(); }
  std::string GetRemark() const override { return this->Bone.GetRemark(); }
  Extent GetExtent() const override
  {
    return { this->Bone.GetNumberOfLayers(), this->Bone.GetBytesOfVoxels(),
      this->Bone.GetNumberOfTriangles(), this->Bone.IsReadWhole() };
  }
  double GetVoxelSize() const override { return this->Bone.GetVoxelSize(); }
  SlabAxis GetAxis() const override
  {
    const auto axis = this->Bone.GetAxis();
    return { { axis[0], axis[1], axis[2] }, this->Bone.GetBottom() };
  }
  SlabInputs GetInputs() const override
  {
    SlabInputs inputs;
    inputs.InputIsSingle = true; // as flying edges makes them
    if (const std::int64_t padding = this->Bone.GetPadding(); padding > 0)
    {
      inputs.LeftOut.push_back({ PaddingLeftOut(padding), {} });
    }
    return inputs;
  }
  std::size_t Divide(std::int64_t triangles, std::int64_t largestBytes) override
  {
    return this->Bone.Divide(triangles, largestBytes);
  }
  ReadSlab ReadNext() override
  {
    const BoneSlab voxels = this->Bone.ReadNext();
    ReadSlab read;
    read.Problem = voxels.Problem;
    read.Slab.Top = voxels.Top;
    if (voxels.Surface)
    {
      read.Slab.Surface = ToSurface(voxels.Surface, this->Threads).Surface;
    }
    return read;
  }
  void AddArrays(const Result&, vtkPolyData*) const override {}

private:
  BoneSlabs Bone;
  int Threads;
};
}

LeftOut PaddingLeftOut(std::int64_t voxels)
{
  LeftOut entry;
  entry.Kind = "padding";
  entry.Count = voxels;
  entry.What = voxels == 1 ? "voxel that was not measured" : "voxels that were not measured";
  return entry;
}

//------------------------------------------------------------------------------
std::unique_ptr<SlabSource> MakeSlabSource(const Arguments& arguments)
{
  if (arguments.Segments.IsRequested())
  {
    return std::make_unique<SegmentSlabs>(arguments);
  }
  return std::make_unique<BoneSource>(arguments);
}
}
