// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPBoneDecimate
 * @brief   vtkBoneDecimate for a surface that lies on several processes, or in several blocks
 *
 * Every process has a part of the surface; where parts meet, points have exactly equal coordinates.
 *
 *     shared  points of open boundaries and of curves between labels that more than one process has
 *     smoothing process 0 smooths the whole surface and hands each process its points
 *     phase 1   each process decimates its part, towards its part of the triangles, and away from
 *               the parts of others; shared points and the corners of their triangles are
 *               constrained
 *     phase 2   strips around what phase 1 left go to process 0, are joined there and decimated
 *               further with their rims constrained; the result stays there
 *     voxels    process 0 compares the voxels of the whole input and of the whole result
 *
 * The result is connected as the input is, wherever points are equal. TargetNumberOfTriangles and
 * TargetReduction refer to the whole surface. MaximumError holds for the whole surface, relative to
 * the input before smoothing: both phases are proved against the input.
 * IntersectionGuard works across processes. The same partition gives the same bytes. With an array
 * of tolerances, with a reference, and in Thesis mode with MaximumError there is no second phase:
 * the triangles at the shared points stay as they are.
 *
 * The smoothed surface is that of one process, bit for bit. KeepVoxels is decided for the whole
 * surface. Components are pruned as those of the whole. Only smoothing and the comparison of voxels
 * need the memory of the whole surface on process 0.
 *
 * The report in the field data is then that of the whole surface and shorter: stop_reason,
 * triangles, components and area of both surfaces, proof.status, proof.upper and proof.sentence,
 * distances of points (distance.*.max and .mean), pruned.*, smoothing.*, voxels.* and parallel.*.
 * parallel.missing says what else the report of one process has. The getters have the same.
 *
 * On one process a vtkPolyData gives exactly what vtkBoneDecimate gives. The polydata in a
 * composite data set are taken as one surface, so that equal points of blocks hang together; the
 * cell array BlockIndex says from which block a triangle is.
 *
 * Every process must update the filter, those without triangles, too. Rejected on several:
 * LabelArrayName with PassArrays off, MergePoints off, MakeMaps, DiagnoseInput, an
 * OutputPointsPrecision other than the default, an OutputPointsGrid, smoothing with a reference or
 * of parts in different precision, and an ErrorPreset without VoxelSize or a voxel grid. Parts and
 * blocks of different label maps are always rejected. ErrorBoundToResult is left out.
 */
#ifndef vtkPBoneDecimate_h
#define vtkPBoneDecimate_h

#include "vtkBoneDecimate.h"
#include "vtkFiltersBoneDecimateParallelModule.h" // for export macro
#include "vtkSmartPointer.h"                      // for surfaces

#include <string> // for names
#include <vector> // for choices of cells

class vtkMultiProcessController;

namespace bonedecimate
{
struct MeetingOfParts;
}

class VTKFILTERSBONEDECIMATEPARALLEL_EXPORT vtkPBoneDecimate : public vtkBoneDecimate
{
public:
  static vtkPBoneDecimate* New();
  vtkTypeMacro(vtkPBoneDecimate, vtkBoneDecimate);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What connects the processes. Default: the global controller at construction; null is one
   * process.
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
  struct Strips;

  bool HasProcesses() const;
  double OfAll(double own, int operation) const;
  bool IsTrueAnywhere(bool own) const;
  bool Run(vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference);
  void PassProgress(vtkObject* caller, unsigned long event, void* data);
  int RunAlone(vtkPolyData* input, vtkPolyData* reference, vtkInformationVector* outputVector);
  int RunTogether(vtkPolyData* input, vtkPolyData* reference, double voxelSize,
    vtkInformationVector* outputVector);
  double ProvedByAll(vtkPBoneDecimate* run) const;
  void AddRuns(vtkPBoneDecimate* run, Plan& plan);

  double WholeDiagonal(vtkPolyData* input) const;
  double TargetTriangles(double total, double error, bool isLimited) const;
  bool IsLimitedEverywhere(vtkPolyData* input);
  bool AcceptOptions(vtkPolyData* input, vtkPolyData* reference, double voxelSize);
  std::vector<std::string> KindsOfRun(
    vtkPolyData* input, vtkPolyData* reference, double voxelSize) const;
  vtkSmartPointer<vtkPolyData> WithCellLabels(vtkPolyData* input);
  bonedecimate::MeetingOfParts MeetingOf(vtkPolyData* part) const;
  vtkSmartPointer<vtkPolyData> PruneTogether(vtkPolyData* input);
  Plan MakePlan(vtkPolyData* input, vtkPolyData* reference, double voxelSize);
  void GatherWhole(vtkPolyData* input, Plan& plan);
  bool SmoothTogether(vtkPolyData* input, Plan& plan);
  void CompareVoxelsTogether(vtkPolyData* output, Plan& plan);
  void FindNeighbors(vtkPolyData* input, Plan& plan);
  std::vector<bool> UnchangedCells(vtkPolyData* surface, const Plan& plan) const;
  void Order(vtkPBoneDecimate* run, double triangles, const Plan& plan);
  bool ReducePart(
    vtkPBoneDecimate* run, vtkPolyData* input, vtkPolyData* reference, const Plan& plan);
  void ReduceSharedStrips(
    vtkPolyData* input, Plan& plan, vtkPolyData* output, vtkPolyData* inputCopy);
  Strips CutStripsOfAll(vtkPolyData* input, vtkPolyData* output, const Plan& plan);
  vtkSmartPointer<vtkPolyData> ReduceStrips(vtkPBoneDecimate* run, vtkPolyData* joined,
    const Strips& strips, const Plan& plan, double triangles);
  void MeasureAnew(vtkPolyData* input, vtkPolyData* rest, vtkPolyData* reduced);
  void FillInputCopy(
    vtkPolyData* input, const std::vector<vtkPolyData*>& result, vtkPolyData* inputCopy);
  void AddDistances(
    vtkPolyData* surface, const std::string& array, const std::string& direction, Plan& plan) const;
  void Report(Plan& plan, vtkPolyData* output, vtkPolyData* inputCopy);

  vtkMultiProcessController* Controller = nullptr;
};

#endif
