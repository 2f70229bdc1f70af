// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Report.h
 * @brief What happened in a run, why it stopped and what the result is worth.
 */
#ifndef BoneDecimate_Core_Report_h
#define BoneDecimate_Core_Report_h

#include "Doctor/Doctor.h"
#include "Options.h"
#include "Surface.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
enum class CertificateVerdict : int; // of Certificate/Certificate.h
enum class BorderPresence : int;

/// Whether the input could be used at all.
enum class InputStatus : int
{
  Good = 0,
  Empty,                 ///< No points and no triangles: the result is empty, too.
  NoTriangles,           ///< Points, but no triangle of positive area.
  NonFinitePoints,       ///< NaN or infinite coordinates.
  HugeCoordinates,       ///< Beyond 1e30: products of areas would overflow.
  IndexOutOfRange,       ///< A triangle names a point that is not there.
  TooManyTriangles,      ///< More than 2^31 / 4 triangles.
  BadTolerances,         ///< NaN or infinite, or not one for each point.
  TolerancesInThesis,    ///< Thesis mode proves nothing: only 0 and no limit.
  ReferenceWithoutError, ///< There is nothing to promise against it.
  BadReference,          ///< It has no triangle, or is refused as an input is.
  FarFromReference,      ///< The input is farther from it than the largest error.
  EverythingPruned,      ///< No component is large enough for what was asked for.
  SinglePrecisionTooCoarse, ///< Written in it, points move farther than the error or tolerances allow, or onto others.
  ErrorBeyondSize, ///< The largest error is more than a quarter of the diagonal, and AllowLargeError is off.
  ErrorBelowSize, ///< The largest error is less than a millionth of the diagonal: rounding alone exceeds it.
  InvalidOption ///< A value that is not in the range of its option.
};

/// Why the collapse ended.
enum class StopReason : int
{
  NotRun = 0,
  TargetReached,    ///< The number of triangles asked for, or the reduction.
  ErrorReached,     ///< The largest error asked for.
  AlreadySatisfied, ///< The input was small enough from the start.
  NothingLeft,      ///< No collapse is allowed any more.
  Aborted           ///< The monitor asked for it.
};

/// The gate's answer to an edit. Allowed is the only one that changes the mesh.
enum class Verdict : int
{
  Allowed = 0,
  NonManifold,   ///< An end is locked because the surface is not manifold there.
  Border,        ///< It would move an open border off itself, or pinch the surface.
  LinkCondition, ///< It would change the topology.
  Fragment,      ///< A fragment would fall below its least size, vanish or turn inside out.
  Flip,          ///< A triangle would turn over.
  Degenerate,    ///< A triangle would have no area left.
  TooFar,        ///< It could not be proved that everything stays within the largest error.
  Frozen,        ///< An end or corner stays as it is because its tolerance, or a neighbour's, is 0.
  Crossing, ///< Triangles would intersect, or a gap would become narrower than half of what it was.
  Elsewhere ///< Not refused: a worker of another part of the mesh has to do it.
};
constexpr std::size_t NumberOfVerdicts = 10; ///< Those that are counted.

struct SurfaceStatistics
{
  std::int64_t Faces = 0;
  std::int64_t Points = 0;           ///< Points used by a triangle.
  std::int64_t Components = 0;       ///< Connected by shared points.
  std::int64_t BoundaryEdges = 0;    ///< Edges of exactly one triangle.
  std::int64_t NonManifoldEdges = 0; ///< Edges of three or more triangles.
  std::int64_t EulerNumber = 0;      ///< Points - edges + faces.
  double Area = 0.0;                 ///< mm^2
  double Volume = 0.0; ///< mm^3, signed, by the divergence theorem; meaningful for closed surfaces.
};

/// What cleaning found and did. "First" are input ids, -1 where nothing was found.
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
  std::int64_t DroppedTriangles = 0; ///< Zero area.
  std::int64_t FirstDroppedTriangle = -1;
  std::int64_t LockedPoints = 0; ///< On non-manifold edges or pinched.
  std::int64_t FirstLockedPoint = -1;
  std::int64_t BadTolerances = 0; ///< NaN or beyond 1e30 mm.
  std::int64_t FirstBadTolerance = -1;
  /// Which single precision moves farther than they may move, after merging.
  std::int64_t CoarsePoints = 0;
  std::int64_t MeetingPoints =
    0; ///< Of the result, which single precision leaves on another's place.
  std::int64_t FirstCoarsePoint = -1;
  double LargestRounding = 0.0;  ///< mm, of those points.
  std::int64_t FrozenPoints = 0; ///< Points, after merging, whose tolerance leaves them no room.
};

/// Distances of one surface to another, mm.
struct DistanceStatistics
{
  double Maximum = 0.0; ///< Over all points and all area samples: a lower bound of the true one.
  double Second = 0.0;  ///< The largest but one over the points alone (the thesis's column).
  double Mean = 0.0;    ///< Over the area samples.
  double RootMeanSquare = 0.0; ///< Over the area samples.
  double PointMaximum = 0.0;   ///< Over the points alone.
  double PointMean = 0.0;
  double PointRootMeanSquare = 0.0;
  std::int64_t Samples = 0;
  double SamplesPerSquareMillimetre = 0.0;
};

/// Proved bounds of the largest distance from one surface to the other, or from its open borders to the other's, mm.
struct ProvedDistance
{
  double Lower = 0.0;
  double Upper = 0.0;
};

/// What the certificate says of the surface as it is written.
struct ErrorProof
{
  bool WasMade = false;         ///< Else nothing else counts.
  CertificateVerdict Verdict{}; ///< Of everything that was compared.
  double Tolerance = 0.0;       ///< mm, what was to be proved everywhere; 0: nothing.
  ProvedDistance InputToOutput;
  ProvedDistance OutputToInput;
  /// Borders are those where points of equal coordinates are one; without MergePoints they are not compared.
  bool BordersCompared = false;
  BorderPresence Borders{}; ///< If only one surface has some, they are infinitely far.
  ProvedDistance BorderInputToOutput;
  ProvedDistance BorderOutputToInput;
  std::int64_t TrianglesLeftOut = 0; ///< Of the input: those without area that cleaning dropped.

  double Lower() const; ///< mm, the largest of all directions, borders too.
  double Upper() const;
};

/// What the largest error was promised against, if not the input.
struct ReferenceFigures
{
  bool IsGiven = false; ///< Else nothing else counts.
  std::int64_t Faces = 0;
  std::uint64_t Checksum = 0; ///< As that of the input.
  ProvedDistance ToInput;     ///< mm, between reference and input, the larger direction.
};

/// A component that was left out on request.
struct PrunedComponent
{
  std::int64_t Triangles = 0;
  double Size = 0.0;               ///< mm, the longest side of its box along the axes.
  double Area = 0.0;               ///< mm^2
  double Volume = 0.0;             ///< mm^3, not a number if it is not closed.
  Vector3 Place = Vector3::Zero(); ///< mm, the middle of the box.
};

struct PruneFigures
{
  bool IsAsked = false; ///< Else nothing else counts.
  bool TookAll = false; ///< Then the input was refused.
  std::int64_t Triangles = 0;
  std::vector<PrunedComponent> Components; ///< The largest first.
};

/// The size of the input, and the largest error compared with it.
struct SizeFigures
{
  double Diagonal = 0.0;     ///< mm, of the bounding box of the input's triangles, after pruning.
  double LargestError = 0.0; ///< mm, of MaximumError, the preset or the tolerances; 0: none.
  std::int64_t Point = -1;   ///< The input point whose tolerance LargestError is; -1 if it is none.
  double ErrorBound = 0.0;   ///< mm, what the run used of it: at most Diagonal.
};

/// The voxels of a run with an ErrorPreset.
struct VoxelFigures
{
  enum class Source : int
  {
    NotAsked = 0,
    Given,
    Grid, ///< Estimated from the planes of marching cubes.
    Edges ///< Estimated from the lengths of edges.
  };
  Source From = Source::NotAsked;
  double Size = 0.0;         ///< mm, the least side.
  double Error = 0.0;        ///< mm, by which an estimate may be off.
  double LargestError = 0.0; ///< mm, what the preset makes of it, or a smaller MaximumError.
};

/// Least distance between two fragments, mm.
struct FragmentClearance
{
  double Input = 0.0;
  double Output = 0.0;
};

/// Of the triangles of one label, mm^2.
struct LabelArea
{
  std::string Name;
  double Input = 0.0;
  double Output = 0.0;
  /// A share of what it was; 0 where there was none.
  double Change() const { return Input > 0.0 ? std::abs(Output - Input) / Input : 0.0; }
};

struct StageSeconds
{
  double Prepare = 0.0;  ///< Cleaning and building the half-edge mesh.
  double Collapse = 0.0; ///< Costs, the loop, extraction; the original's bounding tree, if needed.
  double Decimate = 0.0; ///< Prepare + Collapse: everything needed for the surface.
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
  std::vector<Finding> Findings; ///< Of the doctor, if they were asked for: of the whole input.
  PruneFigures Pruned;
  bool DistancesMeasured = false;
  DistanceStatistics OutputToInput;
  DistanceStatistics InputToOutput;
  bool BordersMeasured = false; ///< With the distances, if both surfaces have open borders.
  ProvedDistance BorderOutputToInput;
  ProvedDistance BorderInputToOutput;
  bool ClearanceMeasured = false; ///< With the distances, if there are several fragments.
  FragmentClearance Clearance;
  std::vector<LabelArea> Labels; ///< Empty without labels.
  ErrorProof Proof;              ///< Against the reference, if there is one.
  ReferenceFigures Reference;
  VoxelFigures Voxel;
  SizeFigures Size;
  /// mm, the thesis's maxError: largest distance of a new vertex to the input, along the collapses in mode Thesis, at
  /// the end in the others. Not a number where none was looked up, which is so in these without MeasureDistances and
  /// origins; the tables then leave it out.
  double RunningError = 0.0;
  double NormalTolerance = 0.0; ///< The thesis's w of the run; only in mode Thesis.
  std::int64_t Collapses = 0;
  std::array<std::int64_t, NumberOfVerdicts> Refusals{}; ///< By Verdict; [Allowed] stays 0.
  StageSeconds Seconds;
  std::uint64_t InputChecksum = 0; ///< Mesh/Checksum.h.
  Options Asked;
  bool HasTolerances = false; ///< Whether points had tolerances of their own.
};

/// One word, as in the JSON report: "target_reached".
const char* StopReasonWord(StopReason reason);
/// A sentence for people.
const char* StopReasonSentence(StopReason reason);
const char* VerdictWord(Verdict verdict);
/// What is wrong with the input, with counts and the id of the first; empty if it is good.
std::string InputMessage(const Report& report);
/// What was found in a good input and dealt with, a sentence each, with counts and the id of the first.
std::vector<std::string> InputWarnings(const Report& report);
/// That the certificate contradicts the promise, or cannot decide; empty if it is proved or there is no proof.
std::string ProofMessage(const Report& report);
/// Version of this software, "major.minor.patch".
const char* Version();
}

#endif
