// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPBoneDecimate
 * @brief   vtkBoneDecimate for a surface that lies on several processes, or in several blocks
 *
 * Every process has a part of the surface; where parts meet, their open boundaries have points with exactly equal coordinates.
 *
 *     shared  = points of open boundaries that more than one process has
 *     phase 1   each process decimates its part with the shared points constrained, towards its part of the triangles
 *     phase 2   strips of a few rings around the shared points go to process 0, are joined there and decimated with their
 *               rims constrained; the result stays there
 *
 * The result hangs together as the input did, wherever points are equal. TargetNumberOfTriangles and TargetReduction are meant of
 * the whole surface. MaximumError holds of the whole surface: phase 1 may use four fifths of it, phase 2 one fifth. The same
 * partition gives the same bytes. With an array of tolerances, with a reference, and in Thesis mode with MaximumError there is no
 * second phase: the triangles at the shared points stay as they are.
 *
 * The report in the field data is then that of the whole surface and short: input.triangles, output.triangles, proof.upper (mm), and
 * parallel.*; the getters keep that of the process's own part.
 *
 * On one process a vtkPolyData gives exactly what vtkBoneDecimate gives. The polydata in a composite data set are taken as one
 * surface, so that equal points of blocks hang together; the cell array BlockIndex says from which block a triangle is.
 *
 * Every process must update the filter, those without triangles, too. Rejected on several: pruning, labels, MergePoints off, MakeMaps,
 * DiagnoseInput, an OutputPointsPrecision other than the default, and an ErrorPreset without VoxelSize. ErrorBoundToResult is left out.
 */
#ifndef vtkPBoneDecimate_h
#define vtkPBoneDecimate_h

#include "vtkBoneDecimate.h"
#include "vtkFiltersBoneDecimateParallelModule.h" // for export macro

class vtkMultiProcessController;

class VTKFILTERSBONEDECIMATEPARALLEL_EXPORT vtkPBoneDecimate : public vtkBoneDecimate
{
public:
  static vtkPBoneDecimate* New();
  vtkTypeMacro(vtkPBoneDecimate, vtkBoneDecimate);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What connects the processes. Default: the global controller at construction; null is one process.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkPBoneDecimate();
  ~vtkPBoneDecimate() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPBoneDecimate(const vtkPBoneDecimate&) = delete;
  void operator=(const vtkPBoneDecimate&) = delete;

  struct Plan;

  bool HasProcesses() const;
  double OfAll(double own, int operation) const;
  bool IsTrueAnywhere(bool own) const;
  bool Run(vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference);
  void PassProgress(vtkObject* caller, unsigned long event, void* data);
  int RunAlone(vtkPolyData* input, vtkPolyData* reference, vtkInformationVector* outputVector);
  int RunTogether(vtkPolyData* input, vtkPolyData* reference, vtkInformationVector* outputVector);
  double ProvedByAll(vtkPBoneDecimate* run) const;

  double LargestError() const;
  double WholeDiagonal(vtkPolyData* input) const;
  double TargetTriangles(double total, bool isLimited) const;
  bool IsLimitedEverywhere(vtkPolyData* input);
  const char* ProblemOfParts();
  Plan MakePlan(vtkPolyData* input, vtkPolyData* reference);
  void Order(vtkPBoneDecimate* run, double triangles, double error) const;
  bool ReducePart(
    vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference, const Plan& plan);
  void ReduceSharedStrips(
    vtkPolyData* input, Plan& plan, vtkPolyData* output, vtkPolyData* inputCopy);
  bool ReduceStrips(vtkPBoneDecimate* run, vtkPolyData* strips, const Plan& plan, double triangles);
  void MeasureAnew(
    vtkPolyData* input, vtkPolyData* rest, vtkPolyData* reduced, vtkPolyData* inputCopy);
  void Report(const Plan& plan, vtkPolyData* output);

  vtkMultiProcessController* Controller = nullptr;
};

#endif
