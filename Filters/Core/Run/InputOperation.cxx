// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputOperation.h"

#include "TunnelOperation.h"
#include "WeldOperation.h"

namespace bonedecimate
{
std::vector<std::unique_ptr<InputOperation>> InputOperations(const Options& options)
{
  std::vector<std::unique_ptr<InputOperation>> operations;
  if (options.WeldDistance > 0.0)
  {
    operations.push_back(MakeWeldOperation());
  }
  if (options.TunnelSize > 0.0)
  {
    operations.push_back(MakeTunnelOperation());
  }
  return operations;
}
}
