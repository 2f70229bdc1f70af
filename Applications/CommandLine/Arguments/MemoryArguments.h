// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MemoryArguments.h
 * @brief --memory: the memory of a run, and the slabs in which a volume has to be processed to stay
 * within it.
 */
#ifndef BoneDecimate_Applications_MemoryArguments_h
#define BoneDecimate_Applications_MemoryArguments_h

#include "CliForward.h"
#include "Runs/SlabSource.h"

#include <cstdint>
#include <optional>
#include <string>

namespace bonedecimate
{
struct Arguments;

/// "4G": a number of KiB, MiB, GiB or TiB; nothing if the text is none. @returns Bytes.
std::optional<std::int64_t> ParseMemory(const std::string& text);

/// "512 MiB", rounded up.
std::string MiBText(std::int64_t bytes);

/// Adds --memory, and --memory-limit.
void AddMemory(CLI::App& app, Arguments& arguments);
void AddMemoryLimit(CLI::App& app, Arguments& arguments);

/// @throws Failure(ExitCode::Usage) for options that a run in slabs does not have.
void CheckMemory(const Arguments& arguments);

/// How a volume is processed within a memory.
struct SlabPlan
{
  bool IsWhole = true;         ///< Slabs are not needed.
  std::int64_t Triangles = 0;  ///< At most, of a slab.
  std::int64_t VoxelBytes = 0; ///< At most, of a slab.
  std::string Problem;         ///< Why the memory does not suffice; empty if it does.
};

/// @param memory Bytes.
SlabPlan PlanSlabs(const SlabSource::Extent& volume, std::int64_t memory);
}

#endif
