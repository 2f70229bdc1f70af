// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneCap
 * @brief   close open boundaries, on request
 *
 * The surface of a volume is open where bone reaches the edge of the scan, and volume meshers and
 * solvers take closed surfaces. This filter fills boundaries with triangles between their points; a
 * point is added inside of a cap only where an edge of the cap would be one of the surface. Points
 * and cells of the input stay as they are; caps follow the polygons of the input. The cell array
 * BoneCap is 1 for triangles of caps and 0 for all others. Other cell arrays of a cap have the
 * values of a neighboring cell.
 *
 * A cap is bone where the scan shows none: it is no part of an error bound or a certificate, unless
 * it is added to the input before decimation. With PlanarLoops, the default, only loops at planes
 * where the surface ends are capped: those of a scan's edge. Loops in one plane are filled
 * together, so that a medullary canal stays a hole. Loops around an edge of the volume lie in
 * several planes and are left open. Loops that cannot be filled stay open and are counted. A cap
 * intersects the surface where triangles of the surface lie in the plane, too; that is not checked.
 *
 * Input: triangles or polygons in millimeters, no strips, on one process: a surface in several
 * pieces is rejected.
 *
 * @sa vtkBoneDecimate vtkBoneDiagnostics
 */
#ifndef vtkBoneCap_h
#define vtkBoneCap_h

#include "vtkBoneAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneCap : public vtkBoneAlgorithm
{
public:
  static vtkBoneCap* New();
  vtkTypeMacro(vtkBoneCap, vtkBoneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Loops.
  enum Choice
  {
    PlanarLoops = 0, ///< At planes where the surface ends.
    AllLoops = 1     ///< All others, too.
  };

  ///@{
  /**
   * Which loops are capped: PlanarLoops (0, the default) or AllLoops (1). Other numbers are an
   * error event; the value before stays, and updates fail until there is a valid one.
   */
  void SetLoops(int choice);
  vtkGetMacro(Loops, int);
  ///@}

  ///@{
  /**
   * mm, 0 or more, default 0.01: how far points of a loop may lie from their plane, and points of
   * the surface beyond it. Other numbers are an error event as above.
   */
  void SetPlaneTolerance(double tolerance);
  vtkGetMacro(PlaneTolerance, double);
  ///@}

  ///@{
  /**
   * Results of the last update: number of caps, of their triangles, their area in mm^2, the number
   * of loops that they close, and of boundary loops that stay open. 0 before the first update and
   * after one that failed.
   */
  vtkIdType GetNumberOfCaps() const;
  vtkIdType GetNumberOfCapTriangles() const;
  double GetCapArea() const;
  vtkIdType GetNumberOfClosedLoops() const;
  vtkIdType GetNumberOfOpenLoops() const;
  ///@}

protected:
  vtkBoneCap();
  ~vtkBoneCap() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneCap(const vtkBoneCap&) = delete;
  void operator=(const vtkBoneCap&) = delete;

  struct Results
  {
    vtkIdType Caps = 0;
    vtkIdType Triangles = 0;
    double Area = 0.0; // mm^2
    vtkIdType ClosedLoops = 0;
    vtkIdType OpenLoops = 0;
  };

  Results Last() const;

  int Loops = PlanarLoops;
  double PlaneTolerance = 0.01; // mm
  Results Found;                // by the last run
};

#endif
