// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Levels.h
 * @brief Levels of detail: a run that is recorded once and of which every stage can be had again at once.
 *
 *     Record:   Decimate with a log, Open, marks at every root of two of the number of triangles, and how far those
 *               levels are from the input
 *     Open:     clean and sort the input as the run did, replay the log once into a LevelStack
 *     At:       one level
 *     AtOn:     one level on a surface with other coordinates and the same triangles
 *
 * Level n is what the first n collapses of the log made of the input. Documentation/levels.md says when a run that is asked
 * for fewer collapses ends there, too.
 */
#ifndef BoneDecimate_Core_Levels_h
#define BoneDecimate_Core_Levels_h

#include "Decimate.h"
#include "Levels/LevelStack.h"
#include "Levels/LogBytes.h"

namespace bonedecimate
{
class BoundingTree;

class Levels
{
public:
  /// @param input The very points and triangles that were recorded.
  LogStatus Open(const Surface& input, EditLog log, int threads);
  bool IsOpen() const { return this->Stack.has_value(); }

  Index NumberOfCollapses() const { return this->Stack->NumberOfCollapses(); }
  Index TrianglesAt(Index collapses) const { return this->Stack->TrianglesAt(collapses); }

  /// The first level of no more triangles than that; the last one if there is none.
  Index ByTriangles(Index triangles) const { return this->Stack->LevelOf(triangles); }
  /// The coarsest mark that is no farther from the input than that, mm; level 0 if there is none.
  Index ByError(double error) const;

  Level At(Index collapses) const
  {
    return this->Stack->At(collapses, this->Threads, this->Points, this->Sites);
  }
  /// Nothing if its triangles are not those of the input, or its points not usable (Surface.h). The same triangles as
  /// At().
  std::optional<Level> AtOn(const Surface& other, Index collapses) const;

  /// Sets the marks, and measures them. False if the monitor said stop: then they are not measured.
  bool Mark(bool measure, const Monitor& monitor);

  const EditLog& Log() const { return this->Edits; }

private:
  void MeasureMark(const BoundingTree& input, LevelMark& mark) const;
  std::vector<Vector3> PointsOf(const Surface& input) const;

  EditLog Edits;
  std::optional<LevelStack> Stack;
  std::vector<Vector3> Points;     // mm, of the cleaned input's vertices
  std::vector<Triangle> Triangles; // of the cleaned input
  std::vector<Index> InputPoint;   // of each vertex
  std::vector<Index> Sites;        // of each vertex, see Sheets.h; empty: there is one sheet
  std::size_t InputPoints = 0;     // how many
  std::uint64_t Connectivity = 0;  // checksum of the input's triangles
  int Threads = 0;
};

/**
 * A run with its levels; both are empty if the input was refused. They are of all components: nothing is pruned.
 * @param levels Gets marks; with MeasureDistances they are measured.
 * @return The run, as Decimate() returns it.
 */
Result RecordLevels(const Surface& input, const Options& options, const Monitor& monitor,
  bool inputIsSingle, Levels& levels);
}

#endif
