// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DecimateInternals.h
 * @brief How vtkBoneDecimate makes its runs, and what it offers to vtkPBoneDecimate, which
 * decimates a surface in parts. Not installed.
 */
#ifndef DecimateInternals_h
#define DecimateInternals_h

#include "vtkBoneDecimate.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace bonedecimate
{
class RegionCache;
struct LabelMapRequest;
struct Result;

/// How parts become one surface.
struct MeetingOfParts
{
  /// mm, where parts have common points: the same list in ascending order, each once, for all
  /// parts.
  std::vector<std::array<double, 3>> Shared;
  std::array<double, 3> Origin = {}; ///< mm, the same for all parts.
  /// Receives numbers of this part and returns those of all parts in their order. Called once.
  std::function<std::vector<std::vector<double>>(const std::vector<double>&)> Exchange;
  int Own = 0; ///< The number of this part in that order.
};
}

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDecimate::Internals
{
public:
  explicit Internals(vtkBoneDecimate* filter);
  ~Internals();
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  /// Whether the index has a name or an array.
  bool HasInputArray(int index);

  /// The array of the index, of points or cells (vtkDataObject::FieldAssociations); null if the
  /// input has none.
  vtkDataArray* GetInputArray(int index, vtkPolyData* input, int& association);

  /// For each cell its label, from the array of labels. Null if it does not suit; the reason has
  /// been reported.
  vtkSmartPointer<vtkDataArray> GetCellLabels(vtkPolyData* input);

  /// The point array of the tolerances; null if the input has none.
  vtkDataArray* GetPointTolerances(vtkPolyData* input);

  ///@{
  /**
   * What the options mean together.
   */
  /// mm, the smaller one of MaximumError and the error of ErrorPreset, of those that are set; 0:
  /// none.
  /// @param voxelSize mm, unless VoxelSize is set.
  double LargestErrorOf(double voxelSize) const;

  /// Whether TargetReduction ends the run.  @param isLimited Whether an error or tolerances end it.
  bool EndsAtReduction(bool isLimited) const;

  /// Whether small components are to go.
  bool Prunes() const;
  ///@}

  /// Every property of the other one.
  void CopyOptions(const vtkBoneDecimate& from);

  /// The report of the last run of another filter becomes that of this one.
  void TakeReport(const vtkBoneDecimate& from);

  ///@{
  /**
   * For classes that simplify a surface in parts, with a run of its own for each.
   */
  /// Whether the size of the whole surface suits the largest error; if not, the reason has been
  /// reported.
  bool AcceptSize(double diagonal, double largestError);

  using Numbers = std::vector<double>;

  /// Finds components of the whole surface that are too small (PruneSize and so on).
  /// @param pruned Receives for each cell of the part whether its component goes.
  /// @return False if nothing would be left; the reason has been reported.
  bool FindPrunedCells(
    vtkPolyData* part, const bonedecimate::MeetingOfParts& meeting, std::vector<bool>& pruned);

  /// Adds the number of components and the area of the whole surface to the entries of its report.
  /// @param side "input" or "output"
  void AddComponents(const std::string& side, vtkPolyData* part,
    const bonedecimate::MeetingOfParts& meeting, std::map<std::string, double>& entries) const;

  /// Where the smoothing of the whole surface, which the options describe, puts its points: mm,
  /// three numbers of each.
  /// @return Empty if the input was rejected; the reason has been reported.
  std::vector<double> SmoothPoints(vtkPolyData* whole);

  /// The input is from now on a part of a surface whose size has been accepted. Its options must
  /// not smooth.
  /// @param isShared For each point, whether other parts have it, too. It and the corners of its
  /// triangles are not edited.
  /// @param smoothedPoints Positions of the points of the part, as SmoothPoints() returns them;
  /// empty: nothing was smoothed.
  void SetPart(const std::vector<char>& isShared, const std::vector<double>& smoothedPoints);

  /// After SetPart(): what other parts have near this one. Triangles within the distance of it are
  /// not edited, and new ones are farther away.  @param distance mm, above 0.
  void SetNeighborsOfPart(vtkPolyData* neighbors, double distance);

  using EdgesOfPart = std::vector<std::array<vtkIdType, 2>>; // pairs of points

  /// After SetPart(): the part is itself a result, and MaximumError refers to its original, by
  /// which the result is proved. It has the label array that the options name, if they do, and all
  /// triangles of which a part that may change is the proof.
  /// @param cuts,originalCuts Edges at which the part and its original were cut out of the whole.
  void SetOriginalOfPart(
    vtkPolyData* original, const EdgesOfPart& cuts, const EdgesOfPart& originalCuts);

  /// For each cell, whether a run leaves it out because its triangles have no area.
  std::vector<bool> CellsWithoutArea(vtkPolyData* surface) const;

  /// For each cell, whether one of its triangles may be within the distance of the triangles of the
  /// other surface.
  /// @param distance mm, above 0.
  std::vector<bool> CellsNear(vtkPolyData* surface, vtkPolyData* others, double distance) const;

  /// Whether edits of a surface with this label map may not change voxels.
  /// @param largestError mm; 0: none.
  bool GuardsVoxels(vtkPolyData* input, double largestError);

  /// Compares the voxels of the result with those of the whole surface, for SetReportOfParts().
  void CompareVoxels(vtkPolyData* whole, vtkPolyData* result, bool wereGuarded);

  /// What SmoothPoints() and CompareVoxels() found, to be sent to another process of this program.
  std::vector<char> FiguresOfSegmentation() const;
  void TakeFiguresOfSegmentation(const std::vector<char>& bytes);

  /// Adds the edits of a run of this part, and what it left out, to the figures of the part.
  void AddRun(const vtkBoneDecimate& run);

  /// The figures of the part, with a checksum of its output, for SetReportOfParts().
  Numbers FiguresOfPart(vtkPolyData* output) const;

  /// The report of the whole surface: entries that are numbers, by name, among them the figures of
  /// the getters, and what FindPrunedCells(), SmoothPoints() and CompareVoxels() found.
  /// @param stopReason,proofStatus StopReasons and ProofStatuses of the whole run.
  /// @param ofParts FiguresOfPart() of each part.
  void SetReportOfParts(const std::map<std::string, double>& entries, int stopReason,
    int proofStatus, const std::vector<Numbers>& ofParts, vtkPolyData* output);
  ///@}

  /// A run of a surface. @return As RequestData().
  int Run(vtkPolyData* input, vtkPolyData* reference, const bonedecimate::LabelMapRequest& map,
    vtkInformationVector* outputs);

  std::shared_ptr<bonedecimate::RegionCache> Prepared; ///< Null: nothing is to be kept.

private:
  struct RunInput;
  struct PartOfSurface;

  bool Accept(const std::string& problem);
  bool ReadInput(vtkPolyData* input, vtkPolyData* reference,
    const bonedecimate::LabelMapRequest& map, RunInput& read);
  void ProveContinuedPart(const RunInput& read, bonedecimate::Result& result);
  void RejectArray(vtkPolyData* input, int index);

  vtkBoneDecimate* Filter;
  std::unique_ptr<PartOfSurface> Part; // null: the input is the whole surface
};

#endif
