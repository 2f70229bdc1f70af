// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Report.h
 * @brief Report of a run: input, edits, stop reason, result and its distances.
 */
#ifndef BoneDecimate_Core_Report_Report_h
#define BoneDecimate_Core_Report_Report_h

#include "Diagnostics/Diagnostics.h"
#include "LabelMap/VoxelCheck.h"
#include "LeftOut.h"
#include "Mesh/Rejection.h"
#include "Options/Options.h"
#include "PartFigures.h"
#include "ShapeFigures.h"
#include "Surface.h"
#include "TunnelFigures.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
enum class ProofStatus : int; // of Certificate/Certificate.h
enum class BoundaryPresence : int;

/// Whether the input is valid, or why it was rejected.
enum class InputStatus : int
{
  Good = 0,
  Empty,                 ///< No points and no triangles: the result is empty, too.
  NoTriangles,           ///< Points, but no triangle of positive area.
  NonFinitePoints,       ///< NaN or infinite coordinates.
  HugeCoordinates,       ///< Beyond 1e30: products of areas would overflow.
  IndexOutOfRange,       ///< A triangle has a point index out of range.
  TooManyTriangles,      ///< More than 2^31 / 4 triangles.
  BadTolerances,         ///< NaN or infinite, or not one for each point.
  BadEdgeLengths,        ///< Not above 0, NaN or infinite, or not one for each point.
  TolerancesInThesis,    ///< Thesis mode proves nothing: it allows only 0 and no limit.
  ReferenceWithoutError, ///< A reference needs a largest error.
  BadReference,          ///< It has no triangle, or would be rejected as an input.
  FarFromReference,      ///< The input is farther from it than the largest error.
  EverythingPruned,      ///< No component reaches the requested size.
  /// Rounding moves points farther than the error or tolerances allow, or onto other points.
  SinglePrecisionTooCoarse,
  /// The largest error is more than a quarter of the diagonal, and AllowLargeError is off.
  ErrorBeyondSize,
  /// The largest error is less than a millionth of the diagonal: rounding alone exceeds it.
  ErrorBelowSize,
  /// The grid is not valid, labels are not one pair per triangle, or the surface is far from it.
  BadLabelMap,
  NoVoxelGrid, ///< KeepVoxels is On and no grid is known.
  /// An option that does not go with another one or with an input; Report::Conflict.
  OptionConflict,
  InvalidOption ///< A value is outside of the range of its option.
};

/// Why the collapse ended.
enum class StopReason : int
{
  NotRun = 0,
  TargetReached,    ///< The requested number of triangles, or the reduction.
  ErrorReached,     ///< The requested largest error.
  AlreadySatisfied, ///< The input already had no more triangles than requested.
  NothingLeft,      ///< No further collapse is allowed.
  Aborted,          ///< By the monitor.
  /// The number of triangles is out of reach: most collapses that are left would close a handle.
  Handles
};

struct SurfaceStatistics
{
  std::int64_t Faces = 0;
  std::int64_t Points = 0;           ///< Points used by a triangle.
  std::int64_t Components = 0;       ///< Connected by common points.
  std::int64_t BoundaryEdges = 0;    ///< Edges of exactly one triangle.
  std::int64_t NonManifoldEdges = 0; ///< Edges of three or more triangles.
  std::int64_t EulerNumber = 0;      ///< Points - edges + faces.
  double Area = 0.0;                 ///< mm^2
  double Volume = 0.0; ///< mm^3, signed, by the divergence theorem; meaningful for closed surfaces.
  ShapeStatistics Shape;
};

/// Counts of cleaning. "First" are input ids, -1 if there is none.
struct CleaningStatistics
{
  std::int64_t TrianglesRead = 0;
  std::int64_t PointsRead = 0;
  std::int64_t NonFinitePoints = 0;
  std::int64_t FirstNonFinitePoint = -1;
  std::int64_t HugePoints = 0; ///< With a coordinate beyond 1e30.
  std::int64_t FirstHugePoint = -1;
  std::int64_t TrianglesOutOfRange = 0;
  std::int64_t FirstTriangleOutOfRange = -1;
  std::int64_t MergedPoints = 0;
  std::int64_t UnusedPoints = 0;
  std::int64_t DroppedTriangles = 0; ///< Without area.
  std::int64_t FirstDroppedTriangle = -1;
  std::int64_t NonManifoldPoints = 0; ///< On non-manifold edges or pinched.
  std::int64_t FirstNonManifoldPoint = -1;
  std::int64_t BadTolerances = 0; ///< NaN or beyond 1e30 mm.
  std::int64_t FirstBadTolerance = -1;
  std::int64_t BadEdgeLengths = 0; ///< Not above 0, NaN or beyond 1e30 mm.
  std::int64_t FirstBadEdgeLength = -1;
  /// After merging: points that rounding to single precision moves farther than allowed.
  std::int64_t CoarsePoints = 0;
  std::int64_t MeetingPoints =
    0; ///< Points of the result at the same position as another one in single precision.
  std::int64_t FirstCoarsePoint = -1;
  double LargestRounding = 0.0;       ///< mm, of those points.
  std::int64_t ConstrainedPoints = 0; ///< Points, after merging, whose tolerance is 0.
};

/// Distances of one surface to another, mm.
struct DistanceStatistics
{
  double Maximum =
    0.0;               ///< Over all points and all area samples: a lower bound of the true maximum.
  double Second = 0.0; ///< Second largest over the points alone, as in the tables of the thesis.
  double Mean = 0.0;   ///< Over the area samples.
  double RootMeanSquare = 0.0; ///< Over the area samples.
  double PointMaximum = 0.0;   ///< Over the points alone.
  double PointMean = 0.0;
  double PointRootMeanSquare = 0.0;
  std::int64_t Samples = 0;
  double SamplesPerSquareMillimeter = 0.0;
};

/// Proved bounds of the largest distance from one surface or boundary to the other, mm.
struct ProvedDistance
{
  double Lower = 0.0;
  double Upper = 0.0;
};

/// The certificate of the result as it is written.
struct ErrorProof
{
  bool WasMade = false;   ///< If false, all other members are meaningless.
  ProofStatus Status{};   ///< For everything that was compared.
  double Tolerance = 0.0; ///< mm, the error to prove for all points; 0: none.
  ProvedDistance InputToOutput;
  ProvedDistance OutputToInput;
  /// Boundaries after merging points of equal coordinates; not compared without MergePoints.
  bool BoundariesCompared = false;
  BoundaryPresence
    Boundaries{}; ///< If only one surface has boundaries, their distance is infinite.
  ProvedDistance BoundaryInputToOutput;
  ProvedDistance BoundaryOutputToInput;

  double Lower() const; ///< mm, the largest over both directions, boundaries included.
  double Upper() const;
};

/// The reference to which the largest error refers, if it is not the input.
struct ReferenceFigures
{
  bool IsPresent = false; ///< If false, all other members are meaningless.
  std::int64_t Faces = 0;
  std::uint64_t Checksum = 0; ///< Computed like that of the input.
  ProvedDistance ToInput;     ///< mm, between reference and input, the larger direction.
};

/// What welding changed before the first edit (WeldRun.h).
struct WeldFigures
{
  bool HasRun = false;     ///< If false, all other members are meaningless.
  std::int64_t Points = 0; ///< How many moved.
  double Movement = 0.0;   ///< mm, how far one moved at most; part of what is proved.
};

/// A component that was removed by pruning.
struct PrunedComponent
{
  std::int64_t Triangles = 0;
  double Size = 0.0;                ///< mm, the longest side of its box along the axes.
  double Area = 0.0;                ///< mm^2
  double Volume = 0.0;              ///< mm^3, NaN if it is not closed.
  Vector3 Center = Vector3::Zero(); ///< mm, the middle of the box.
};

struct PruneFigures
{
  bool IsRequested = false; ///< If false, all other members are meaningless.
  bool TookAll = false;     ///< The input was rejected.
  std::int64_t Triangles = 0;
  std::vector<PrunedComponent> Components; ///< Sorted, largest first.
};

/// The size of the input, and the largest error compared with it.
struct SizeFigures
{
  double Diagonal = 0.0;     ///< mm, of the bounding box of the input's triangles, after pruning.
  double LargestError = 0.0; ///< mm, of MaximumError, the preset or the tolerances; 0: none.
  std::int64_t Point = -1;   ///< The input point whose tolerance is LargestError; -1: none.
  double ErrorBound = 0.0;   ///< mm, the error used by the run: at most Diagonal.
};

/// The smoothing before the first edit.
struct SmoothingFigures
{
  /// What is known of the segmentation that the surface comes from.
  enum class Source : int
  {
    NotRequested = 0,
    LabelMap, ///< A label map, named with the surface.
    Binary,   ///< Its points are the middles of grid edges: the surface of a binary segmentation.
    /// Its points lie on the edges of a grid, interpolated: left alone by the automatic smoothing.
    GrayLevel,
    Unknown ///< No grid was found.
  };
  Source From = Source::NotRequested; ///< If NotRequested, all other members are meaningless.
  double Bound = 0.0;           ///< mm, the largest displacement allowed; 0: nothing was smoothed.
  bool IsInVoxels = false;      ///< Thick slices: smoothed in voxel units, within octahedra.
  double Strength = 0.0;        ///< lambda of Smoothing/BoundedSolver.h
  double RmsDisplacement = 0.0; ///< mm
  double LargestDisplacement = 0.0; ///< mm
  double AngleBefore = 0.0;         ///< Degrees, mean angle between the normals of neighbors.
  double AngleAfter = 0.0;
  double AreaBefore = 0.0; ///< mm^2
  double AreaAfter = 0.0;
  double VolumeBefore = 0.0; ///< mm^3, of all closed components.
  double VolumeAfter = 0.0;
  std::int64_t SharpPoints = 0; ///< On edges that were kept because of FeatureAngle.
  std::int64_t LimitedPoints =
    0; ///< Whose bound was lowered, because triangles would intersect or turn over.
  std::int64_t Rounds = 0; ///< Rounds of lowering bounds.

  bool HasRun() const { return this->Bound > 0.0; }
};

/// The voxels of a run with an ErrorPreset.
struct VoxelFigures
{
  enum class Source : int
  {
    NotRequested = 0,
    Input,
    Grid, ///< Estimated from the planes of marching cubes.
    Edges ///< Estimated from the lengths of edges.
  };
  Source From = Source::NotRequested;
  double Size = 0.0;         ///< mm, the least side.
  double Error = 0.0;        ///< mm, uncertainty of an estimate.
  double LargestError = 0.0; ///< mm, of the preset, or a smaller MaximumError.
};

/// Least distance between two fragments, mm.
struct FragmentGap
{
  double Input = 0.0;
  double Output = 0.0;
};

/// The area of the triangles of one label, mm^2.
struct LabelArea
{
  std::string Name;
  double Input = 0.0;
  double Output = 0.0;
  /// Relative to the input area; 0 if that is 0.
  double Change() const { return Input > 0.0 ? std::abs(Output - Input) / Input : 0.0; }
};

/// The voxels of the label map: those of the result compared with those of the input.
struct VoxelReport
{
  bool WereGuarded = false; ///< Whether edits that change one were rejected.
  bool WasChecked = false;  ///< If false, what follows is meaningless.
  VoxelChanges Changes;
  std::vector<std::int64_t> Values; ///< Labels by index; the background is the last.
};

/// What came of drafting the first collapses of a proved run.
enum class DraftStatus : int
{
  NoBound = 0, ///< Edits are not limited by an error.
  NotUsed,     ///< No collapse was needed.
  Used, ///< Collapses were drafted and proved together; those that could not be proved were undone.
  Undone,           ///< All drafted collapses were undone, and the run went on edit by edit.
  EditsAreRecorded, ///< Not possible, because every level of detail has to be proved.
  MoreFilters       ///< Not possible with filters of the caller.
};

struct DraftFigures
{
  DraftStatus Status = DraftStatus::NoBound;
  std::int64_t Collapses = 0; ///< That were drafted.
  std::int64_t Undone = 0;    ///< Drafted collapses that were undone.
};

/// Whether a run read only the regions that may change, and their surroundings.
enum class RegionStatus : int
{
  NotRequested = 0, ///< No point has a tolerance of 0.
  Used,
  OtherOptions, ///< Not possible with another option or input: the whole surface was read.
  TooLarge,     ///< Regions and surroundings are more than half of the surface.
  /// The result of a region could not be joined to the rest or proved; the whole surface was run.
  NotProved
};

struct RegionFigures
{
  RegionStatus Status = RegionStatus::NotRequested;
  std::int64_t Count = 0;     ///< Regions.
  std::int64_t Triangles = 0; ///< In the regions and their surroundings.
  std::int64_t Kept = 0;      ///< Regions whose results were kept from earlier runs.
};

/// Collapses that keep the error only together with moves around them (Stages/ForcedCollapse.h).
struct ForcedCollapseFigures
{
  std::int64_t Tried = 0; ///< On a copy of their neighborhood.
  std::int64_t Made = 0;  ///< Proved and applied.
};

struct StageSeconds
{
  double Prepare = 0.0;  ///< Cleaning and building the half-edge mesh.
  double Collapse = 0.0; ///< Costs, the loop, extraction; the original's bounding tree, if needed.
  double Decimate = 0.0; ///< Prepare + Collapse: the time until the surface is complete.
  double Measure = 0.0;  ///< Statistics of both surfaces and distances.
  double Prove = 0.0;    ///< The certificate of the result.
  double Total = 0.0;
};

struct Report
{
  InputStatus Status = InputStatus::Good;
  StopReason Stop = StopReason::NotRun;
  SurfaceStatistics Input; ///< After cleaning.
  SurfaceStatistics Output;
  CleaningStatistics Cleaning;
  std::vector<Diagnostic> Diagnostics; ///< Irregularities of the whole input, if requested.
  PruneFigures Pruned;
  TunnelFigures Tunnels; ///< If any were closed, everything else refers to the closed surface.
  bool DistancesMeasured = false;
  DistanceStatistics OutputToInput;
  DistanceStatistics InputToOutput;
  bool BoundariesMeasured =
    false; ///< If distances were measured and both surfaces have boundaries.
  ProvedDistance BoundaryOutputToInput;
  ProvedDistance BoundaryInputToOutput;
  bool FragmentGapMeasured = false; ///< If distances were measured and there are several fragments.
  FragmentGap Gap;
  std::vector<LabelArea> Labels; ///< Empty without labels.
  ErrorProof Proof;              ///< Relative to the reference, if there is one.
  ReferenceFigures Reference;
  WeldFigures Weld;
  std::string Conflict; ///< A sentence, with InputStatus::OptionConflict.
  /// What of the input, or of the reference, the proof does not cover.
  std::vector<bonedecimate::LeftOut> LeftOut;
  VoxelFigures Voxel;
  VoxelReport Voxels; ///< For an input with a voxel grid.
  SizeFigures Size;
  SmoothingFigures Smoothing;
  PartComparison Parts; ///< Input and result of a surface that was smoothed as a whole.
  /// mm, maxError of the thesis: the largest distance of a new vertex to the input, after each
  /// collapse in mode Thesis and at the end in other modes. NaN if not measured (other modes
  /// without MeasureDistances and origins); tables omit it then.
  double RunningError = 0.0;
  double NormalTolerance = 0.0; ///< The tolerance w of the thesis; only in mode Thesis.
  std::int64_t Collapses = 0;
  std::array<std::int64_t, NumberOfRejections>
    Rejections{}; ///< By Rejection; [NotRejected] is always 0.
  DraftFigures Draft;
  RegionFigures Regions;
  AngleFigures Angles;
  EdgeFigures Edges;
  ForcedCollapseFigures Forced; ///< Only in modes that make them, with an error bound.
  StageSeconds Seconds;
  std::uint64_t InputChecksum = 0;  ///< Mesh/Checksum.h.
  std::uint64_t OutputChecksum = 0; ///< Independent of the order of triangles; Mesh/Checksum.h.
  Options Requested;
  bool HasTolerances = false; ///< Whether there were tolerances of points.
};

/// One word, as in the JSON report: "target_reached".
const char* StopReasonWord(StopReason reason);
/// A sentence that explains the reason.
const char* StopReasonSentence(StopReason reason);
const char* DraftStatusWord(DraftStatus status);
const char* RegionStatusWord(RegionStatus status);
/// Why the input was rejected, with counts and first ids; empty if it is good.
std::string InputMessage(const Report& report);
/// Warnings about a good input, one sentence each, with counts and first ids.
std::vector<std::string> InputWarnings(const Report& report);
/// A warning that the error is violated or undecided; empty if it is proved or there is no proof.
std::string ProofMessage(const Report& report);
/// Version of this software, "major.minor.patch".
const char* Version();
}

#endif
