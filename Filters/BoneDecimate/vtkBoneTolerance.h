// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneTolerance
 * @brief   turn a choice of points into a tolerance in millimeters for each point
 *
 * Chooses points of a surface (by an array, a selection, an implicit function, the lines where it
 * folds or ends) and gives them one tolerance and all others another one, with a ring around in
 * which it changes linearly. The result is the input with a point array, double, that
 * vtkBoneDecimate::SetToleranceArrayName and vtkBoneSurfaceDistance::SetToleranceArrayName
 * understand: 0 keeps a point and all its triangles unchanged, a positive number is a largest error
 * there, negative is no limit. Coordinates are millimeters.
 *
 * Several in a row combine: where the array is there already it is lowered, never raised. "Joint
 * 0.05, shaft 0.3, everything else 0.1" is one filter for each, the last with UNLIMITED. Brush:
 * choose what may change, InvertedOn, InsideTolerance 0: everything else stays as it is.
 *
 * Input port 0: the surface. Input port 1, optional: a vtkSelection of points or cells of it.
 *
 * A value outside its range, NaN and infinity above all, is an error event when it is set: the
 * property keeps its value, and updates fail until it gets a valid one. A name without an array, a
 * choice without what it needs, an array of another length, a cell with a point id out of range,
 * NaN in the array of tolerances or from the implicit function: an error, and no output.
 *
 * @sa vtkBoneDecimate vtkBoneSurfaceDistance
 */
#ifndef vtkBoneTolerance_h
#define vtkBoneTolerance_h

#include "vtkBoneAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for array names

class vtkImplicitFunction;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneTolerance : public vtkBoneAlgorithm
{
public:
  static vtkBoneTolerance* New();
  vtkTypeMacro(vtkBoneTolerance, vtkBoneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What chooses the points.
  enum Choices
  {
    EVERYTHING = 0,    ///< All points.
    POINT_ARRAY,       ///< Points whose value counts.
    CELL_ARRAY,        ///< Points of cells whose value counts.
    SELECTION,         ///< Points, or points of cells, of the selection on input port 1.
    IMPLICIT_FUNCTION, ///< Points where the function is not positive.
    FOLDS,             ///< Points on edges with an angle between their two triangles.
    BOUNDARIES,        ///< Points on edges of one triangle.
    UNLIMITED          ///< Points that have no tolerance yet: in the input's array, if it is there.
  };

  ///@{
  /**
   * What chooses the points, one of Choices. Default EVERYTHING.
   */
  void SetChoice(int choice);
  vtkGetMacro(Choice, int);
  void SetChoiceToEverything() { this->SetChoice(EVERYTHING); }
  void SetChoiceToPointArray() { this->SetChoice(POINT_ARRAY); }
  void SetChoiceToCellArray() { this->SetChoice(CELL_ARRAY); }
  void SetChoiceToSelection() { this->SetChoice(SELECTION); }
  void SetChoiceToImplicitFunction() { this->SetChoice(IMPLICIT_FUNCTION); }
  void SetChoiceToFolds() { this->SetChoice(FOLDS); }
  void SetChoiceToBoundaries() { this->SetChoice(BOUNDARIES); }
  void SetChoiceToUnlimited() { this->SetChoice(UNLIMITED); }
  ///@}

  ///@{
  /**
   * Name of the array of POINT_ARRAY and CELL_ARRAY, of one component and any type of number.
   * Values that count are those of the labels or, without labels, all but 0. Default "Choice".
   */
  vtkSetMacro(ChoiceArrayName, std::string);
  vtkGetMacro(ChoiceArrayName, std::string);
  ///@}

  /**
   * Adds a value that counts. By default there is none: then every value but 0 does.
   */
  void AddLabel(int label);

  /**
   * Forgets all labels.
   */
  void RemoveAllLabels();

  /**
   * How many labels there are.
   */
  int GetNumberOfLabels() const;

  /**
   * A label, 0 to GetNumberOfLabels() - 1; 0 beyond that.
   */
  int GetLabel(int index) const;

  ///@{
  /**
   * The function of IMPLICIT_FUNCTION, in mm: a vtkSphere, a vtkBox, a vtkPlane, any. Default none.
   */
  virtual void SetImplicitFunction(vtkImplicitFunction* function);
  vtkGetObjectMacro(ImplicitFunction, vtkImplicitFunction);
  ///@}

  ///@{
  /**
   * FOLDS: the angle between the normals of two triangles from which their edge counts, degrees, 0
   * to 180, default 30. Edges of more than two triangles and of triangles that face opposite ways
   * count, too.
   */
  void SetFoldAngle(double degrees);
  vtkGetMacro(FoldAngle, double);
  ///@}

  ///@{
  /**
   * Take what is not chosen instead, off by default. Of cells it is the cells that change sides, so
   * that points on the line in between are chosen in both cases.
   */
  vtkSetMacro(Inverted, bool);
  vtkGetMacro(Inverted, bool);
  vtkBooleanMacro(Inverted, bool);
  ///@}

  ///@{
  /**
   * Tolerance of the chosen points, mm. 0, the default, keeps them unchanged; negative is no limit;
   * -1e30 to 1e30.
   */
  void SetInsideTolerance(double millimeters);
  vtkGetMacro(InsideTolerance, double);
  ///@}

  ///@{
  /**
   * Tolerance of all other points, mm. Negative, the default, is no limit; -1e30 to 1e30.
   */
  void SetOutsideTolerance(double millimeters);
  vtkGetMacro(OutsideTolerance, double);
  ///@}

  ///@{
  /**
   * Width of a ring around the chosen points, mm, 0 to 1e30; 0, the default, is none. In it the
   * tolerance goes from that inside to that outside, linearly with the straight distance to the
   * nearest chosen point. Both must then be 0 or more.
   */
  void SetFeather(double millimeters);
  vtkGetMacro(Feather, double);
  ///@}

  ///@{
  /**
   * Name of the point array of tolerances, mm. One of that name on the input is lowered. Default
   * "Tolerance".
   */
  vtkSetMacro(ToleranceArrayName, std::string);
  vtkGetMacro(ToleranceArrayName, std::string);
  ///@}

  /**
   * The implicit function counts, too.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkBoneTolerance();
  ~vtkBoneTolerance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneTolerance(const vtkBoneTolerance&) = delete;
  void operator=(const vtkBoneTolerance&) = delete;

  struct Internals;

  std::string Problem(vtkPolyData* input, vtkDataObject* selection) const;
  bool Choose(vtkPolyData* input, vtkDataObject* selection) const;
  void ChooseUnlimited(vtkPolyData* input) const;
  bool ChooseByFunction(vtkPolyData* input) const;
  void ChooseLines(vtkPolyData* input) const;
  void Lower(vtkPolyData* output) const;

  int Choice = EVERYTHING;
  vtkImplicitFunction* ImplicitFunction = nullptr;
  double FoldAngle = 30.0; // degrees
  bool Inverted = false;
  double InsideTolerance = 0.0;   // mm
  double OutsideTolerance = -1.0; // mm
  double Feather = 0.0;           // mm
  std::string ChoiceArrayName = "Choice";
  std::string ToleranceArrayName = "Tolerance";
  std::unique_ptr<Internals> Internal;
};

#endif
