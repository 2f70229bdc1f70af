// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneSmooth
 * @brief   smooths a bone surface within a bound that is proved; keeps all triangles
 *
 * Removes the staircase of a segmentation. No point moves by more than Smoothing, nor by more than
 * MaximumError and its tolerance allow, and the largest distance between input and result is proved
 * in both directions. With Smoothing 0, the default, it is chosen from the voxel grid, which is
 * found in the surface of a binary segmentation: half of the smallest voxel spacing, or a third of
 * a smaller MaximumError; every voxel then keeps its label. Any other surface is left as it is, and
 * a warning says so: a gray-level surface holds more detail than its voxels.
 *
 * A point with the tolerance 0 and its triangles do not change. Points where surfaces or labels
 * meet move as one.
 *
 * Input port 0: the surface; with the arrays of vtkBoneSurfaces the grid is known from them. Input
 * port 1, optional: the label map from which another program extracted it (SetLabelMapData()).
 * Output: the same triangles with the arrays of the input, and the report in the field data.
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and
 * updates fail until it gets a valid one.
 *
 * Documentation/how-to/smoothing.md says what smoothing may be used for.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneSmooth_h
#define vtkBoneSmooth_h

#include "vtkBoneSmoothOptions.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <string> // for warnings
#include <vector> // for warnings

class vtkPolyData;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneSmooth : public vtkBoneSmoothOptions
{
public:
  static vtkBoneSmooth* New();
  vtkTypeMacro(vtkBoneSmooth, vtkBoneSmoothOptions);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkBoneSmooth();
  ~vtkBoneSmooth() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneSmooth(const vtkBoneSmooth&) = delete;
  void operator=(const vtkBoneSmooth&) = delete;

  bool Accept(const std::vector<std::string>& warnings);
};

#endif
