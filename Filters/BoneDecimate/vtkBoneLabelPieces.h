// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneLabelPieces
 * @brief   remove small islands and fill small cavities of the labels of a label map
 *
 * The input is a label map as vtkBoneSurfaces takes it. Nothing changes unless one of the limits is
 * set.
 *
 * An island is a piece of a label, connected by faces of voxels, other than the largest piece of
 * the label. One that is below any of IslandSize, IslandArea and IslandVolume gets the label that
 * has the largest part of its boundary; the background and the end of the image count as well.
 *
 * A cavity is a piece of background, connected by faces or edges of voxels as it is in surfaces,
 * that does not reach the end of the image and touches one label alone. One of at most CavityVolume
 * gets this label. Islands are removed first.
 *
 * The output is the image with the changed labels as active scalars, beside its other arrays; the
 * input does not change. The counts tell what was changed in the last update. The image is
 * processed as a whole; one that comes in pieces is an error, and so are labels of a type that does
 * not hold BackgroundLabel.
 *
 * @sa vtkBoneSurfaces
 */
#ifndef vtkBoneLabelPieces_h
#define vtkBoneLabelPieces_h

#include "vtkFiltersBoneDecimateModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for GetRejectedValue

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneLabelPieces : public vtkImageAlgorithm
{
public:
  static vtkBoneLabelPieces* New();
  vtkTypeMacro(vtkBoneLabelPieces, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override; // changes as long as there is a rejected value

  /**
   * Adds a label whose pieces are looked at. By default there is none: then those of all labels
   * are. All others stay as they are.
   */
  void AddLabel(vtkTypeInt64 label);

  /**
   * Forgets all labels.
   */
  void RemoveAllLabels();

  ///@{
  /**
   * The label of voxels that belong to nothing, default 0.
   */
  vtkSetMacro(BackgroundLabel, vtkTypeInt64);
  vtkGetMacro(BackgroundLabel, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * Islands are removed whose box of voxels has no side of at least this length, mm, along the axes
   * of the image. 0, the default, is off.
   */
  void SetIslandSize(double size);
  vtkGetMacro(IslandSize, double);
  ///@}

  ///@{
  /**
   * Islands are removed whose voxels have faces of a smaller area, mm2. 0, the default, is off.
   */
  void SetIslandArea(double area);
  vtkGetMacro(IslandArea, double);
  ///@}

  ///@{
  /**
   * Islands of a smaller volume are removed, mm3. 0, the default, is off.
   */
  void SetIslandVolume(double volume);
  vtkGetMacro(IslandVolume, double);
  ///@}

  ///@{
  /**
   * Cavities of at most this volume are filled, mm3. 0, the default, is off.
   */
  void SetCavityVolume(double volume);
  vtkGetMacro(CavityVolume, double);
  ///@}

  ///@{
  /**
   * What the last update changed of a label: islands that were removed, their voxels and mm^3,
   * cavities that were filled and theirs.
   */
  vtkTypeInt64 GetNumberOfIslands(vtkTypeInt64 label) const;
  vtkTypeInt64 GetNumberOfIslandVoxels(vtkTypeInt64 label) const;
  double GetVolumeOfIslands(vtkTypeInt64 label) const;
  vtkTypeInt64 GetNumberOfCavities(vtkTypeInt64 label) const;
  vtkTypeInt64 GetNumberOfCavityVoxels(vtkTypeInt64 label) const;
  double GetVolumeOfCavities(vtkTypeInt64 label) const;
  ///@}

  /**
   * Whether the largest piece of a label is below a limit of islands, too. It stays.
   */
  bool IsLargestPieceTooSmall(vtkTypeInt64 label) const;

  /**
   * What is wrong with the last value of a property ("IslandVolume"), in one sentence; empty if it
   * was valid.
   */
  std::string GetRejectedValue(const std::string& property) const;

protected:
  vtkBoneLabelPieces();
  ~vtkBoneLabelPieces() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneLabelPieces(const vtkBoneLabelPieces&) = delete;
  void operator=(const vtkBoneLabelPieces&) = delete;

  struct Internals;

  vtkTypeInt64 BackgroundLabel = 0;
  double IslandSize = 0.0;
  double IslandArea = 0.0;
  double IslandVolume = 0.0;
  double CavityVolume = 0.0;
  std::unique_ptr<Internals> Internal;
};

#endif
