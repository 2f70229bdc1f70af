// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Modes.h
 * @brief The table of modes. A mode is a row: its policies, its stages, their settings and what
 * MaximumError means.
 *
 *     mode       cost                   placement          schedule      stages    MaximumError
 *     Thesis     NormalFieldDeviation   PlaneQuadric       VertexQueue   collapse  stops the run
 *     Fast       QuadricDeviation       VolumePreserving   BucketSweep   collapse  is proved
 *     Balanced   QuadricDeviation       VolumePreserving   BucketSweep   both      is proved
 *     Accurate   QuadricDeviation       VolumePreserving   BucketSweep   both      is proved
 *
 * The two stages are collapse and refine. NAME in the table refers to Cost/NAME.h, Placement/NAME.h
 * and Schedule/NAME.h. The schedule determines the signatures of the cost and placement functions.
 * Balanced and Accurate differ in the settings of their stages. The refine stage improves the mesh
 * by flips and moves, collapses to the target, and improves it again. Without an error bound these
 * collapses are ordered by Decimate/Cost/SampledErrorCost.h.
 *
 * A new cost or placement is a function in a file of its own, named in a row. A new mode is an
 * enumerator and a row of Modes.cxx. Option, commands, messages, wrappers, tests and the page of
 * the modes take the name, and what the mode does, from the row.
 */
#ifndef BoneDecimate_Core_Options_Modes_h
#define BoneDecimate_Core_Options_Modes_h

#include "Base/Monitor.h"

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace bonedecimate
{
enum class Freedom : std::int32_t;
enum class StopReason : int;
class FaceAreas;
class HalfEdgeMesh;
class VertexCost;
struct CollapseInput;
struct EdgeNeighborhood;
struct EdgeQuadric;
struct Float3;
struct PositionCandidates;
struct StageInput;

/// The values are those of vtkBoneDecimate::SetMode() and the indices of ModeTable().
enum class Mode : int
{
  Thesis = 0,   ///< Vertex-driven collapse by normal field deviation (Brandao 2018).
  Fast = 1,     ///< Collapse by quadrics of the current triangles, O(1) for an edge.
  Balanced = 2, ///< As Fast nearly to the end, then fitted to samples of the original.
  Accurate = 3  ///< As Balanced, with more collapses by sampled error and more sweeps.
};

/// Policies of VertexQueue, which collapses one edge at a time: at the vertex of lowest cost, its
/// edge of lowest cost.
struct QueuePolicies
{
  /// @param tolerance w of Decimate/Cost/NormalFieldDeviation.h.
  /// @param meanEdgeLength mm, before the first edit.
  std::unique_ptr<VertexCost> (*Cost)(
    const HalfEdgeMesh& mesh, const FaceAreas& areas, double tolerance, double meanEdgeLength);
  PositionCandidates (*Placement)(
    const HalfEdgeMesh& mesh, const FaceAreas& areas, const EdgeNeighborhood& around);
};

/// Policies of BucketSweep, which collapses edges by buckets of their cost, in blocks of the mesh
/// in parallel. Functions for which Decimate/Kernels/EdgeEvaluator.cxx knows no vector kernel are
/// called for one edge after the other.
struct SweepPolicies
{
  float (*Cost)(const CollapseInput& input);
  Float3 (*Placement)(const EdgeQuadric& quadric, Freedom freedom);
};

/// What MaximumError and the tolerances of points mean.
enum class ErrorPolicy
{
  /// The run ends when the recorded distance of a new vertex reaches MaximumError and the number of
  /// triangles, if there is one, is reached. Tolerances of 0 constrain points; positive ones are
  /// rejected.
  RunningStop,
  ProvedBound ///< Every edit is proved to keep both surfaces within the error and the tolerances.
};

/// Settings of Decimate/Schedule/BucketSweep.h.
struct SweepSettings
{
  /// Weight of Decimate/Cost/SpikePenalty.h: more gives a larger mean error and a smaller maximum.
  double SpikeWeight = 0.3;
  /// Positions tried for a merged vertex where edits are proved, at most MaximumPositions of
  /// Decimate/Placement/AlternatePositions.h: more of them give fewer triangles and take longer.
  int PositionsTried = 4;
  /// The same where voxels alone limit edits: such runs are short.
  int PositionsTriedForVoxels = 4;
};

/// Settings of Decimate/Stages/RefineStage.h. The defaults are those of a mode without that stage.
struct RefineSettings
{
  /// The sweep before stops early by this ratio of the target number of faces,
  double ExtraOfTarget = 0.0;
  double ExtraOfOriginal = 0.0; ///< but by no more than this ratio of the original number.
  int EdgesOfCollapse = 0;      ///< Edges evaluated for each of the last collapses.
  int SweepsBefore = 0;         ///< Sweeps of flips and moves before the last collapses.
  int SweepsAfter = 0;          ///< Sweeps after them,
  int SweepsIfFew = 0;          ///< or, where few triangles remain and sweeps cost little, so many.
  /// How often sweeps and collapses by slack alternate where edits are proved.
  int ProvedRounds = 0;
  int ProvedSweeps = 0;      ///< Sweeps by slack in each of these rounds.
  int ForcedRounds = 0;      ///< Most rounds of collapses that need moves around them, and a sweep.
  int ProvedSweepsAfter = 0; ///< Sweeps of flips and moves after them.
  /// Weight in Decimate/Cost/SampledErrorCost.h, where nothing but a number of triangles ends the
  /// run.
  double ShapeWeight = 0.0;
  int VoxelRounds = 0; ///< How often sweeps and collapses alternate where voxels alone limit edits.
};

using StageFunction = StopReason (*)(const StageInput& input, const Monitor& monitor);

/// A step of a run over the mesh editor, see Decimate/Stages/StageList.h.
struct Stage
{
  const char* Name;
  StageFunction Run;
  double End; ///< Fraction of the time of all stages at which this one ends.
};

/// What the page of the modes says of one, in Markdown.
struct ModeText
{
  const char* Use = "";
  const char* Order = "";      ///< Order of the collapses.
  const char* Position = "";   ///< Position of the new vertex.
  const char* Refinement = ""; ///< What moves and flips after the collapses.
};

struct ModeInfo
{
  bonedecimate::Mode Mode = bonedecimate::Mode::Balanced;
  const char* Name = "";
  std::variant<QueuePolicies, SweepPolicies> Schedule;
  ErrorPolicy ErrorMeaning = ErrorPolicy::ProvedBound;
  /// Whether the distance of every new vertex to the original is recorded along the collapses.
  bool RecordsDistances = false;
  /// Whether stages need the mesh as it was before the first edit.
  bool KeepsInitialMesh = false;
  SweepSettings Sweep;
  RefineSettings Refine;
  std::vector<Stage> Stages; ///< In order.
  ModeText Text;

  /// Whether a stage moves and flips after the collapses.
  bool Refines() const { return this->KeepsInitialMesh; }
  /// Whether the options MinimumAngle and EdgeLength have a meaning.
  bool LimitsShapes() const { return this->NeedsQuadrics(); }
  bool ProvesError() const { return this->ErrorMeaning == ErrorPolicy::ProvedBound; }
  /// Whether the option NormalTolerance, the w of the cost, has a meaning.
  bool HasNormalTolerance() const { return this->NeedsFaceAreas(); }
  /// Whether cost and placement read the area and the normal of each face.
  bool NeedsFaceAreas() const { return std::holds_alternative<QueuePolicies>(this->Schedule); }
  /// Whether cost and placement read the quadric of each vertex.
  bool NeedsQuadrics() const { return std::holds_alternative<SweepPolicies>(this->Schedule); }
};

/// Every mode once, in the order of the enumeration.
const std::vector<ModeInfo>& ModeTable();

/// The row of a mode; that of Balanced for a value that is no mode, which CheckOptions() rejects.
const ModeInfo& FindMode(Mode mode);

/// The names of all modes, in the order of the table.
std::vector<std::string> ModeNames();

/// "Fast, Balanced, Accurate": the names of the modes of which the predicate is true.
template <typename Predicate>
std::string ModeNamesWhere(const Predicate& predicate, const char* separator = ", ")
{
  std::string names;
  for (const ModeInfo& mode : ModeTable())
  {
    if (predicate(mode))
    {
      names += (names.empty() ? "" : separator) + std::string(mode.Name);
    }
  }
  return names;
}
}

#endif
