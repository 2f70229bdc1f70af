// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlabRun.h
 * @brief Decimates a surface that arrives in slabs between parallel planes and is never in memory
 * as a whole.
 *
 *     slab      all triangles between two planes; points in a plane are
 *               those of both slabs, bit for bit
 *     Add       decimates the slab while its points in the upper plane stay, together with a
 *               zone below it, where the result is decimated further, within the same largest
 *               error of the original triangles
 *     Finish    the whole surface, its figures and the proof
 *
 * The largest error holds between the whole original and the whole result.
 * Documentation/explanation/partition.md says why.
 */
#ifndef BoneDecimate_Core_Partition_Slabs_SlabRun_h
#define BoneDecimate_Core_Partition_Slabs_SlabRun_h

#include "Base/Monitor.h"
#include "Options/Options.h"
#include "Run/Output/Result.h"

#include <cstdint>
#include <memory>
#include <string>

namespace bonedecimate
{
/// The direction in which slabs follow each other.
struct SlabAxis
{
  Vector3 Direction = Vector3::UnitZ(); ///< Unit vector from each slab to the next.
  /// mm along the direction: below all points. Positions are the scalar product of a point and the
  /// direction.
  double Bottom = 0.0;
};

struct Slab
{
  /// mm; points in the planes have the same coordinates in both slabs.
  bonedecimate::Surface Surface;
  double Top = 0.0; ///< mm along the axis, of its upper plane; above that of the slab before.
  /// Labels of its triangles, as in LabelMapSource::OfTriangle; empty in all slabs: there is one
  /// label.
  std::vector<bonedecimate::BoundaryLabels> BoundaryLabels;
};

/// What a run in slabs knows of the surface, beside its options.
struct SlabInputs
{
  bool InputIsSingle = false; ///< As in RunInputs.
  /// The grid and the labels of the label map, if there is one; triangles and points are those of
  /// the slabs. With a grid its voxels are guarded (KeepVoxels).
  LabelMapSource LabelMap;
  std::vector<LeftOutShape> LeftOut; ///< What the source of the slabs left out.
};

enum class SlabStatus : int
{
  Good = 0,
  BadOptions, ///< See SlabRun::Message.
  BadSlab,    ///< Its input was rejected, or a triangle is not between its planes.
  Aborted     ///< By the monitor.
};

/// What slabs amount to.
struct SlabFigures
{
  std::int64_t Slabs = 0;         ///< With triangles.
  std::int64_t MaxSlab = 0;       ///< Input triangles.
  std::int64_t UnprovedSlabs = 0; ///< That stayed as they were, because no proof was found.
  /// Components of the whole surface, connected by common points.
  std::int64_t ComponentsBefore = 0;
  double VolumeBefore = 0.0; ///< mm^3, signed, as in SurfaceStatistics.
};

/**
 * The result is the same for any number of threads, but not for other slabs.
 * @throws std::bad_alloc and nothing else.
 */
class SlabRun
{
public:
  /// @param options MaximumError must be set, in a mode that proves errors; smoothing, pruning,
  /// numbers of triangles and ErrorPreset without VoxelSize are rejected.
  SlabRun(const Options& options, const SlabAxis& axis, const SlabInputs& inputs = {});
  ~SlabRun();
  SlabRun(const SlabRun&) = delete;
  SlabRun& operator=(const SlabRun&) = delete;

  SlabStatus Status() const;
  /// A sentence that explains a status that is not good.
  std::string Message() const;

  /// The next slab; one without triangles is fine. Nothing happens after a status that is not good.
  /// @param monitor Receives the progress of this slab.
  SlabStatus Add(Slab slab, const Monitor& monitor = {});

  /// The whole surface with its report; empty unless the status is good. No slab may follow.
  Result Finish();
  const SlabFigures& Figures() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Run;
};
}

#endif
