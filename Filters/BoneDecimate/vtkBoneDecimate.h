// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneDecimate
 * @brief   make a bone surface smaller, keep every fragment, report the error in millimetres
 *
 * Takes a surface as marching cubes leaves it (triangles, strips or polygons, points shared or not) and returns
 * one with fewer triangles, by an edge collapse ordered by normal field deviation. Coordinates are millimetres.
 * No component of the input is removed or merged with another, open borders move only along themselves, edges and
 * vertices that are not manifold stay as they are.
 *
 * Input port 0: the surface. Input port 1, optional: the reference, what the surface was made from by runs before. With it
 * MaximumError is promised, proved and measured against the reference, however often a result is fed in again.
 *
 * Output port 0: the smaller surface. Point data: the distance to the input surface, the error recorded along the
 * collapses (both mm) and how many input points each point stands for. Field data: the report, one array per
 * entry, its name "bonedecimate." and the entry's (GetReportEntryName()). Vertices and lines pass through.
 * Output port 1: the input, with the distance of each of its points to the result when MeasureInputDistances is on.
 *
 * A value outside its range (NaN and infinity always are) is an error event when it is set: the property keeps its value, and
 * updates fail with the same sentence until it gets a valid one.
 *
 * An input that cannot be used (NaN, an index out of range) is an error with an empty output and the reason in the
 * message; an empty one gives an empty output and no error.
 *
 * @sa vtkBoneTolerance vtkBoneSurfaceDistance vtkQuadricDecimation vtkDecimatePro
 * H. Brandao, Mesh Simplification and Smoothing for Bone Fragment Models, BSc thesis, Groningen 2018.
 */
#ifndef vtkBoneDecimate_h
#define vtkBoneDecimate_h

#include "vtkFiltersBoneDecimateModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for array names and report texts
#include <vector> // for warnings

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDecimate : public vtkPolyDataAlgorithm
{
public:
  static vtkBoneDecimate* New();
  vtkTypeMacro(vtkBoneDecimate, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override; // changes as long as there is a rejected value

  /// How the result is found.
  enum Modes
  {
    THESIS = 0,
    FAST = 1,
    BALANCED = 2,
    ACCURATE = 3
  };

  /// Why the last run ended.
  enum StopReasons
  {
    NOT_RUN = 0,
    TARGET_REACHED,
    ERROR_REACHED,
    ALREADY_SATISFIED,
    NOTHING_LEFT,
    ABORTED
  };

  ///@{
  /**
   * The method. BALANCED (the default) collapses like FAST, takes the last triangles by the distance to samples of
   * the original, then moves points and flips edges so that they come to lie nearer; ACCURATE does more of each. FAST
   * only collapses edges, ordered by what that does to the normals, and nearly keeps the volume. These three end at
   * the first stop reached. THESIS is the thesis to the letter: it goes on while there are more triangles than asked
   * for or, with MaximumError above 0, no new point is farther than that.
   */
  void SetMode(int mode);
  int GetMode() const;
  void SetModeToThesis() { this->SetMode(THESIS); }
  void SetModeToFast() { this->SetMode(FAST); }
  void SetModeToBalanced() { this->SetMode(BALANCED); }
  void SetModeToAccurate() { this->SetMode(ACCURATE); }
  ///@}

  ///@{
  /// Number of triangles to reach, 0 to 2147483647; 0, the default, is off.
  void SetTargetNumberOfTriangles(int triangles);
  int GetTargetNumberOfTriangles() const;
  ///@}

  ///@{
  /**
   * Fraction of the triangles to remove, 0 to 1; 1 is off. The default, 0.9, steps back when a number of
   * triangles or a largest error is asked for and no reduction was set.
   */
  void SetTargetReduction(double fraction);
  double GetTargetReduction() const;
  ///@}

  ///@{
  /**
   * Largest distance in both directions, proved, mm, 0 to 1e30; 0, the default, is off: no point of the input is farther
   * from the result, and no point of the result farther from the input, open borders curve to curve. Thesis stops when
   * a new point is that far away: exactly one may lie beyond it, and triangles between points may, too.
   */
  void SetMaximumError(double millimetres);
  double GetMaximumError() const;
  ///@}

  ///@{
  /// Run although MaximumError is more than a quarter of the diagonal of the input's bounding box, off by default: an error.
  void SetAllowLargeError(bool allow);
  bool GetAllowLargeError() const;
  vtkBooleanMacro(AllowLargeError, bool);
  ///@}

  ///@{
  /**
   * With MaximumError, on by default: no more pairs of triangles intersect than before, and what faces each other across a gap, two
   * fragments or the walls of a fracture, keeps half of the distance that it had. Not in Thesis mode.
   */
  void SetKeepClearance(bool keep);
  bool GetKeepClearance() const;
  vtkBooleanMacro(KeepClearance, bool);
  ///@}

  ///@{
  /**
   * The thesis's tolerance w in NFD = (area1 + area2) (1 - w n1.n2), 0 to 1, default 0.95. Smaller values make flat
   * areas dearer; at 1 every flat edge costs nothing whatever its length.
   */
  void SetNormalTolerance(double tolerance);
  double GetNormalTolerance() const;
  ///@}

  ///@{
  /**
   * In Thesis mode with a number of triangles or a reduction to reach, choose NormalTolerance by the share of the triangles
   * that stays (report entry "normal_tolerance"), off by default.
   */
  void SetAutomaticNormalTolerance(bool automatic);
  bool GetAutomaticNormalTolerance() const;
  vtkBooleanMacro(AutomaticNormalTolerance, bool);
  ///@}

  ///@{
  /**
   * Merge points with exactly equal coordinates first, on by default. Off, a surface whose triangles do not
   * share points (STL) is one open fragment per triangle.
   */
  void SetMergePoints(bool merge);
  bool GetMergePoints() const;
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /// Measure the distances between input and result in both directions for the report, on by default.
  void SetMeasureDistances(bool measure);
  bool GetMeasureDistances() const;
  vtkBooleanMacro(MeasureDistances, bool);
  ///@}

  ///@{
  /// Put the input on output port 1 with the distance of each of its points to the result, off by default.
  void SetMeasureInputDistances(bool measure);
  bool GetMeasureInputDistances() const;
  vtkBooleanMacro(MeasureInputDistances, bool);
  ///@}

  ///@{
  /// Threads to use, 0 to 1024; 0, the default, is one per processor. The result does not depend on it.
  void SetNumberOfThreads(int threads);
  int GetNumberOfThreads() const;
  ///@}

  ///@{
  /// vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or DEFAULT_PRECISION (the default, that of the input).
  void SetOutputPointsPrecision(int precision);
  int GetOutputPointsPrecision() const;
  ///@}

  ///@{
  /**
   * Give the result the arrays of the input's points and cells, on by default: floating values as they are at the place on
   * the input that is nearest to the new point, normals with their length, everything else from the nearest input point;
   * cell data from the input cell nearest to the centroid of the triangle. Costs look-ups only if there are any.
   */
  void SetPassArrays(bool pass);
  bool GetPassArrays() const;
  vtkBooleanMacro(PassArrays, bool);
  ///@}

  ///@{
  /**
   * Add the arrays OriginalPointIds (nearest input point) and OriginalCellIds to the output, and ResultPointIds, the output
   * point that each input point became part of or -1 if no triangle uses it, to output port 1. Off by default.
   */
  void SetMakeMaps(bool make);
  bool GetMakeMaps() const;
  vtkBooleanMacro(MakeMaps, bool);
  ///@}

  ///@{
  /// Give the output point normals of its own triangles instead of those of the input, off by default.
  void SetRecomputeNormals(bool recompute);
  bool GetRecomputeNormals() const;
  vtkBooleanMacro(RecomputeNormals, bool);
  ///@}

  ///@{
  /**
   * Name of the array of the distance of each output point to the input surface (with MeasureDistances to the reference, if
   * there is one), mm. Default "Distance".
   */
  void SetDistanceArrayName(const std::string& name);
  std::string GetDistanceArrayName() const;
  ///@}

  ///@{
  /// Name of the array of the largest distance recorded along the collapses into each output point, mm, default "RunningError".
  void SetRunningErrorArrayName(const std::string& name);
  std::string GetRunningErrorArrayName() const;
  ///@}

  ///@{
  /// Name of the array of how many input points each output point stands for. Default "InputPointCount".
  void SetPointCountArrayName(const std::string& name);
  std::string GetPointCountArrayName() const;
  ///@}

  ///@{
  /// Name of the array on output port 1 of the distance of each input point to the result, mm, default "DistanceToResult".
  void SetInputDistanceArrayName(const std::string& name);
  std::string GetInputDistanceArrayName() const;
  ///@}

  ///@{
  /**
   * With MaximumError in every mode but Thesis, certify the result as it is written (both directions, open borders) and
   * put the proved bounds into the report, on by default. A result that the certificate contradicts is an error.
   */
  void SetProveResult(bool prove);
  bool GetProveResult() const;
  vtkBooleanMacro(ProveResult, bool);
  ///@}

  ///@{
  /**
   * Name of the array of the proved bound at each output point, mm: no point of the triangles around it is farther from
   * the input, or from the reference if there is one. Default "ErrorBound".
   */
  void SetErrorBoundArrayName(const std::string& name);
  std::string GetErrorBoundArrayName() const;
  ///@}

  ///@{
  /**
   * Name of the array on output port 1 of the proved bound at each input point, mm: no point of the triangles around it
   * is farther from the result; only with MeasureInputDistances and without a reference. Default "ErrorBoundToResult".
   */
  void SetInputErrorBoundArrayName(const std::string& name);
  std::string GetInputErrorBoundArrayName() const;
  ///@}

  /// A largest error as a share of the scan's voxels.
  enum ErrorPresets
  {
    NO_PRESET = 0,
    QUARTER_VOXEL = 1,
    HALF_VOXEL = 2,
    ONE_VOXEL = 3
  };

  ///@{
  /**
   * A largest error as a share of the least side of the scan's voxels: one of ErrorPresets, by default NO_PRESET.
   * MaximumError counts, too, if it is smaller.
   */
  void SetErrorPreset(int preset);
  int GetErrorPreset() const;
  ///@}

  ///@{
  /**
   * The least side of the scan's voxels, mm, 0 to 1e30, for ErrorPreset; 0, the default, is estimated from the surface, which must be
   * as marching cubes leaves it; the report says so (voxel.from).
   */
  void SetVoxelSize(double millimetres);
  double GetVoxelSize() const;
  ///@}

  ///@{
  /**
   * Name of a point array of the input, of any type of number, with how far the surface may move at each point, mm: 0
   * freezes the point with all triangles at it, bit for bit; negative is no limit of its own; in between it is a largest
   * error there, linear on each triangle, proved in both directions like MaximumError, which caps it if set. Empty, the
   * default, is none; a name without such an array, NaN and infinity are errors. Thesis takes only 0 and negative ones.
   * vtkBoneTolerance makes such arrays.
   */
  void SetToleranceArrayName(const std::string& name);
  std::string GetToleranceArrayName() const;
  ///@}

  ///@{
  /**
   * Cell or point array of the input, of whole numbers, with the bone, fragment or segment of each triangle (the cell array if
   * there are both; several components are one label together; of points, the majority at the triangle). Lines between
   * different labels are simplified only along themselves, every output triangle has the label of the input triangles that it
   * stands for, and the report has each label's areas (labels.*). Empty, the default, is none; a wrong name is an error.
   */
  void SetLabelArrayName(const std::string& name);
  std::string GetLabelArrayName() const;
  ///@}

  /// Leave out components whose box is below this on its longest side, mm, 0 to 1e30, and list them in the report (pruned.*); all
  /// else in it is of what is left, and nothing left is an error. Default 0: none is ever left out.
  void SetPruneSize(double millimetres);
  double GetPruneSize() const;
  /// The same by area, mm2, 0 to 1e30. Default 0.
  void SetPruneArea(double squareMillimetres);
  double GetPruneArea() const;
  /// The same by volume, mm3, 0 to 1e30, of closed ones. Default 0.
  void SetPruneVolume(double cubicMillimetres);
  double GetPruneVolume() const;
  /// The same by number of triangles, 0 to 2147483647. Default 0.
  void SetPruneTriangles(int triangles);
  int GetPruneTriangles() const;

  ///@{
  /// Put what vtkBoneCheck finds in the input into the report ("findings.0.kind", ...), off by default.
  void SetExamineInput(bool examine);
  bool GetExamineInput() const;
  vtkBooleanMacro(ExamineInput, bool);
  ///@}

  /**
   * The first original of an input that is itself a result: what MaximumError, which must be set, is promised against.
   * Tolerances stay those against the input. An input that is farther from it than MaximumError is an error. Default none.
   */
  void SetReferenceData(vtkPolyData* reference);

  /// The same as a connection, to the input port 1. Default none.
  void SetReferenceConnection(vtkAlgorithmOutput* reference);

  /// What is wrong with the last value of a property ("MaximumError"), in one sentence; empty if it was valid.
  std::string GetRejectedValue(const std::string& property) const;

  /// Why the last run ended: one of StopReasons.
  int GetStopReason() const;

  /// Why the last run ended, as a sentence.
  std::string GetStopReasonAsString() const;

  /// The report of the last run is a flat list of named values ("output.faces", "distance.output_to_input.max", ...): how many.
  int GetNumberOfReportEntries() const;

  /// Name of an entry, 0 to GetNumberOfReportEntries() - 1; empty beyond that.
  std::string GetReportEntryName(int entry) const;

  /// Unit of the entry of that name ("mm", "mm2", "s", ...); empty where there is none.
  std::string GetReportEntryUnit(const std::string& name) const;

  /// A number of the report; NaN where the name is unknown or the entry is a text.
  double GetReportValue(const std::string& name) const;

  /// An entry of the report as text, numbers with all their digits; empty where the name is unknown.
  std::string GetReportText(const std::string& name) const;

protected:
  vtkBoneDecimate();
  ~vtkBoneDecimate() override;

  /// As if TargetReduction had never been set: for classes that set every property, asked for or not.
  void ForgetTargetReduction();

  /// An error event for each rejected value; whether there are any.
  bool ReportRejectedValues();

  /// Whether TargetReduction was set and so counts beside every other stop.
  bool IsTargetReductionSet() const;

  /// Every property of the other one. The input may be a part of a surface whose size AcceptSize() was told.
  void CopyOptions(const vtkBoneDecimate& from, bool isPart = false);
  bool AcceptSize(double diagonal, double largestError);

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneDecimate(const vtkBoneDecimate&) = delete;
  void operator=(const vtkBoneDecimate&) = delete;

  bool Accept(const std::string& problem);
  bool GoesOn(double fraction);
  void Warn(const std::vector<std::string>& sentences);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
