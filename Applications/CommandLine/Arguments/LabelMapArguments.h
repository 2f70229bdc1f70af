// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelMapArguments.h
 * @brief A label map on the command line, and the options of smoothing and voxels for commands
 * whose options are not those of the table.
 */
#ifndef BoneDecimate_Applications_LabelMapArguments_h
#define BoneDecimate_Applications_LabelMapArguments_h

#include "CliForward.h"
#include "LabelMaps/SegmentSelection.h"
#include "VoxelSpacing.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class vtkBoneDecimateAlgorithm;

namespace bonedecimate
{
struct LabelMapFile
{
  std::string Path; ///< Empty: none.
  /// What a surface without labels encloses; 0: the only label of the map that is not 0.
  std::int64_t Label = 0;
  std::vector<double> Spacing; ///< mm, of TIFF files; empty, one or three numbers.

  std::string Series; ///< Series of a folder of DICOM files; empty: the largest.

  VoxelSpacing GetSpacing() const;
};

/// Adds an option that takes a label map, --label, --spacing and --series.
/// @param flags Flags of the option for the map.
void AddLabelMap(CLI::App& app, LabelMapFile& map, const char* flags, const char* help);

/// Requires that --label is given only with a map.
/// @param flag Flag of the map. @throws Failure(ExitCode::Usage)
void CheckLabel(const LabelMapFile& map, const std::string& flag);

/// Requires that --spacing is given only with a map or input that needs it.
/// @param inputs Inputs that are read with the spacing, too.
/// @throws Failure(ExitCode::Usage)
void CheckSpacing(const LabelMapFile& map, const std::vector<std::string>& inputs = {});

/// Requires that --series is given only with a map or input that needs it.
void CheckSeries(const LabelMapFile& map, const std::vector<std::string>& inputs = {});

/// Reads a label map. @throws Failure(ExitCode::InputRejected)
vtkSmartPointer<vtkImageData> ReadLabels(const std::string& path,
  std::vector<std::string>& warnings, const VoxelSpacing& spacing,
  const SegmentSelection& selection = {});

/// Gives a filter its label map, if there is one. @throws Failure(ExitCode::InputRejected)
void ApplyLabelMap(
  const LabelMapFile& map, vtkBoneDecimateAlgorithm* filter, std::vector<std::string>& warnings);

struct VoxelArguments
{
  /// Names and texts of options of the table.
  std::vector<std::pair<std::string, std::string>> Options;
  LabelMapFile Map;
};

/// Adds --smooth, --feature-angle, --keep-voxels, --label-map and --label.
void AddVoxelArguments(CLI::App& app, VoxelArguments& arguments);

void ApplyVoxelArguments(const VoxelArguments& arguments, vtkBoneDecimateAlgorithm* filter,
  std::vector<std::string>& warnings);
}

#endif
