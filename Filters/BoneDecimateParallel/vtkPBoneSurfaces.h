// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPBoneSurfaces
 * @brief   vtkBoneSurfaces on several processes
 *
 * Every process gets an equal part of the triangles; points where parts meet have equal
 * coordinates, as vtkPBoneDecimate needs them. The image may be whole on every process, or in
 * pieces, which are sent to all: labels do not end where pieces do. Images that differ in origin,
 * spacing, direction or type, or that leave voxels of their common extent out, are an error on all
 * processes.
 *
 * Every process must update the filter.
 */
#ifndef vtkPBoneSurfaces_h
#define vtkPBoneSurfaces_h

#include "vtkBoneSurfaces.h"
#include "vtkFiltersBoneDecimateParallelModule.h" // for export macro

#include <vector> // for values

class vtkMultiProcessController;

class VTKFILTERSBONEDECIMATEPARALLEL_EXPORT vtkPBoneSurfaces : public vtkBoneSurfaces
{
public:
  static vtkPBoneSurfaces* New();
  vtkTypeMacro(vtkPBoneSurfaces, vtkBoneSurfaces);
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
  vtkPBoneSurfaces();
  ~vtkPBoneSurfaces() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  bool IsCommon(std::vector<double>& values, bool areThere);

  vtkPBoneSurfaces(const vtkPBoneSurfaces&) = delete;
  void operator=(const vtkPBoneSurfaces&) = delete;

  vtkMultiProcessController* Controller = nullptr;
};

#endif
