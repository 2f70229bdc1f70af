// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionCache.h
 * @brief What runs over regions of the same surface keep: the prepared surface and the results of
 * regions.
 *
 *     surface    compared with the input of each run, bit for bit; another one replaces everything
 *     results    found again by triangles, tolerances and options; the ones used last, with at most
 *                as many triangles as the surface
 *
 * Results do not depend on it. A run that begins while another one uses it keeps nothing.
 */
#ifndef BoneDecimate_Core_Partition_Regions_RegionCache_h
#define BoneDecimate_Core_Partition_Regions_RegionCache_h

#include "Mesh/Cleaning.h"
#include "Mesh/SurfaceParts.h"
#include "RegionPart.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace bonedecimate
{
/// What a run over regions needs of the whole surface. Follows from the input and MergePoints
/// alone.
struct WholeSurface
{
  CleanSurface Cleaned; ///< Also the counts of points that are not manifold.
  SurfaceStatistics Statistics;
  SurfaceParts Components; ///< Components of the triangles.
  std::vector<PartExtent> Extents;
  std::uint64_t Checksum = 0; ///< Checksum of the input.
  bool IsSingle = false; ///< Whether all coordinates of the input are single precision numbers.
};

/// @return Good only if the status of the cleaned surface is.
WholeSurface PrepareWhole(const Surface& input, bool mergePoints, int threads);

class RegionCache
{
public:
  /// Before and after a run, by which alone the functions below may be called. False if another run
  /// uses it.
  bool BeginRun();
  void EndRun();

  /// Prepares the surface, unless it was the last one. Results for other labels (null: none) are
  /// dropped.
  const WholeSurface& Whole(
    const Surface& input, const Labels* labels, bool mergePoints, int threads);

  /// The result for this region of the last surface; null: none is kept.
  /// @param options The options of the region's run.
  std::shared_ptr<const RegionPart> Find(
    const Region& region, const Options& options, bool inputIsSingle);
  void Keep(
    const std::shared_ptr<const RegionPart>& part, const Options& options, bool inputIsSingle);

  /// Frees everything; if a run uses it, when this run ends. From any thread.
  void Release();
  /// Approximate memory that was kept by the last run. From any thread.
  std::size_t Bytes() const;

private:
  struct Entry
  {
    std::shared_ptr<const RegionPart> Part;
    Options RunOptions;
    bool InputIsSingle;
  };
  struct Contents
  {
    Surface Input;
    bonedecimate::Labels Labels;
    bool MergesPoints = true;
    std::unique_ptr<WholeSurface> Prepared; // null: none
    std::vector<Entry> Entries;             // the one used last is the last
  };
  std::size_t MeasureBytes() const;

  Contents Kept;
  mutable std::mutex State; // of what follows
  bool IsInUse = false;
  bool IsToBeReleased = false;
  std::size_t KeptBytes = 0;
};
}

#endif
