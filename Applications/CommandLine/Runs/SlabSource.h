// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlabSource.h
 * @brief Where the slabs of a run come from: the bone at a gray value, or the segments of a label
 * map.
 *
 * The volume is read twice: when the source is made, to check and count, and then slab by slab.
 */
#ifndef BoneDecimate_Applications_SlabSource_h
#define BoneDecimate_Applications_SlabSource_h

#include "Arguments/Arguments.h"
#include "Partition/Slabs/SlabRun.h"

#include "vtkPolyData.h"

#include <cstdint>
#include <memory>
#include <string>

namespace bonedecimate
{
class SlabSource
{
public:
  struct Extent
  {
    std::int64_t Layers = 0;
    std::int64_t VoxelBytes = 0; ///< In memory.
    std::int64_t Triangles = 0;  ///< About how many the surface has.
    bool IsReadWhole = false;    ///< The format gives no single layers: a process holds all voxels.
  };
  struct ReadSlab
  {
    bonedecimate::Slab Slab;
    std::string Problem; ///< Why there is none; empty if there is one.
  };

  virtual ~SlabSource() = default;

  virtual std::string GetProblem() const = 0; ///< Why the volume was rejected; empty if it was not.
  virtual std::string GetNote() const = 0;    ///< A warning for the user; may be empty.
  virtual std::string GetRemark() const = 0;  ///< A note for the user; may be empty.
  virtual Extent GetExtent() const = 0;
  virtual double GetVoxelSize() const = 0; ///< mm, the least side.
  virtual SlabAxis GetAxis() const = 0;
  virtual SlabInputs GetInputs() const = 0;

  /**
   * Opens the volume again, to be read in slabs of about as many triangles, or of two layers, or to
   * the end of the volume.
   * @param largestBytes Largest size of the voxels of a slab.
   * @return The number of slabs.
   */
  virtual std::size_t Divide(std::int64_t triangles, std::int64_t largestBytes) = 0;

  /// After Divide(), for each slab in turn. @throws std::bad_alloc
  virtual ReadSlab ReadNext() = 0;

  /// What the surface has beside its geometry: labels with names and colors.
  virtual void AddArrays(const Result& result, vtkPolyData* surface) const = 0;
};

/// What the report says of voxels that the scanner did not measure.
LeftOut PaddingLeftOut(std::int64_t voxels);

/// Makes the source for the arguments, which have --iso or --segments. @throws Failure
std::unique_ptr<SlabSource> MakeSlabSource(const Arguments& arguments);
}

#endif
