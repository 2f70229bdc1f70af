// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageLabels.h
 * @brief The labels of a vtkImageData in the core's form.
 */
#ifndef ImageLabels_h
#define ImageLabels_h

#include "Labels/LabelMap/LabelImage.h"

#include "vtkSmartPointer.h"

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

/// Requests all of the image, whatever part the consumer requests.
void RequestWholeImage(vtkInformation* input);

/// Whether the pipeline has all of the image.
bool IsWholeImage(vtkImageData* image, vtkInformation* input);
}

#endif
