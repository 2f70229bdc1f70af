// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VtkReadersAndWriters.h
 * @brief How a format uses VTK's reader or writer.
 */
#ifndef BoneDecimate_Applications_VtkReadersAndWriters_h
#define BoneDecimate_Applications_VtkReadersAndWriters_h

#include "CoordinateCollector.h"
#include "ExitCode.h"

#include "vtkErrorCode.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace bonedecimate
{
/**
 * @param textPoints The coordinates if they are text: VTK rounds them to single precision.
 */
template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadWith(
  Reader* reader, const std::string& path, CoordinateCollector& textPoints)
{
  reader->SetFileName(path.c_str());
  reader->Update();
  const vtkSmartPointer<vtkPolyData> surface = reader->GetOutput();
  const auto points = textPoints.MakePoints();
  const bool isRounded = surface->GetPoints() && points->GetDataType() == VTK_DOUBLE &&
    surface->GetPoints()->GetDataType() != VTK_DOUBLE &&
    surface->GetPoints()->GetNumberOfPoints() == points->GetNumberOfPoints();
  if (isRounded)
  {
    surface->SetPoints(points);
  }
  return surface;
}

/// @throws Failure(ExitCode::CouldNotWrite)
template <typename Writer>
void WriteWith(Writer* writer, vtkPolyData* surface, const std::string& path)
{
  writer->SetFileName(path.c_str());
  writer->SetInputData(surface);
  writer->Write();
  const unsigned long error = writer->GetErrorCode();
  if (error != vtkErrorCode::NoError)
  {
    const bool full = error == vtkErrorCode::OutOfDiskSpaceError;
    throw Failure(ExitCode::CouldNotWrite,
      full ? "the disk is full" : vtkErrorCode::GetStringFromErrorCode(error));
  }
}
}

#endif
