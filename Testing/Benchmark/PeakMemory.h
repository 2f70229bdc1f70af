// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BoneDecimate_Testing_PeakMemory_h
#define BoneDecimate_Testing_PeakMemory_h

#include <cstdint>

/// What this process holds and held at most, in bytes, as Linux counts resident pages; 0 on other
/// systems.
namespace memory
{
/// Gives freed pages back first, so that what an earlier step freed is not reused unseen.
std::int64_t Held();
/// From here on Peak() means the most since now.
void ForgetPeak();
std::int64_t Peak();
}

#endif
