// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayeredVolume.h"

#include "LabelMaps/LabelFields.h"

#include "vtkDataArray.h"

#include <cstring>

namespace bonedecimate::volume
{
std::size_t VolumeHeader::BytesInALayer() const
{
  return static_cast<std::size_t>(this->Size[0] * this->Size[1]) *
    static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(this->ScalarType));
}

LayeredVolume RejectedLayers(const std::string& problem)
{
  LayeredVolume rejected;
  rejected.Header.Problem = problem;
  return rejected;
}

LayeredVolume LayersOf(const Volume& volume)
{
  LayeredVolume layers;
  layers.Header.Geometry = volume.Geometry;
  layers.Header.Layers = volume.Layers;
  layers.Header.Problem = volume.Problem;
  layers.Header.Note = volume.Note;
  layers.Header.Remark = volume.Remark;
  layers.Header.IsReadWhole = true;
  if (!volume.Problem.empty())
  {
    return layers;
  }
  const int* size = volume.Image->GetDimensions();
  layers.Header.Size = { { size[0], size[1], size[2] } };
  layers.Header.ScalarType = volume.Image->GetScalarType();
  CopyLabelFields(volume.Image->GetFieldData(), layers.Header.Fields);
  layers.ReadLayer = [image = volume.Image, bytes = layers.Header.BytesInALayer(),
                       layer = std::size_t(0)](void* values) mutable
  {
    std::memcpy(
      values, static_cast<const char*>(image->GetScalarPointer()) + layer++ * bytes, bytes);
    return std::string();
  };
  return layers;
}
}
