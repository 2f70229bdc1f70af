// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneVoxelCheck
 * @brief   count the voxels of a label map whose label a surface changes
 *
 * Input port 0 is a surface, input port 1 the label map (vtkImageData). The surface is voxelized on
 * the grid of the image, and each voxel is compared with the image. A surface of several labels
 * needs the arrays of vtkBoneSurfaces (BoundaryLabels, LabelValues); a surface without them is that
 * of one label, Label. Labels of the image that the surface does not have count as background;
 * GetNumberOfLabelsLeftOut() says how many these are.
 *
 * A surface with another voxel grid than the image may be that of the map of a network, from whose
 * grid the labels of the image were copied (ModelGrid of vtkBoneSurfaces). If the image is such a
 * copy, the voxels compared are those of the network's map; GetModelGridFound() says so, and the
 * voxels of the image are compared as well.
 *
 * The array of labels is chosen by SetInputArrayToProcess with port 1, by default the active
 * scalars. The output is the surface, unchanged. The check has no code in common with the filters
 * that make surfaces.
 *
 * @sa vtkBoneSurfaces vtkBoneDecimate
 */
#ifndef vtkBoneVoxelCheck_h
#define vtkBoneVoxelCheck_h

#include "vtkBoneAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <cstdint> // for std::int64_t
#include <memory>  // for std::unique_ptr
#include <string>  // for GetRejectedValue
#include <vector>  // for the labels of the image

class vtkImageData;

namespace bonedecimate
{
struct LabelMapSource;
}

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneVoxelCheck : public vtkBoneAlgorithm
{
public:
  static vtkBoneVoxelCheck* New();
  vtkTypeMacro(vtkBoneVoxelCheck, vtkBoneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The label inside of a surface that has no array BoundaryLabels. The background, 0 by default:
   * the only other label of the image; an image with several is then an error. So is another label
   * for a surface that has the array.
   */
  vtkSetMacro(Label, vtkTypeInt64);
  vtkGetMacro(Label, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * The label of voxels that belong to nothing, default 0. For a surface with the array
   * LabelValues, whose last value is the background, another label than that or 0 is an error; with
   * that label, Label has to be the same.
   */
  vtkSetMacro(BackgroundLabel, vtkTypeInt64);
  vtkGetMacro(BackgroundLabel, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024; 0, the default, is one per processor. The counts do not depend on
   * it.
   */
  void SetNumberOfThreads(int threads);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /**
   * How many voxels the last update compared; 0 before the first one and after an error. The
   * outermost voxels of an open surface are not compared, and its rows along x that no triangle
   * crosses count as unchanged.
   */
  vtkTypeInt64 GetNumberOfComparedVoxels() const;

  /**
   * Whether the last update was aborted. There are then no counts.
   */
  bool GetWasStopped() const;

  /**
   * How many voxels have another label in the surface than in the image.
   */
  vtkTypeInt64 GetNumberOfChangedVoxels() const;

  /**
   * Whether the voxels are those of the map of a network, in one sentence; empty: those of the
   * image.
   */
  std::string GetModelGridFound() const;

  ///@{
  /**
   * The numbers of compared and of changed voxels of the image, if the others are those of the map
   * of a network; else 0.
   */
  vtkTypeInt64 GetNumberOfComparedImageVoxels() const;
  vtkTypeInt64 GetNumberOfChangedImageVoxels() const;
  ///@}

  /**
   * Indices of the first changed voxel along x, y and z, counted from the first voxel of the
   * map; meaningless if none is changed.
   */
  void GetFirstChangedVoxel(int voxel[3]) const;

  /**
   * Number of labels of the surface, the background last.
   */
  int GetNumberOfLabels() const;

  /**
   * A label, 0 to GetNumberOfLabels() - 1; 0 beyond that.
   */
  vtkTypeInt64 GetLabelValue(int index) const;

  /**
   * Number of labels of the image that the surface does not have: their voxels count as background.
   */
  int GetNumberOfLabelsLeftOut() const;

  /**
   * A label that was left out, 0 to GetNumberOfLabelsLeftOut() - 1; 0 beyond that.
   */
  vtkTypeInt64 GetLabelLeftOut(int index) const;

  ///@{
  /**
   * Voxels of a label by its index: in the image; in the image but not in the surface; the reverse.
   * 0 for other indices.
   */
  vtkTypeInt64 GetNumberOfVoxels(int index) const;
  vtkTypeInt64 GetNumberOfLostVoxels(int index) const;
  vtkTypeInt64 GetNumberOfGainedVoxels(int index) const;
  ///@}

protected:
  vtkBoneVoxelCheck();
  ~vtkBoneVoxelCheck() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneVoxelCheck(const vtkBoneVoxelCheck&) = delete;
  void operator=(const vtkBoneVoxelCheck&) = delete;

  struct Internals;

  const Internals& Last() const;
  std::string FindIneffective(vtkTypeInt64 background) const;
  std::string ChooseLabel(
    const std::vector<std::int64_t>& inImage, bonedecimate::LabelMapSource& source) const;
  std::string Compare(vtkPolyData* surface, vtkImageData* image);

  vtkTypeInt64 Label = 0;
  vtkTypeInt64 BackgroundLabel = 0;
  int NumberOfThreads = 0;
  std::unique_ptr<Internals> Internal;
};

#endif
