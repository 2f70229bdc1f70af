// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceChecks.h
 * @brief Measurements of surfaces in the tests of volumes, and temporary folders.
 */
#ifndef BoneDecimate_Testing_SurfaceChecks_h
#define BoneDecimate_Testing_SurfaceChecks_h

#include "BoneVolume.h"

#include <string>

namespace bonedecimate::testing
{
/// A folder that the destructor removes with its content.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string File(const std::string& name) const;

private:
  std::string Path;
};

/// mm^3, positive where normals point outwards.
double EnclosedVolume(vtkPolyData* surface);

/// mm, of any point from the surface of the specimen.
double LargestDeviation(vtkPolyData* surface);

int CountComponents(vtkPolyData* surface);

/// Fails if position or orientation of the surface differ from those of the specimen.
void ExpectSpecimen(const BoneSurface& bone);

/// Fails if there is a difference in points of more than so many mm, or any in triangles.
void ExpectEqual(vtkPolyData* a, vtkPolyData* b, double tolerance);

/// Fails if the file is read, if the message does not contain these words, or if anything was
/// written to the terminal.
void ExpectRejection(const std::string& path, const std::string& words, double hounsfield = 226.0);
}

#endif
