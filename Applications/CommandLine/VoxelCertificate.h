// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelCertificate.h
 * @brief The part of bonedecimate certify that compares the voxels of a surface with a label map.
 */
#ifndef BoneDecimate_Applications_VoxelCertificate_h
#define BoneDecimate_Applications_VoxelCertificate_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

class vtkBoneVoxelCheck;
class vtkImageData;

namespace bonedecimate
{
struct VoxelRequest
{
  std::string Map; ///< A file; empty: no voxels are compared.
  std::optional<double>
    Label; ///< What a surface without labels encloses; none: the only label of the map.
};

/// Adds --label.
void AddLabel(CLI::App& app, std::optional<double>& label);

/// Reads a label map. @throws Failure(ExitCode::InputRejected)
vtkSmartPointer<vtkImageData> ReadLabels(
  const std::string& path, std::vector<std::string>& warnings);

class VoxelCertificate
{
public:
  VoxelCertificate();
  ~VoxelCertificate();

  /// @param file That of the surface, for messages. @throws Failure(ExitCode::InputRejected)
  void Compare(vtkPolyData* surface, const std::string& file, const VoxelRequest& request,
    int threads, std::vector<std::string>& warnings);

  bool IsViolated() const;
  /// As the report of a decimation has it.
  nlohmann::ordered_json Json() const;
  void Print() const;

private:
  vtkSmartPointer<vtkBoneVoxelCheck> Check;
};
}

#endif
