// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceFiles.h
 * @brief Surfaces from and to files, by VTK's readers and writers, with every doubt a failure.
 */
#ifndef BoneDecimate_Applications_SurfaceFiles_h
#define BoneDecimate_Applications_SurfaceFiles_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct SurfaceFormat;

struct LoadedSurface
{
  /// Points of STL files are not merged: the filter does it and counts.
  vtkSmartPointer<vtkPolyData> Surface;
  std::vector<std::string> Warnings;
  /// What the file says of the unit of its coordinates (FileUnit.h); empty: nothing.
  std::string Unit;
};

/// @throws Failure(ExitCode::InputRejected)
LoadedSurface ReadSurface(const std::string& path);

/**
 * Writes to a name that exists already (see StagedFile), and returns what was read back.
 * @param target The name it will get, for messages.
 * @param isCompressed In the compressed form of its format, if there is one.
 * @throws Failure(ExitCode::CouldNotWrite)
 */
vtkSmartPointer<vtkPolyData> WriteSurface(vtkPolyData* surface, const std::string& path,
  const std::string& target, bool isCompressed = false);

/// What this format cannot hold of the surface, for people; empty if it holds all of it.
/// @param isDivided Whether each label, or the only one, has a file of its own.
std::string LossText(vtkPolyData* surface, const SurfaceFormat& format, bool isDivided = false);
}

#endif
