// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoneSlabs.h
 * @brief The bone surface of a CT volume in slabs, for volumes larger than memory.
 *
 * The volume is read twice: first to check its values and to count the points of the surface, then
 * slab by slab.
 */
#ifndef BoneDecimate_Applications_BoneSlabs_h
#define BoneDecimate_Applications_BoneSlabs_h

#include "BoneVolume.h"
#include "FieldOfView.h"
#include "SlabReader.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bonedecimate
{
/// The triangles between two layers of voxels.
struct BoneSlab
{
  vtkSmartPointer<vtkPolyData> Surface; ///< As a BoneSurface; null if there is a problem.
  double Top = 0.0;                     ///< mm, of its upper layer along the axis of the slabs.
  std::string Problem;
};

class BoneSlabs
{
public:
  /// Reads all voxels. Parameters and rejections are those of ExtractBoneSurface().
  BoneSlabs(const std::string& path, double hounsfield, LabelPolicy policy = LabelPolicy::Reject,
    const VoxelSpacing& spacing = {});

  const std::string& GetProblem() const { return this->Problem; }
  const std::string& GetNote() const { return this->Note; }
  const std::string& GetRemark() const { return this->Remark; }
  /// BoneSurface::Padding
  std::int64_t GetPadding() const { return this->View.Count(); }
  double GetVoxelSize() const; ///< mm, the least side.
  std::int64_t GetNumberOfLayers() const { return this->Size[2]; }
  std::int64_t GetBytesOfVoxels() const; ///< In memory.
  /// Whether the format gives no single layers, so that a process holds all voxels.
  bool IsReadWhole() const { return this->ReadsWhole; }

  /// Approximate number of triangles of the surface.
  std::int64_t GetNumberOfTriangles() const;

  /// Perpendicular to the layers, of length 1; slabs follow each other along it.
  volume::Vector3 GetAxis() const;
  double GetBottom() const
  {
    return this->PositionOf(0);
  } ///< mm along the axis, of the first layer.

  /**
   * Opens the volume again, to be read in slabs of about as many triangles, or of two layers, or to
   * the end of the volume.
   * @param largestBytes Largest size of the voxels of a slab.
   * @return The number of slabs.
   */
  std::size_t Divide(std::int64_t triangles, std::int64_t largestBytes);

  /// After Divide(), for each slab in turn. @throws std::bad_alloc
  BoneSlab ReadNext();

private:
  void Survey(volume::SlabReader& reader, LabelPolicy policy);
  double PositionOf(std::int64_t layer) const;

  std::string Path;
  double Value;
  VoxelSpacing Spacing;
  std::string Problem;
  std::string Note;
  std::string Remark;
  std::array<std::int64_t, 3> Size{ { 0, 0, 0 } };
  std::size_t BytesInALayer = 0;
  bool ReadsWhole = false;
  volume::VolumeGeometry Geometry;
  volume::LayerPositions Layers;
  volume::FieldOfView View;
  std::vector<std::int64_t> Points; ///< CountContourPoints().
  std::unique_ptr<volume::SlabReader> Reader;
  std::vector<std::int64_t> LastLayers; ///< Last layer of each slab.
  std::size_t NextSlab = 0;
};
}

#endif
