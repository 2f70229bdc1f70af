// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelCertificate.h
 * @brief The part of bonedecimate certify that compares the voxels of a surface with a label map.
 */
#ifndef BoneDecimate_Applications_VoxelCertificate_h
#define BoneDecimate_Applications_VoxelCertificate_h

#include "Arguments/LabelMapArguments.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

class vtkBoneVoxelCheck;

namespace bonedecimate
{
class VoxelCertificate
{
public:
  VoxelCertificate();
  ~VoxelCertificate();

  /// @param file File of the surface, for messages. @returns False if it was stopped.
  /// @throws Failure(ExitCode::InputRejected)
  bool Compare(vtkPolyData* surface, const std::string& file, const LabelMapFile& map, int threads,
    std::vector<std::string>& warnings);

  bool IsViolated() const;
  /// The comparison as in the report of a decimation.
  nlohmann::ordered_json Json() const;
  void Print() const;

private:
  vtkSmartPointer<vtkBoneVoxelCheck> Check;
};
}

#endif
