// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Levels.h
 * @brief Levels of detail: a run is recorded once, and each of its intermediate surfaces can be
 * extracted quickly.
 *
 *     Record:   Decimate with a log, Open, mark levels whose numbers of triangles differ by a
 *               factor of sqrt(2), measure
 *               their distance to the input
 *     Open:     clean and sort the input as the run did, replay the log once into a LevelStack
 *     At:       extract one level
 *     AtOn:     extract one level on a surface with the same triangles and other coordinates
 *
 * Level n is the input after the first n collapses of the log. Documentation/how-to/levels.md says
 * when a run that stops after n collapses has the same result.
 */
#ifndef BoneDecimate_Core_Run_Levels_h
#define BoneDecimate_Core_Run_Levels_h

#include "Decimate.h"
#include "Levels/LevelStack.h"
#include "Levels/LogBytes.h"

#include <cstdint>

namespace bonedecimate
{
class BoundingTree;

/// The levels of a recorded run.
class Levels
{
public:
  /// @param input The same points and triangles as recorded.
  /// @param inputs The label map and the labels with which the run was recorded; its other members
  ///   are not used.
  LogStatus Open(const Surface& input, EditLog log, int threads, const RunInputs& inputs = {});
  /// Whether Open() succeeded; all other functions need that.
  bool IsOpen() const { return this->Stack.has_value(); }

  /// Number of the coarsest level.
  Index NumberOfCollapses() const { return this->Stack->NumberOfCollapses(); }
  /// Number of triangles of a level.
  Index TrianglesAt(Index collapses) const { return this->Stack->TrianglesAt(collapses); }

  /// The first level with at most that many triangles; the last level if there is none.
  Index ByTriangles(Index triangles) const { return this->Stack->LevelOf(triangles); }
  /// The coarsest mark whose distance to the input does not exceed that, mm; level 0 if there is
  /// none.
  Index ByError(double error) const;

  /// The surface of a level.
  Level At(Index collapses) const
  {
    return this->Stack->At(collapses, this->Threads, this->Points, this->OriginalVertices);
  }
  /// Labels on both sides of the triangles of At(); empty if the label map has none.
  std::vector<BoundaryLabels> BoundaryLabelsAt(Index collapses) const;
  /// For each triangle of At() the input triangle of which it is what is left, and whose label it
  /// has.
  std::vector<Index> InputTrianglesAt(Index collapses) const;
  /// The triangles of At() with points of another surface. Empty if its triangles are not those of
  /// the input, or its points are not usable (Surface.h).
  std::optional<Level> AtOn(const Surface& other, Index collapses) const;

  /// Sets the marks and measures their distances. False after an abort: the distances are missing
  /// then.
  bool Mark(bool measure, const Monitor& monitor);

  /// Compares the voxels of each mark with those of the input, if the grid is known. False after an
  /// abort.
  bool CompareVoxels(const Surface& input, const Monitor& monitor);
  /// How many voxels have another label at each mark than in the input; empty if they were not
  /// compared.
  const std::vector<std::int64_t>& ChangedVoxels() const { return this->Changed; }

  /// The log from which the levels are made.
  const EditLog& Log() const { return this->Edits; }

private:
  void MeasureMark(const BoundingTree& input, LevelMark& mark) const;
  std::vector<Vector3> PointsOf(const Surface& input) const;

  EditLog Edits;
  std::optional<LevelStack> Stack;
  std::vector<Vector3> Points;      // mm, of the cleaned input's vertices
  std::vector<Triangle> Triangles;  // of the cleaned input
  std::vector<Index> InputPoint;    // of each vertex
  std::vector<Index> InputTriangle; // of each triangle of the cleaned input
  // for each vertex, see ManifoldPatches.h; empty: nothing was split
  std::vector<Index> OriginalVertices;
  LabelMapSource Map; // with the pairs of labels of the cleaned input's triangles
  std::vector<BoundaryLabels> InputPairs; // of the input's triangles
  std::vector<std::int64_t> Changed;
  std::size_t InputPoints = 0;    // their number
  std::uint64_t Connectivity = 0; // checksum of the input's triangles
  int Threads = 0;
};

/**
 * Runs Decimate() and records its levels; both are empty if the input is rejected. Nothing is
 * pruned, and nothing rounded to a grid.
 * @param inputs Curves between labels, and between pairs of labels of a label map, do not change,
 * because a log has no edits of them. Without a part. The distances of marks are those to the
 * input, also with a reference.
 * @param levels Receives the levels and marks; with MeasureDistances the distances of the marks are
 * measured, with a voxel grid their voxels are compared.
 * @return The result of Decimate().
 */
Result RecordLevels(const Surface& input, const Options& options, const Monitor& monitor,
  const RunInputs& inputs, Levels& levels);
}

#endif
