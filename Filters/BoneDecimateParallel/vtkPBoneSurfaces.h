// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPBoneSurfaces
 * @brief   vtkBoneSurfaces on several processes
 *
 * Every process needs the whole image and gets an equal part of the triangles; points where parts meet have equal coordinates, as
 * vtkPBoneDecimate needs them. If the processes have different images, as of a distributed image whose pieces do not know the
 * whole, that is an error on all of them.
 *
 * Every process must update the filter.
 */
#ifndef vtkPBoneSurfaces_h
#define vtkPBoneSurfaces_h

#include "vtkBoneSurfaces.h"
#include "vtkFiltersBoneDecimateParallelModule.h" // for export macro

class vtkMultiProcessController;

class VTKFILTERSBONEDECIMATEPARALLEL_EXPORT vtkPBoneSurfaces : public vtkBoneSurfaces
{
public:
  static vtkPBoneSurfaces* New();
  vtkTypeMacro(vtkPBoneSurfaces, vtkBoneSurfaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What connects the processes. Default: the global controller at construction; null is one process.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkPBoneSurfaces();
  ~vtkPBoneSurfaces() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPBoneSurfaces(const vtkPBoneSurfaces&) = delete;
  void operator=(const vtkPBoneSurfaces&) = delete;

  vtkMultiProcessController* Controller = nullptr;
};

#endif
