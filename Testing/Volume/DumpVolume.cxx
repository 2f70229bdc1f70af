// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DumpVolume.cxx
 * @brief What the readers find in a volume: a description on the standard output, the voxels in a
 * file.
 *
 *     bonedecimate-dump-volume VOLUME VOXELS [X Y Z]     spacing in mm
 *     bonedecimate-dump-volume < LIST
 *
 * A line of the list is VOLUME VOXELS [X Y Z], with tabs between them; each gets a line of output.
 *
 * Testing/Volume/formats_test.py and Testing/Formats/Volumes compare it with what other programs
 * wrote and read.
 */
#include "LabelMaps/LabelVolume.h"
#include "LabelMaps/WholeLabels.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

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

/// As a label map, after the voxels were written: labels are rounded.
nlohmann::ordered_json LabelsOf(const volume::Volume& read)
{
  const volume::VolumeGeometry& geometry = read.Geometry;
  nlohmann::ordered_json labels;
  labels["values"] = volume::MakeWholeLabels(read.Image).Problem;
  SetLabelGrid(geometry, read.Layers, read.Image);
  nlohmann::ordered_json steps = nlohmann::ordered_json::array();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = read.Image->GetSpacing()[axis];
    vtkMatrix3x3* const direction = read.Image->GetDirectionMatrix();
    steps.push_back({ direction->GetElement(0, axis) * spacing,
      direction->GetElement(1, axis) * spacing, direction->GetElement(2, axis) * spacing });
  }
  labels["steps"] = steps;
  return labels;
}

void WriteVoxels(vtkImageData* image, const std::string& path)
{
  const auto bytes =
    static_cast<std::streamsize>(image->GetNumberOfPoints()) * image->GetScalarSize();
  std::ofstream(path, std::ios::binary)
    .write(static_cast<const char*>(image->GetScalarPointer()), bytes);
}

/// Writes the voxels, returns the description.
nlohmann::ordered_json Dump(
  const std::string& path, const std::string& voxels, const VoxelSpacing& spacing)
{
  const volume::Volume read = volume::ReadVolume(path, spacing);
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
    WriteVoxels(read.Image, voxels);
    description["labels"] = LabelsOf(read);
  }
  return description;
}

void Print(const nlohmann::ordered_json& description)
{
  // Names of any bytes.
  std::cout << description.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace)
            << std::endl;
}

VoxelSpacing SpacingOf(const std::vector<std::string>& words)
{
  return words.size() < 5 ? VoxelSpacing()
                          : VoxelSpacing({ { std::atof(words[2].c_str()),
                              std::atof(words[3].c_str()), std::atof(words[4].c_str()) } });
}

void DumpList()
{
  std::string line;
  while (std::getline(std::cin, line))
  {
    std::vector<std::string> words;
    std::istringstream text(line);
    for (std::string word; std::getline(text, word, '\t');)
    {
      words.push_back(word);
    }
    Print(Dump(words.at(0), words.at(1), SpacingOf(words)));
  }
}
}

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty())
  {
    DumpList();
    return EXIT_SUCCESS;
  }
  if (words.size() != 2 && words.size() != 5)
  {
    return EXIT_FAILURE;
  }
  Print(Dump(words[0], words[1], SpacingOf(words)));
  return EXIT_SUCCESS;
}
