// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VtiVolume.h"

#include "FilePath.h"
#include "LabelMaps/LabelFields.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace bonedecimate::volume
{
namespace
{
/// Keeps VTK's errors from the terminal and remembers that there was one.
class ErrorListener
{
public:
  explicit ErrorListener(vtkXMLReader* reader)
  {
    this->Command->SetClientData(&this->HasError);
    this->Command->SetCallback(&ErrorListener::Note);
    reader->AddObserver("ErrorEvent", this->Command);
    reader->AddObserver("WarningEvent", this->Command);
    reader->SetReaderErrorObserver(this->Command);
    reader->SetParserErrorObserver(this->Command);
  }

  bool HasError = false;

private:
  static void Note(vtkObject*, unsigned long event, void* hasError, void*)
  {
    if (event == vtkCommand::ErrorEvent)
    {
      *static_cast<bool*>(hasError) = true;
    }
  }

  vtkNew<vtkCallbackCommand> Command;
};

std::string AnnouncedSizeProblem(vtkXMLImageDataReader* reader)
{
  int extent[6];
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  std::array<std::int64_t, 3> size;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size[axis] = std::int64_t(extent[2 * axis + 1]) - extent[2 * axis] + 1;
  }
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(FilePath(reader->GetFileName()), error);
  return SizeProblem(size, 1, error ? 0 : bytes, true);
}

/// The active scalars, or the only array there is.
vtkDataArray* Scalars(vtkImageData* image)
{
  vtkPointData* data = image->GetPointData();
  return data->GetScalars() || data->GetNumberOfArrays() != 1 ? data->GetScalars()
                                                              : data->GetArray(0);
}

VolumeGeometry Geometry(vtkImageData* image)
{
  VolumeGeometry geometry;
  const int* extent = image->GetExtent();
  for (int i = 0; i < 3; ++i)
  {
    geometry.Origin[i] = image->GetOrigin()[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      geometry.Steps[axis][i] =
        image->GetDirectionMatrix()->GetElement(i, axis) * image->GetSpacing()[axis];
      // The first voxel is that of the extent's lower corner, the origin that of index zero.
      geometry.Origin[i] += geometry.Steps[axis][i] * extent[2 * axis];
    }
  }
  return geometry;
}

/// Positions of layers as vtkBoneSurfaces takes them, in mm from the first one; empty without.
LayerPositions ReadLayers(vtkImageData* image, const VolumeGeometry& geometry)
{
  vtkDataArray* const positions = image->GetFieldData()->GetArray("VoxelGridLayers");
  LayerPositions layers;
  for (vtkIdType k = 0; positions && k < positions->GetNumberOfTuples(); ++k)
  {
    layers.push_back(positions->GetComponent(k, 0) / Length(geometry.Steps[2]));
  }
  return layers;
}

std::string LayersProblem(const LayerPositions& layers, vtkImageData* image)
{
  const bool areThere =
    layers.empty() || layers.size() == static_cast<std::size_t>(image->GetDimensions()[2]);
  const bool areAscending = layers.empty() ||
    (layers.front() == 0.0 && std::isfinite(layers.back()) &&
      std::adjacent_find(
        layers.begin(), layers.end(), [](double a, double b) { return !(b > a); }) == layers.end());
  return areThere && areAscending
    ? std::string()
    : "its array VoxelGridLayers has no position for each of its layers that ascends from 0";
}
}

bool VtiHasSpacing(const std::string& path)
{
  constexpr std::streamsize most = 1 << 16;
  std::ifstream file(path, std::ios::binary);
  std::string head(static_cast<std::size_t>(most), '\0');
  file.read(head.data(), most);
  const std::size_t tag = head.find("<ImageData");
  return tag == std::string::npos || // which is a problem of its own
    head.substr(tag, head.find('>', tag) - tag).find("Spacing") != std::string::npos;
}

Volume ReadVti(const std::string& path)
{
  vtkNew<vtkXMLImageDataReader> reader;
  const ErrorListener listener(reader);
  reader->SetFileName(path.c_str());
  if (!reader->CanReadFile(path.c_str()))
  {
    return RejectedVolume("it is not a VTK image file");
  }
  reader->UpdateInformation();
  const std::string sizeProblem = listener.HasError ? std::string() : AnnouncedSizeProblem(reader);
  if (!sizeProblem.empty())
  {
    return RejectedVolume(sizeProblem);
  }
  if (!listener.HasError)
  {
    reader->Update();
  }
  if (listener.HasError)
  {
    return RejectedVolume("it is truncated or damaged");
  }
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* scalars = Scalars(image);
  if (!scalars || scalars->GetNumberOfComponents() != 1 ||
    scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return RejectedVolume("it has no array of one value a voxel");
  }
  if (scalars->GetDataType() == VTK_BIT)
  {
    return RejectedVolume("its voxels are single bits; save them as unsigned char");
  }
  Volume volume;
  volume.Geometry = Geometry(image);
  volume.Layers = ReadLayers(image, volume.Geometry);
  volume.Problem = GeometryProblem(volume.Geometry);
  volume.Problem = volume.Problem.empty() ? LayersProblem(volume.Layers, image) : volume.Problem;
  volume.Image = vtkSmartPointer<vtkImageData>::New();
  volume.Image->SetDimensions(image->GetDimensions());
  volume.Image->GetPointData()->SetScalars(scalars);
  CopyLabelFields(image->GetFieldData(), volume.Image->GetFieldData());
  return volume;
}
}
