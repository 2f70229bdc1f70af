// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVBoneDecimate
 * @brief   vtkPBoneDecimate as a panel sets it
 *
 * A panel sets every property, those at their default, too. For vtkBoneDecimate a reduction that
 * was set counts beside every other stop, and its default steps back: here a reduction that equals
 * the default was not set.
 */
#ifndef vtkPVBoneDecimate_h
#define vtkPVBoneDecimate_h

#include "vtkBoneDecimateParaViewModule.h" // for export macro
#include "vtkPBoneDecimate.h"

class VTKBONEDECIMATEPARAVIEW_EXPORT vtkPVBoneDecimate : public vtkPBoneDecimate
{
public:
  static vtkPVBoneDecimate* New();
  vtkTypeMacro(vtkPVBoneDecimate, vtkPBoneDecimate);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Fraction of the triangles to remove, 0 to 1. The default of TargetReduction is as if nothing
   * was set.
   */
  void SetTargetReductionUnlessDefault(double fraction);

protected:
  /// Makes the distance the active scalars of the result: ParaView colors by them at once.
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkPVBoneDecimate() = default;
  ~vtkPVBoneDecimate() override = default;

private:
  vtkPVBoneDecimate(const vtkPVBoneDecimate&) = delete;
  void operator=(const vtkPVBoneDecimate&) = delete;
};

#endif
