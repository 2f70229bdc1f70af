// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TunnelOperation.h
 * @brief Closes narrow tunnels before a run.
 *
 *     closed = CloseTunnels(input)       plugs in place of bands of triangles; nothing else changes
 *     result = run(closed)                errors, distances and proof refer to the closed surface
 *     origins of the result               as ids of the input; on plugs the nearest ones
 *
 * Documentation/how-to/tunnels.md says what this means for the error.
 */
#ifndef BoneDecimate_Core_Run_TunnelOperation_h
#define BoneDecimate_Core_Run_TunnelOperation_h

#include "InputOperation.h"

#include <memory>

namespace bonedecimate
{
std::unique_ptr<InputOperation> MakeTunnelOperation();
}

#endif
