// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunInput.h
 * @brief The input of a run of vtkBoneDecimate as the core takes it.
 */
#ifndef RunInput_h
#define RunInput_h

#include "DecimateInternals.h"
#include "LabelMapOfRun.h"
#include "Run/Decimate.h"
#include "SurfaceConversion.h"

#include <optional>
#include <vector>

/// Must not be copied: Inputs refers to the other members.
struct vtkBoneDecimate::Internals::RunInput
{
  bonedecimate::ConvertedSurface Converted;
  bonedecimate::ConvertedSurface Reference;
  /// mm, of each point; nothing: the array does not suit.
  std::optional<std::vector<double>> Tolerances;
  /// mm, of each point; nothing: none is named, or the array does not suit.
  std::optional<std::vector<double>> EdgeLengths;
  /// Labels of the triangles; nothing: the array does not suit.
  std::optional<bonedecimate::Labels> Labels;
  bonedecimate::LabelMapOfRun Map;
  std::shared_ptr<bonedecimate::RegionCache> Prepared; ///< Null: nothing is to be kept.
  bonedecimate::RunInputs Inputs;
};

/// Must not be copied: Part refers to the other members.
struct vtkBoneDecimate::Internals::PartOfSurface
{
  bonedecimate::SurfacePart Part;
  bonedecimate::Surface Neighbors;
  bonedecimate::ConvertedSurface Original;
  bonedecimate::LabelMapSource LabelsOfOriginal;
  std::optional<bonedecimate::Labels> PatchesOfOriginal;
};

#endif
