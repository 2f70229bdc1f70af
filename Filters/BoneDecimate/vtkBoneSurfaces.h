// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneSurfaces
 * @brief  extract the surfaces of all labels of a label map, with each wall between two labels once
 *
 * The input is an image with an integer label for each voxel (floating-point numbers without a
 * fraction are accepted), in mm. The output has the surfaces of all labels together as one set of
 * triangles: neighbors have their walls in common, without gaps and overlaps. Its points are the
 * midpoints between voxel centers of different labels, as in marching cubes, and a few more where
 * three or more labels meet. The surface of each label is closed, and voxelized again every voxel
 * has the label it had.
 *
 * Output arrays:
 * - cell array BoundaryLabels: the labels on both sides of a triangle; the normal points from the
 *   first to the second. The first is the smaller, and the background is the second of any label,
 *   so normals point out of the bone.
 * - point array GridPoint: twice the coordinates, in voxels, of the middle of the grid edge, face
 *   or cell of the point.
 * - field arrays VoxelGridOrigin, VoxelGridSpacing, VoxelGridDirection, VoxelGridDimensions: the
 *   grid of the image. If the image has the field array VoxelGridLayers (mm along the third axis of
 *   each layer from the first one), layers are there, and the surface has the array, too.
 *   The direction need not be orthogonal: it may be sheared, as by a tilted gantry.
 * - field array LabelValues: the labels, ascending, and at the end the background. Field arrays
 *   LabelNames and LabelColors of an image that has a LabelValues of its own are brought into this
 *   order. All other field data passes.
 *
 * SetInputArrayToProcess chooses the labels, by default the active scalars of points, or else of
 * cells, or else the only array; with those of cells, the voxels are the cells.
 *
 * The image is always processed as a whole; one that comes in pieces is an error. If several pieces
 * of the output are requested, as on several processes, each has an equal part of the triangles,
 * and points where they meet have equal coordinates.
 *
 * A value outside its range is an error event when it is set: the property keeps its value, and
 * updates fail until it gets a valid one. An image without such an array, with several components
 * or with fractions: an error, and no output.
 *
 * @sa vtkBoneDecimate vtkDiscreteFlyingEdges3D vtkSurfaceNets3D
 */
#ifndef vtkBoneSurfaces_h
#define vtkBoneSurfaces_h

#include "vtkBoneAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for rejected values

class vtkImageData;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneSurfaces : public vtkBoneAlgorithm
{
public:
  static vtkBoneSurfaces* New();
  vtkTypeMacro(vtkBoneSurfaces, vtkBoneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds a label to extract. By default there is none: then all labels are extracted. With a
   * choice, all other labels count as background.
   */
  void AddLabel(vtkTypeInt64 label);

  /**
   * Forgets all labels: all are extracted.
   */
  void RemoveAllLabels();

  /**
   * How many labels were added.
   */
  int GetNumberOfLabels() const;

  /**
   * A label that was added, 0 to GetNumberOfLabels() - 1; 0 beyond that.
   */
  vtkTypeInt64 GetLabel(int index) const;

  ///@{
  /**
   * The label of voxels that belong to nothing, default 0.
   */
  vtkSetMacro(BackgroundLabel, vtkTypeInt64);
  vtkGetMacro(BackgroundLabel, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * Close surfaces where a label touches the end of the image, half a voxel outside of the
   * outermost voxel centers, on by default. Off: they are open and end at these centers.
   */
  vtkSetMacro(Closed, bool);
  vtkGetMacro(Closed, bool);
  vtkBooleanMacro(Closed, bool);
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024; 0, the default, is one per processor. The output does not depend on
   * it.
   */
  void SetNumberOfThreads(int threads);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Precision of the output points, of vtkAlgorithm::DesiredOutputPrecision. The default,
   * DEFAULT_PRECISION, is single precision, as of VTK's contour filters.
   */
  void SetOutputPointsPrecision(int precision);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Whether the surfaces are those of the map of a network, from whose grid the labels were copied
   * to the voxels of the image: "auto", the default, if that is certain; "off"; or the spacing of
   * the network in mm, one number or three with commas in between, which is an error if the
   * labels are no copy from such a grid. The voxel grid of the output is then that of the network.
   */
  void SetModelGrid(const std::string& choice);
  std::string GetModelGrid() const;
  ///@}

  /**
   * What the last update found of the grid of a network, in one sentence; empty if the surfaces are
   * those of the voxels of the image.
   */
  std::string GetModelGridFound() const;

  /**
   * Gets the surface of one label out of surfaces of several, smoothed or decimated or not:
   * triangles with the label on one side of BoundaryLabels, with normals that point out of it.
   * Points are duplicated where the label touches itself, so that the surface is manifold. Point
   * data and cell data are copied. The output is a surface of this label and the background alone,
   * so BoundaryLabels and LabelValues have these two; the cell array OtherLabel has the label on
   * the other side of each triangle. Returns false, with an empty output, if there is no array
   * BoundaryLabels, no triangle of the label, or a point id out of range.
   */
  static bool ExtractLabel(vtkPolyData* surfaces, vtkTypeInt64 label, vtkPolyData* output);

protected:
  vtkBoneSurfaces();
  ~vtkBoneSurfaces() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneSurfaces(const vtkBoneSurfaces&) = delete;
  void operator=(const vtkBoneSurfaces&) = delete;

  struct Internals;

  bool Extract(vtkImageData* image, vtkPolyData* output, vtkInformationVector* outputVector);

  vtkTypeInt64 BackgroundLabel = 0;
  bool Closed = true;
  int NumberOfThreads = 0;
  int OutputPointsPrecision = vtkAlgorithm::DEFAULT_PRECISION;
  std::unique_ptr<Internals> Internal;
};

#endif
