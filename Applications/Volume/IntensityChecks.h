// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IntensityChecks.h
 * @brief Whether the voxels of a volume have a surface at a value, and what the user should know of
 * it.
 */
#ifndef BoneDecimate_Applications_IntensityChecks_h
#define BoneDecimate_Applications_IntensityChecks_h

#include "BoneVolume.h"
#include "VoxelValues.h"

#include <string>

namespace bonedecimate::volume
{
/// Why the values give no surface at that value; empty if they do.
std::string IntensityProblem(const ValueSurvey& survey, double hounsfield, LabelPolicy policy);

/// Says that the volume is a mask, whose surface has steps; empty for other volumes.
std::string MaskNote(const ValueSurvey& survey);

/// Appends the note, with a semicolon between two notes.
void AppendNote(std::string& notes, const std::string& note);

/// mm, of a voxel.
double LeastSide(const VolumeGeometry& geometry, const LayerPositions& layers = {});
}

#endif
