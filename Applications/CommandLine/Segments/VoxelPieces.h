// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelPieces.h
 * @brief Small islands and cavities of a volume, which change on request before its surface is
 * extracted.
 */
#ifndef BoneDecimate_Applications_VoxelPieces_h
#define BoneDecimate_Applications_VoxelPieces_h

#include "Arguments/CliForward.h"
#include "BoneVolume.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bonedecimate
{
struct Arguments;
struct NamedLabel;

/// What changed of a label, or of the bone at a gray value.
struct ChangedPieces
{
  std::int64_t Islands = 0;
  std::int64_t IslandVoxels = 0;
  double IslandVolume = 0.0; ///< mm3
  std::int64_t Cavities = 0;
  std::int64_t CavityVoxels = 0;
  double CavityVolume = 0.0; ///< mm3
};

/// Changed pieces by label; for gray values the label is 1.
using PiecesOfLabels = std::map<std::int64_t, ChangedPieces>;

/// Adds --fill-volume.
void AddFillVolume(CLI::App& app, Arguments& arguments);

/**
 * The label map without the islands of the --prune options and with the cavities of --fill-volume
 * filled; the same one if there is nothing to do. Warns of labels whose largest piece is small,
 * too.
 */
vtkSmartPointer<vtkImageData> ChangePieces(vtkImageData* map, const std::vector<NamedLabel>& labels,
  const Arguments& arguments, PiecesOfLabels& changed, std::vector<std::string>& warnings);

/**
 * What fills the cavities of the voxels from the gray value of --iso on: they get this value, or
 * the next whole number. Empty without
 * --fill-volume.
 * @param changed Receives the counts when it is called.
 */
VoxelChange CavityFilling(const Arguments& arguments, PiecesOfLabels& changed);

/// "2 islands of 12 voxels (4.5 mm3) removed, 1 cavity of 8 voxels (3.0 mm3) filled"; empty if
/// nothing changed.
std::string ChangesText(const ChangedPieces& changed);

/// "label 2: 1 island ...", for each label; of a gray value "bone: ...".
std::vector<std::string> ChangesTexts(const PiecesOfLabels& changed, bool areLabels);

nlohmann::ordered_json JsonOfPieces(const ChangedPieces& changed);
}

#endif
