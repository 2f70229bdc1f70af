// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ItkImage.h"

#include "DataFile.h"

#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkTIFFImageIO.h>

namespace bonedecimate::volume
{
namespace
{
int ScalarTypeOf(itk::IOComponentEnum type)
{
  switch (type)
  {
    case itk::IOComponentEnum::UCHAR:
      return VTK_UNSIGNED_CHAR;
    case itk::IOComponentEnum::CHAR:
      return VTK_SIGNED_CHAR;
    case itk::IOComponentEnum::USHORT:
      return VTK_UNSIGNED_SHORT;
    case itk::IOComponentEnum::SHORT:
      return VTK_SHORT;
    case itk::IOComponentEnum::UINT:
      return VTK_UNSIGNED_INT;
    case itk::IOComponentEnum::INT:
      return VTK_INT;
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::ULONGLONG:
      return VTK_UNSIGNED_LONG_LONG;
    case itk::IOComponentEnum::LONG:
    case itk::IOComponentEnum::LONGLONG:
      return VTK_LONG_LONG;
    case itk::IOComponentEnum::FLOAT:
      return VTK_FLOAT;
    case itk::IOComponentEnum::DOUBLE:
      return VTK_DOUBLE;
    default:
      return VTK_VOID;
  }
}

itk::ImageIOBase::Pointer ReaderOf(ItkImage::Format format)
{
  switch (format)
  {
    case ItkImage::Format::Nifti:
    {
      const auto nifti = itk::NiftiImageIO::New();
      // The format before NIfTI has no position.
      nifti->SetLegacyAnalyze75Mode(itk::NiftiImageIOEnums::Analyze75Flavor::AnalyzeReject);
#if ITK_VERSION_MAJOR > 5 || ITK_VERSION_MINOR >= 4
      // It would turn axes until they are perpendicular; a variable of the environment sets it.
      nifti->SFORM_PermissiveOff();
#endif
      return nifti.GetPointer();
    }
    case ItkImage::Format::Nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case ItkImage::Format::Tiff:
      return itk::TIFFImageIO::New().GetPointer();
    default:
      return itk::MetaImageIO::New().GetPointer();
  }
}
}

struct ItkImage::Internals
{
  itk::ImageIOBase::Pointer Reader;
};

ItkImage::ItkImage(Format format, const std::string& path, int dimensions)
  : Internal(new Internals{ ReaderOf(format) })
{
  itk::ImageIOBase& reader = *this->Internal->Reader;
  if (format == Format::Nifti && !reader.CanReadFile(path.c_str()))
  {
    this->Header.Problem = "it is not a NIfTI file";
    return;
  }
  try
  {
    reader.SetFileName(path);
    reader.ReadImageInformation();
    this->Header.Problem = this->ReadSize(dimensions);
  }
  catch (const itk::ExceptionObject& exception)
  {
    this->Header.HasGeometry =
      std::string(exception.GetDescription()).find("orthonormal") == std::string::npos;
    this->Header.Problem = this->Header.HasGeometry
      ? "its header is damaged or of a kind that is not read"
      : this->ReadSize(dimensions);
  }
}

ItkImage::~ItkImage() = default;

std::string ItkImage::ReadSize(int dimensions)
{
  const itk::ImageIOBase& reader = *this->Internal->Reader;
  this->Header.ScalarType = ScalarTypeOf(reader.GetComponentType());
  this->Header.Components = static_cast<int>(reader.GetNumberOfComponents());
  this->Header.IsText = reader.GetFileType() == itk::IOFileEnum::ASCII;
  this->Header.HasLayers = reader.GetPixelType() == itk::IOPixelEnum::VECTOR;
  if (reader.GetNumberOfDimensions() != static_cast<unsigned int>(dimensions))
  {
    return "it has " + std::to_string(reader.GetNumberOfDimensions()) + " dimensions, only " +
      (dimensions == 3 ? "volumes of three" : "slices of two") + " are read";
  }
  if (this->Header.ScalarType == VTK_VOID)
  {
    return "the type of its voxels is not read; save them as numbers of 8, 16, 32 or 64 bits";
  }
  for (unsigned int axis = 0; axis < reader.GetNumberOfDimensions(); ++axis)
  {
    this->Header.Size[axis] = static_cast<std::int64_t>(reader.GetDimensions(axis));
  }
  return dimensions == 3 && this->Header.HasGeometry ? this->ReadGeometry() : std::string();
}

std::string ItkImage::ReadGeometry()
{
  const itk::ImageIOBase& reader = *this->Internal->Reader;
  VolumeGeometry& geometry = this->Header.Geometry;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> direction = reader.GetDirection(axis);
    geometry.Origin[axis] = reader.GetOrigin(axis);
    for (unsigned int i = 0; i < 3; ++i)
    {
      geometry.Steps[axis][i] = reader.GetSpacing(axis) * direction[i];
    }
    if (reader.GetSpacing(axis) <= 0.0)
    {
      return "its spacing is zero or negative";
    }
  }
  return GeometryProblem(geometry);
}

std::string ItkImage::GetText(const std::string& key) const
{
  std::string text;
  itk::ExposeMetaData<std::string>(this->Internal->Reader->GetMetaDataDictionary(), key, text);
  return text;
}

bool ItkImage::ReadVoxels(void* values)
{
  itk::ImageIOBase& reader = *this->Internal->Reader;
  itk::ImageIORegion region(reader.GetNumberOfDimensions());
  for (unsigned int axis = 0; axis < reader.GetNumberOfDimensions(); ++axis)
  {
    region.SetIndex(axis, 0);
    region.SetSize(axis, static_cast<itk::SizeValueType>(this->Header.Size[axis]));
  }
  try
  {
    reader.SetIORegion(region);
    reader.Read(values);
  }
  catch (const itk::ExceptionObject&)
  {
    return false;
  }
  return true;
}

Volume ItkImage::ReadVolume()
{
  Volume volume;
  volume.Geometry = this->Header.Geometry;
  volume.Image = AllocateImage(this->Header.Size, this->Header.ScalarType, this->Header.Components);
  return this->ReadVoxels(volume.Image->GetScalarPointer()) ? volume
                                                            : RejectedVolume(DamagedVoxels);
}
}
