// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneSurfaceDistance
 * @brief   prove how far two surfaces are from each other
 *
 * Input port 0 is the reference, input port 1 the result, both of triangles, strips or polygons, in
 * millimeters. A branch and bound gives a proved lower and upper bound of the largest distance in
 * each direction and of the boundaries, curve to curve, with the position of each; the status says
 * whether every point of both keeps a tolerance, not only samples alone. Averages and root mean
 * squares come with the error of their estimate.
 *
 * Output port 0: the reference, output port 1: the result. Point data: the signed distance to the
 * other surface, mm (positive outside of it, and where there is no telling), as the active scalars;
 * and the side, 1 outside, -1 inside, 0 where there is no telling: at boundaries, where the surface
 * is not consistently oriented, and on it. Field data: the report as one JSON text,
 * BoneDecimateCertificate, and its main figures as arrays of their own:
 * bonedecimate.certificate.status, .lower, .upper, .boundaries, .reference_to_result.{upper, mean}
 * and .result_to_reference.{upper, mean}.
 *
 * An aborted run leaves the bounds and the status that are proved so far, and its report says
 * "stopped".
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and
 * updates fail until it gets a valid one.
 *
 * A surface that cannot be used (NaN in a triangle, an index out of range) is an error with empty
 * outputs. If one has no triangles, both pass through without arrays, with a warning.
 * Pieces of a surface on several processes are rejected.
 *
 * @sa vtkBoneDecimate vtkHausdorffDistancePointSetFilter vtkDistancePolyDataFilter
 */
#ifndef vtkBoneSurfaceDistance_h
#define vtkBoneSurfaceDistance_h

#include "vtkBoneAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for array names and report texts

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneSurfaceDistance : public vtkBoneAlgorithm
{
public:
  static vtkBoneSurfaceDistance* New();
  vtkTypeMacro(vtkBoneSurfaceDistance, vtkBoneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Whether the tolerance is kept.
  enum Status
  {
    NOT_REQUESTED = 0,
    PROVED,
    VIOLATED,
    UNDECIDED
  };

  ///@{
  /**
   * How far any point of one surface may be from the other, mm, 0 to 1e30. By default there is no
   * tolerance, and GetTolerance() returns -1.
   */
  void SetTolerance(double millimeters);
  vtkGetMacro(Tolerance, double);
  void RemoveTolerance();
  ///@}

  ///@{
  /**
   * Name of a point array of the reference with a tolerance for each point, mm, linear on its
   * triangles; negative: no limit of its own; NaN and numbers beyond 1e30 are errors. Tolerance, if
   * set, caps it. In the other direction a triangle of the reference counts with the least of its
   * corners. Empty, the default, is none.
   */
  vtkSetMacro(ToleranceArrayName, std::string);
  vtkGetMacro(ToleranceArrayName, std::string);
  ///@}

  ///@{
  /**
   * Narrow the bounds to the gap even where the tolerance is proved already, on by default.
   */
  vtkSetMacro(TightBounds, bool);
  vtkGetMacro(TightBounds, bool);
  vtkBooleanMacro(TightBounds, bool);
  ///@}

  ///@{
  /**
   * Largest difference of the bounds as a ratio to the upper bound, 1e-12 to 1; default 1e-6.
   */
  void SetRelativeGap(double gap);
  vtkGetMacro(RelativeGap, double);
  ///@}

  ///@{
  /**
   * Measure open boundaries, too, on by default. If only one surface has some, no tolerance is
   * kept.
   */
  vtkSetMacro(MeasureBoundaries, bool);
  vtkGetMacro(MeasureBoundaries, bool);
  vtkBooleanMacro(MeasureBoundaries, bool);
  ///@}

  ///@{
  /**
   * Estimate average and root mean square over the area to MeanPrecision, on by default.
   */
  vtkSetMacro(MeasureMeans, bool);
  vtkGetMacro(MeasureMeans, bool);
  vtkBooleanMacro(MeasureMeans, bool);
  ///@}

  ///@{
  /**
   * Also count triangles, components, boundary edges and intersecting pairs of triangles of each
   * surface, and measure area and volume: the entries "reference." and "result." of the report.
   * Find components of the reference that the result lacks: the entries "missing.", and a warning.
   * Off by default.
   */
  vtkSetMacro(MeasureSurfaces, bool);
  vtkGetMacro(MeasureSurfaces, bool);
  vtkBooleanMacro(MeasureSurfaces, bool);
  ///@}

  ///@{
  /**
   * Whether GetLowerBound() and GetUpperBound() follow a run in its progress events. It then takes
   * up to a fifth longer. Off by default: they are set when the run ends or is aborted.
   */
  vtkSetMacro(FollowBounds, bool);
  vtkGetMacro(FollowBounds, bool);
  vtkBooleanMacro(FollowBounds, bool);
  ///@}

  ///@{
  /**
   * Two standard errors of the average and of the root mean square as a ratio to them, 1e-4 to 1;
   * default 0.005.
   */
  void SetMeanPrecision(double precision);
  vtkGetMacro(MeanPrecision, double);
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024; 0, the default, is one per processor. The result does not depend on
   * it.
   */
  void SetNumberOfThreads(int threads);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Name of the array of the signed distances, mm. Default "SignedDistance". Empty: neither
   * distances nor sides of points are computed, which takes less time.
   */
  vtkSetMacro(SignedDistanceArrayName, std::string);
  vtkGetMacro(SignedDistanceArrayName, std::string);
  ///@}

  ///@{
  /**
   * Name of the array of the sides. Default "Side".
   */
  vtkSetMacro(SideArrayName, std::string);
  vtkGetMacro(SideArrayName, std::string);
  ///@}

  /**
   * For panels, which set every property: as SetTolerance(), but -1 removes the tolerance.
   */
  void SetToleranceOrNone(double millimeters);

  /**
   * Whether the last run kept its tolerance: one of Status.
   */
  int GetStatus() const;

  /**
   * The status as a word: "not_requested", "proved", "violated" or "undecided".
   */
  std::string GetStatusAsString() const;

  ///@{
  /**
   * Proved bounds of the two-sided Hausdorff distance of the surfaces, mm; in progress events those
   * proved so far, with FollowBounds. NaN before the first run.
   */
  double GetLowerBound() const;
  double GetUpperBound() const;
  ///@}

  /**
   * Whether the last run was aborted. Its bounds and status are those proved until then; averages
   * and the arrays may be missing.
   */
  bool GetWasStopped() const;

  /**
   * The whole report as JSON, objects within objects, as Documentation/certificate.schema.json
   * describes it.
   */
  std::string GetReportAsJson() const;

  /**
   * The report of the last run is a flat list of named values ("reference_to_result.upper",
   * "boundaries", ...). How many there are.
   */
  int GetNumberOfReportEntries() const;

  /**
   * Name of an entry, 0 to GetNumberOfReportEntries() - 1; empty beyond that.
   */
  std::string GetReportEntryName(int entry) const;

  /**
   * Unit of the entry of that name ("mm", "mm2", "s"); empty where there is none.
   */
  std::string GetReportEntryUnit(const std::string& name) const;

  /**
   * A number of the report; NaN where the name is unknown or the entry is a text.
   */
  double GetReportValue(const std::string& name) const;

  /**
   * An entry of the report as text, numbers with all their digits; empty where the name is unknown.
   */
  std::string GetReportText(const std::string& name) const;

protected:
  vtkBoneSurfaceDistance();
  ~vtkBoneSurfaceDistance() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneSurfaceDistance(const vtkBoneSurfaceDistance&) = delete;
  void operator=(const vtkBoneSurfaceDistance&) = delete;

  struct Internals;

  const Internals& Last() const;
  bool Compare(vtkPolyData* reference, vtkPolyData* result);
  bool Accept(int status);
  bool TakeTolerances(vtkPolyData* reference);
  void Warn(const std::string& surface, const std::vector<std::string>& sentences);
  void FillOutput(vtkPolyData* input, vtkPolyData* output, bool isReference);

  double Tolerance = -1.0; // mm
  bool TightBounds = true;
  double RelativeGap = 1e-6;
  bool MeasureBoundaries = true;
  bool MeasureMeans = true;
  bool MeasureSurfaces = false;
  bool FollowBounds = false;
  double MeanPrecision = 5e-3;
  int NumberOfThreads = 0;
  std::string ToleranceArrayName;
  std::string SignedDistanceArrayName = "SignedDistance";
  std::string SideArrayName = "Side";
  std::unique_ptr<Internals> Internal;
};

#endif
