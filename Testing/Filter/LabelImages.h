// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelImages.h
 * @brief Label maps of Testing/Support as images, and their surfaces.
 */
#ifndef BoneDecimate_Testing_LabelImages_h
#define BoneDecimate_Testing_LabelImages_h

#include "LabelMaps.h"

#include "vtkAlgorithm.h"
#include "vtkBoneSurfaces.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate::testsupport
{
/// Active scalars "Labels" of that type. The first voxel has these indices in the image.
inline vtkSmartPointer<vtkImageData> ImageOf(
  const LabelMap& map, int type = VTK_SHORT, const std::array<int, 3>& first = { 0, 0, 0 })
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  const auto& size = map.Grid.Dimensions;
  image->SetExtent(first[0], first[0] + size[0] - 1, first[1], first[1] + size[1] - 1, first[2],
    first[2] + size[2] - 1);
  VoxelGrid grid = map.Grid;
  if (grid.HasLayers())
  {
    const vtkNew<vtkDoubleArray> layers;
    layers->SetName("VoxelGridLayers");
    for (const double layer : grid.Layers)
    {
      layers->InsertNextValue(layer);
    }
    image->GetFieldData()->AddArray(layers);
    grid.Layers.clear();
  }
  grid.Origin = grid.ToMillimeters(-Vector3(first[0], first[1], first[2]));
  image->SetOrigin(grid.Origin.data());
  image->SetSpacing(grid.Spacing.data());
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      image->GetDirectionMatrix()->SetElement(row, column, grid.Direction(row, column));
    }
  }
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("Labels");
  for (const std::int32_t label : map.Labels)
  {
    array->InsertNextTuple1(label);
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

/// The first layers of an image in a pipeline that says it has all of them.
inline vtkSmartPointer<vtkTrivialProducer> PieceOf(vtkImageData* image)
{
  const auto piece = vtkSmartPointer<vtkImageData>::New();
  piece->DeepCopy(image);
  int extent[6];
  image->GetExtent(extent);
  --extent[5];
  piece->Crop(extent);
  const auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(piece);
  producer->SetWholeExtent(image->GetExtent());
  return producer;
}

/// The output of vtkBoneSurfaces with its defaults, of double precision.
inline vtkSmartPointer<vtkPolyData> Extracted(
  vtkImageData* image, int precision = vtkAlgorithm::DOUBLE_PRECISION)
{
  vtkNew<vtkBoneSurfaces> filter;
  filter->SetInputData(image);
  filter->SetOutputPointsPrecision(precision);
  filter->Update();
  return filter->GetOutput();
}

/// The normals of mirrored grids have to be turned.
inline LabelMap ObliqueEllipsoid(bool isMirrored)
{
  LabelMap map = EllipsoidLabels({ 15, 13, 12 });
  map.Grid = ObliqueGrid({ 15, 13, 12 }, isMirrored);
  return map;
}

/// Values.
inline std::vector<BoundaryLabels> LabelsOf(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetCellData()->GetArray("BoundaryLabels");
  std::vector<BoundaryLabels> labels;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    labels.push_back({ static_cast<Index>(array->GetComponent(cell, 0)),
      static_cast<Index>(array->GetComponent(cell, 1)) });
  }
  return labels;
}
}

#endif
