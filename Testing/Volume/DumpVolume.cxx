// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DumpVolume.cxx
 * @brief What the readers find in a volume: a description on the standard output, the voxels in a file.
 *
 *     bonedecimate-dump-volume VOLUME VOXELS [X Y Z]     spacing in mm
 *
 * Testing/Volume/formats_test.py compares it with what other programs wrote.
 */
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

using namespace bonedecimate;

namespace
{
nlohmann::ordered_json SegmentsOf(vtkFieldData* fields)
{
  nlohmann::ordered_json segments = nlohmann::ordered_json::array();
  vtkDataArray* const values = fields->GetArray("LabelValues");
  auto* const names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("LabelNames"));
  vtkDataArray* const colors = fields->GetArray("LabelColors");
  for (vtkIdType i = 0; values && names && colors && i < values->GetNumberOfTuples(); ++i)
  {
    const double* const color = colors->GetTuple(i);
    segments.push_back({ { "label", static_cast<std::int64_t>(values->GetComponent(i, 0)) },
      { "name", std::string(names->GetValue(i)) }, { "color", { color[0], color[1], color[2] } } });
  }
  return segments;
}

nlohmann::ordered_json DescriptionOf(const volume::Volume& read)
{
  nlohmann::ordered_json description;
  description["problem"] = read.Problem;
  description["note"] = read.Note;
  if (read.Image)
  {
    const int* size = read.Image->GetDimensions();
    description["size"] = { size[0], size[1], size[2] };
    description["type"] = read.Image->GetScalarTypeAsString();
    description["origin"] = read.Geometry.Origin;
    description["steps"] = read.Geometry.Steps;
    description["layers"] = read.Layers; // in steps; empty: evenly spaced
    description["segments"] = SegmentsOf(read.Image->GetFieldData());
  }
  return description;
}
}

int main(int argc, char** argv)
{
  if (argc != 3 && argc != 6)
  {
    return EXIT_FAILURE;
  }
  VoxelSpacing spacing;
  if (argc == 6)
  {
    spacing = { { std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5]) } };
  }
  const volume::Volume read = volume::ReadVolume(argv[1], spacing);
  std::cout << DescriptionOf(read).dump() << "\n";
  if (read.Image)
  {
    const auto bytes =
      static_cast<std::streamsize>(read.Image->GetNumberOfPoints()) * read.Image->GetScalarSize();
    std::ofstream(argv[2], std::ios::binary)
      .write(static_cast<const char*>(read.Image->GetScalarPointer()), bytes);
  }
  return EXIT_SUCCESS;
}
