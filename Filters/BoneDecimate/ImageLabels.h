// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageLabels.h
 * @brief The labels of a vtkImageData in the core's form.
 */
#ifndef ImageLabels_h
#define ImageLabels_h

#include "Labels/LabelMap/LabelImage.h"
#include "Labels/ModelGrid/ModelGrid.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>

class vtkDataArray;
class vtkImageData;
class vtkInformation;

namespace bonedecimate
{
struct ImageLabels
{
  LabelImage Image;
  /// Holds the labels: the image's array, or its values as integers.
  vtkSmartPointer<vtkDataArray> Array;
  std::string Problem; ///< One sentence; empty if the image has labels.
};

/// @param array Array of the image; may be null.
/// @param association One of vtkDataObject::FieldAssociations: points or cells.
ImageLabels ReadImageLabels(vtkImageData* image, vtkDataArray* array, int association);

/// The array of an image that has no active scalars but one array, for a filter that looked for the
/// labels and found none. Null if there are several, or if the filter looks for a name.
/// @param choice What it looks for; null: active scalars.  @param association Receives that of the
///   array.
vtkDataArray* OnlyArray(vtkImageData* image, vtkInformation* choice, int& association);

struct ModelLabels
{
  ImageLabels Labels;         ///< The model's map; without labels if no grid was found.
  std::string Sentence;       ///< What was found.
  double Chance = 1.0;        ///< ModelGrid::Chance
  std::int64_t Different = 0; ///< ModelGrid::Different

  bool AreFound() const { return this->Labels.Image.Labels != nullptr; }
};

/// The map of the network from which the labels were copied.
ModelLabels FindModelLabels(const ImageLabels& labels, const ModelGridRequest& request);

/// The same for the active scalars of an image; null if no grid was found. Field data is passed.
vtkSmartPointer<vtkImageData> MakeModelImage(vtkImageData* image, const ModelLabels& model);

/// The active scalars of the points, or else of the cells, or else the only array.
ImageLabels ReadActiveLabels(vtkImageData* image);

/// Whether all voxels have the same centers, up to rounding.
bool AreSameGrids(const VoxelGrid& a, const VoxelGrid& b);

/// The labels on the grid of a surface that was extracted from them: if that is not the grid of
/// the labels, those of the model. Without labels if it is the grid of neither.
ModelLabels FindLabelsOnGrid(const ImageLabels& labels, const VoxelGrid& grid, int threads);

/// Requests all of the image, whatever part the consumer requests.
void RequestWholeImage(vtkInformation* input);

/// Whether the pipeline has all of the image.
bool IsWholeImage(vtkImageData* image, vtkInformation* input);
}

#endif
