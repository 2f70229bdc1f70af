// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneDecimateLevels
 * @brief   levels of detail: one decimation, recorded, and every stage of it at once
 *
 * The first update runs vtkBoneDecimate's engine down to the coarsest level and records it. From then on each update only
 * reads a level off: by a number of triangles, or by a largest measured distance to the input (mm). Changing a property of
 * the run, or the input, records anew.
 *
 * Input port 0: the surface. Input port 1, optional: a surface with the same triangles and other points, such as a bone
 * registered to the first: the level is put on it, with the same triangles as on the first.
 * Output: points and triangles of the level; lines, vertices and arrays of the input do not come along.
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and updates fail until it gets a
 * valid one.
 *
 * The log can be taken out (GetLog()), kept in a file, and given to another instance with the same input (SetLog()), which
 * then need not run. Documentation/levels.md has the format.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneDecimateLevels_h
#define vtkBoneDecimateLevels_h

#include "vtkFiltersBoneDecimateModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for sentences

class vtkUnsignedCharArray;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDecimateLevels : public vtkPolyDataAlgorithm
{
public:
  static vtkBoneDecimateLevels* New();
  vtkTypeMacro(vtkBoneDecimateLevels, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override; // changes as long as there is a rejected value

  ///@{
  /**
   * The mode of the run, one of vtkBoneDecimate::Modes. Default BALANCED.
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * Number of triangles of the coarsest level, 0 to 2147483647. Default 0: a tenth of the input's, or with MaximumError as
   * few as it allows.
   */
  void SetCoarsestNumberOfTriangles(int triangles);
  vtkGetMacro(CoarsestNumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * Largest distance that the run may cause, mm, 0 to 1e30, proved in every mode but THESIS: every level keeps it. Default 0:
   * none.
   */
  void SetMaximumError(double millimetres);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * Run although MaximumError is more than a quarter of the diagonal of the input's bounding box, off by default: an error.
   */
  void SetAllowLargeError(bool allow);
  vtkGetMacro(AllowLargeError, bool);
  vtkBooleanMacro(AllowLargeError, bool);
  ///@}

  ///@{
  /**
   * Measure how far levels are from the input, about two for each halving of the number of triangles, on by default. Without
   * it LevelError is of no use.
   */
  void SetMeasureErrors(bool measure);
  vtkGetMacro(MeasureErrors, bool);
  vtkBooleanMacro(MeasureErrors, bool);
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024. Default 0: one per processor. No level depends on it.
   */
  void SetNumberOfThreads(int threads);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The level wanted, by a number of triangles: the first one that has no more. 0 to 2147483647; 0, the default, is off.
   */
  void SetNumberOfTriangles(int triangles);
  vtkGetMacro(NumberOfTriangles, int);
  ///@}

  ///@{
  /**
   * The level wanted, by a distance to the input, mm: the coarsest measured one that is not farther, or the input. 0 to 1e30;
   * 0, the default, is off. With NumberOfTriangles, the finer of both; with neither, the coarsest level.
   */
  void SetLevelError(double millimeters);
  vtkGetMacro(LevelError, double);
  ///@}

  /**
   * What is wrong with the last value of a property ("LevelError"), in one sentence; empty if it was valid.
   */
  std::string GetRejectedValue(const std::string& property) const;

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
   * How far a measured level is from the input, mm: the largest and the mean distance, by samples, each the larger of both
   * directions; not a number if it was not measured.
   */
  double GetMarkLargestDistance(int mark) const;
  double GetMarkMeanDistance(int mark) const;
  ///@}

  /**
   * The log of the run as bytes; no bytes before the first update. It belongs to the filter and does not change later.
   */
  vtkUnsignedCharArray* GetLog();

  /**
   * A log to be used instead of a run, from now on; null goes back to runs. That it is not damaged and belongs to the input
   * is found out by the next update, which otherwise fails.
   */
  void SetLog(vtkUnsignedCharArray* log);

protected:
  vtkBoneDecimateLevels();
  ~vtkBoneDecimateLevels() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneDecimateLevels(const vtkBoneDecimateLevels&) = delete;
  void operator=(const vtkBoneDecimateLevels&) = delete;

  void Forget();
  bool Prepare(vtkPolyData* input);
  bool OpenLog(vtkPolyData* input);
  bool Record(vtkPolyData* input);
  int LevelWanted() const;
  bool Fill(vtkPolyData* other, vtkPolyData* output);

  int Mode = 2;
  int CoarsestNumberOfTriangles = 0;
  double MaximumError = 0.0; // mm
  bool AllowLargeError = false;
  bool MeasureErrors = true;
  int NumberOfThreads = 0;
  int NumberOfTriangles = 0;
  double LevelError = 0.0; // mm

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
