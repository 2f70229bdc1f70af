// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChecksumRuns.h
 * @brief The shapes and options of the table of checksums, and the checksum of a run.
 */
#ifndef BoneDecimate_Testing_ChecksumRuns_h
#define BoneDecimate_Testing_ChecksumRuns_h

#include "Options/Options.h"
#include "Shapes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
/// What a run gets beside its options.
enum class ChecksumInputs
{
  None,
  Origins,    ///< The result also gives its origins on the input.
  Tolerances, ///< At each point, from 0 to the largest error.
  Labels,     ///< Two, divided by a plane through the middle of the bounding box.
  Log,        ///< The log of edits is part of the checksum.
  Reference   ///< The input is a result itself.
};

struct ChecksumCase
{
  std::string Name;
  bonedecimate::Options Options;
  ChecksumInputs Inputs = ChecksumInputs::None;
};

/// All shapes of the tests, and one far from the origin.
std::vector<NamedSurface> ShapesOfChecksums();
/// Large enough to be swept in blocks.
NamedSurface LargeShapeOfChecksums();
/// Errors are relative to the diagonal of the bounding box of the surface.
std::vector<ChecksumCase> CasesOfShapes(const Surface& surface);
/// Fewer, for surfaces of 10^5 triangles.
std::vector<ChecksumCase> CasesOfLarge(const Surface& surface);

/// FNV-1a of the result: points, triangles, all arrays, counts of the report, log.
std::uint64_t ChecksumOfRun(const Surface& surface, const ChecksumCase& one, Mode mode);
}

#endif
