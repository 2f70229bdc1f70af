// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneDecimateLevels
 * @brief   levels of detail: one decimation, recorded, and every stage of it at once
 *
 * The first update runs a decimation down to the coarsest level and records it. From then on each
 * update only reads a level: by a number of triangles (NumberOfTriangles), or by a largest measured
 * distance to the input (LevelError, mm). Changing an option of the run, or the input, starts a new
 * recording.
 *
 * The options of the run are those of vtkBoneDecimate: TargetNumberOfTriangles, TargetReduction and
 * MaximumError say where the coarsest level is, and every level keeps MaximumError. Without
 * MeasureDistances the levels have no measured distance, and LevelError selects the input. The
 * report and the getters are about the coarsest level; they are empty for a log.
 *
 * Tolerances of points (ToleranceArrayName) hold for all levels. Of labels (LabelArrayName) every
 * triangle of a level keeps its own, and curves between them do not change; a log of such a run
 * needs them again.
 *
 * Input port 0: the surface. Input port 1, optional: a surface with the same triangles and other
 * points, such as a bone registered to the first: the level is put on it, with the same triangles
 * as on the first. Input port 2, optional: the reference (SetReferenceData()). Input port 3,
 * optional: the label map (SetLabelMapData()). With a voxel grid every marked level is compared
 * voxel by voxel with the input, and KeepVoxels holds for all levels. Output: points and triangles
 * of the level, with the arrays of its label map and the cell array of its labels; lines, vertices
 * and other arrays do not come along.
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and
 * updates fail until it gets a valid one.
 *
 * The log (GetLog()) can be stored in a file and set in another instance with the same input
 * (SetLog()), which then does not run. Filters/Core/Levels/README.md has the format.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneDecimateLevels_h
#define vtkBoneDecimateLevels_h

#include "vtkBoneGoalOptions.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for names of options

class vtkUnsignedCharArray;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDecimateLevels : public vtkBoneGoalOptions
{
public:
  static vtkBoneDecimateLevels* New();
  vtkTypeMacro(vtkBoneDecimateLevels, vtkBoneGoalOptions);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Selects the first level that has no more triangles than this. 0 to 2147483647; 0, the default,
   * is off.
   */
  void SetNumberOfTriangles(int triangles);
  vtkGetMacro(NumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * Selects the coarsest level whose measured distance to the input is at most this, mm, or the
   * input if there is none. 0 to 1e30; 0, the default, is off. With NumberOfTriangles, the finer of
   * both; with neither, the coarsest level.
   */
  void SetLevelError(double millimeters);
  vtkGetMacro(LevelError, double);
  ///@}

  /**
   * The first surface, if the input is itself a result: MaximumError, which must be set, is then
   * proved against it, tolerances of points against the input. Measured distances are those to the
   * input. Default none.
   */
  void SetReferenceData(vtkPolyData* reference);

  /// Sets the first surface as a connection, to the input port 2. Default none.
  void SetReferenceConnection(vtkAlgorithmOutput* reference);

  /**
   * How many levels are marked, from fine to coarse; 0 before the first update.
   */
  int GetNumberOfMarks() const;

  /**
   * Triangles of a measured level, 0 to GetNumberOfMarks() - 1; 0 beyond that.
   */
  int GetMarkTriangles(int mark) const;

  ///@{
  /**
   * How far a measured level is from the input, mm: the largest and the mean distance, by samples,
   * each the larger of both directions; not a number if it was not measured.
   */
  double GetMarkLargestDistance(int mark) const;
  double GetMarkMeanDistance(int mark) const;
  ///@}

  /**
   * How many voxels have another label at a mark than in the input; -1 if no voxel grid is known.
   */
  vtkTypeInt64 GetMarkChangedVoxels(int mark) const;

  /**
   * The log of the run as bytes; no bytes before the first update. It belongs to the filter and
   * does not change later.
   */
  vtkUnsignedCharArray* GetLog();

  /**
   * A log to use instead of a run; null, the default, is a run. The next update fails if the log is
   * damaged or belongs to another surface.
   */
  void SetLog(vtkUnsignedCharArray* log);

protected:
  vtkBoneDecimateLevels();
  ~vtkBoneDecimateLevels() override;

  void OptionChanged(const std::string& name) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneDecimateLevels(const vtkBoneDecimateLevels&) = delete;
  void operator=(const vtkBoneDecimateLevels&) = delete;

  void Forget();
  bool Prepare(
    vtkPolyData* input, vtkPolyData* reference, const bonedecimate::LabelMapRequest& request);
  bool ReadArrays(
    vtkPolyData* input, vtkPolyData* reference, const bonedecimate::LabelMapRequest& request);
  bool OpenLog();
  bool Record();
  int SelectedLevel() const;
  bool Fill(vtkPolyData* input, vtkPolyData* other, vtkPolyData* output);

  int NumberOfTriangles = 0;
  double LevelError = 0.0; // mm

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
