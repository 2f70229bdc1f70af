// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneDecimate
 * @brief   make a bone surface smaller, keep every fragment, report the error in millimeters
 *
 * Takes a surface as marching cubes leaves it (triangles, strips or polygons, points shared or not)
 * and returns one with fewer triangles, by edge collapses in an order that depends on the mode
 * (SetMode()). Coordinates are millimeters. No component of the input is removed or merged with
 * another, open boundaries move only along themselves, edges and vertices that are not manifold
 * stay as they are.
 *
 * Input port 0: the surface. Input port 1, optional: the reference, the surface that the input was
 * made from. With it MaximumError is proved and measured against the reference, also over several
 * runs one after the other. Input port 2, optional: the label map, from which the surface was
 * extracted (SetLabelMapData()).
 *
 * Output port 0: the smaller surface. Point data: the distance to the input surface, the error
 * recorded along the collapses (both mm) and how many input points each point represents. Field
 * data: the report as one JSON text, BoneDecimateReport, and its main figures as arrays of their
 * own: bonedecimate.stop_reason, .input.triangles, .output.triangles, .output.components,
 * .distance.output_to_input.{max, mean}, .distance.input_to_output.{max, mean}, .proof.sentence and
 * .proof.if_unchanged.{status, upper}, as far as the report has them. A proof belongs to one
 * surface: that whose triangles have the report's output.checksum. Vertices and lines pass through.
 * Output port 1: the input, with the distance of each of its points to the result when
 * MeasureInputDistances is on.
 *
 * Tolerances and labels are arrays of the input, chosen by their names (ToleranceArrayName,
 * LabelArrayName) or by SetInputArrayToProcess(): index 0 is the point array of the tolerances,
 * index 1 the cell or point array of the labels. A name that is not empty takes precedence over the
 * array of that index.
 *
 * A value outside its range (NaN and infinity always are) is an error event when it is set: the
 * property keeps its value, and updates fail with the same sentence until it gets a valid one.
 *
 * An input that cannot be used (NaN, an index out of range) is an error with an empty output and
 * the reason in the message; an empty one gives an empty output and no error.
 *
 * @sa vtkBoneTolerance vtkBoneSurfaceDistance vtkQuadricDecimation vtkDecimatePro
 * H. Brandao, Mesh Simplification and Smoothing for Bone Fragment Models, BSc thesis, Groningen
 * 2018.
 */
#ifndef vtkBoneDecimate_h
#define vtkBoneDecimate_h

#include "vtkBoneOutputOptions.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro
#include "vtkSmartPointer.h"              // for labels

#include <array>      // for edges
#include <functional> // for exchange
#include <map>        // for entries
#include <memory>     // for std::unique_ptr
#include <string>     // for names
#include <vector>     // for points

class vtkDataArray;

namespace bonedecimate
{
class RegionCache;
struct Result;
}

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDecimate : public vtkBoneOutputOptions
{
public:
  static vtkBoneDecimate* New();
  vtkTypeMacro(vtkBoneDecimate, vtkBoneOutputOptions);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Indices of SetInputArrayToProcess().
  enum InputArrays
  {
    TOLERANCE_ARRAY = 0,
    LABEL_ARRAY = 1
  };

  /**
   * The original surface, if the input is itself a result. MaximumError, which must be set, is then
   * proved against it. Tolerances of points remain against the input. An input that is farther from
   * it than MaximumError is an error. Default none.
   */
  void SetReferenceData(vtkPolyData* reference);

  /// Sets the original surface as a connection, to the input port 1. Default none.
  void SetReferenceConnection(vtkAlgorithmOutput* reference);

  ///@{
  /**
   * Whether the filter keeps what it prepared of its input and the results of regions, so that the
   * next update with other tolerances runs only the regions that are new. Only updates that run
   * regions keep anything (Documentation/how-to/tolerance.md). No result depends on it. Off
   * releases the memory. Default on.
   */
  void SetKeepPrepared(bool keep);
  bool GetKeepPrepared() const;
  void KeepPreparedOn() { this->SetKeepPrepared(true); }
  void KeepPreparedOff() { this->SetKeepPrepared(false); }
  ///@}

  /// Releases what is kept, until the next update.
  void ReleasePrepared();

  /// Approximate memory of what is kept, bytes.
  vtkTypeInt64 GetPreparedMemory() const;

protected:
  vtkBoneDecimate();
  ~vtkBoneDecimate() override;

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

  /// Resets TargetReduction to its default, which other targets override: for classes that set
  /// every property.
  void ForgetTargetReduction();

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
  /// @param shared mm, where parts have common points: the same list in ascending order, each once,
  ///   for all parts.
  /// @param origin mm, the same for all parts.
  /// @param exchange Called once. Receives numbers of this part and returns those of all parts in
  ///   their order.
  /// @param own The number of this part in that order.
  /// @param pruned Receives for each cell of the part whether its component goes.
  /// @return False if nothing would be left; the reason has been reported.
  bool FindPrunedCells(vtkPolyData* part, const std::vector<std::array<double, 3>>& shared,
    const std::array<double, 3>& origin,
    const std::function<std::vector<Numbers>(const Numbers&)>& exchange, int own,
    std::vector<bool>& pruned);

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
  /// @param ofParts FiguresOfPart() of each part.
  void SetReportOfParts(const std::map<std::string, double>& entries,
    const std::vector<Numbers>& ofParts, vtkPolyData* output);
  ///@}

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneDecimate(const vtkBoneDecimate&) = delete;
  void operator=(const vtkBoneDecimate&) = delete;

  struct RunInput;
  struct PartOfSurface;

  bool Accept(const std::string& problem);
  bool ReadInput(vtkPolyData* input, vtkPolyData* reference,
    const bonedecimate::LabelMapRequest& map, RunInput& read);
  void ProveContinuedPart(const RunInput& read, bonedecimate::Result& result);
  void RejectArray(int index);
  bool GoesOn(double fraction);

  std::unique_ptr<PartOfSurface> Part;                 // null: the input is the whole surface
  std::shared_ptr<bonedecimate::RegionCache> Prepared; // null: nothing is to be kept
};

#endif
