// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentSlabs.h
 * @brief The surfaces of the segments of a label map in slabs: together those that vtkBoneSurfaces
 * extracts from the whole.
 */
#ifndef BoneDecimate_Applications_SegmentSlabs_h
#define BoneDecimate_Applications_SegmentSlabs_h

#include "IsolatedReader.h"
#include "Layers/SlabReader.h"
#include "Runs/SlabSource.h"

#include "vtkFieldData.h"
#include "vtkNew.h"

#include <cstdint>
#include <set>
#include <vector>

namespace bonedecimate
{
class SegmentSlabs : public SlabSource
{
public:
  /// Reads all voxels. @throws Failure if the segments that were chosen are not there.
  explicit SegmentSlabs(const Arguments& arguments);

  std::string GetProblem() const override { return this->Problem; }
  std::string GetNote() const override { return this->Note; }
  std::string GetRemark() const override { return this->Remark; }
  Extent GetExtent() const override;
  double GetVoxelSize() const override;
  SlabAxis GetAxis() const override;
  SlabInputs GetInputs() const override;
  std::size_t Divide(std::int64_t triangles, std::int64_t largestBytes) override;
  ReadSlab ReadNext() override;
  void AddArrays(const Result& result, vtkPolyData* surface) const override;

private:
  std::unique_ptr<volume::IsolatedReader> Open() const;
  std::set<std::int64_t> Survey(volume::SlabReader& reader);
  void Choose(const std::set<std::int64_t>& labels, vtkFieldData* fields);
  bool IsLast(Index layer) const { return layer + 1 == this->Map.Grid.Dimensions[2]; }

  const Arguments& Requested;
  std::string Problem;
  std::string Note;
  std::string Remark;
  std::vector<LeftOutShape> NotChosen; ///< Segments that were not chosen.
  LabelMapSource Map;                  ///< Its grid and its values; mm.
  vtkNew<vtkFieldData> Fields;
  std::size_t BytesInALayer = 0;
  bool ReadsWhole = false;
  std::vector<std::int64_t> Changes; ///< CountLabelChanges().
  std::unique_ptr<volume::SlabReader> Reader;
  std::vector<std::int64_t> LastLayers; ///< Last layer of each slab.
  std::size_t NextSlab = 0;
  Index NextLayer = 0;
};
}

#endif
