// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CountText.h
 * @brief Counts in sentences.
 */
#ifndef BoneDecimate_Applications_CountText_h
#define BoneDecimate_Applications_CountText_h

#include "NumberText.h"
#include "ReportFields.h"

#include <cstdint>
#include <string>

namespace bonedecimate
{
/// "1 voxel", "1,200 voxels". @param noun In the singular; its plural ends in s.
inline std::string CountText(std::int64_t count, const std::string& noun)
{
  return GroupedText(static_cast<double>(count)) + " " + noun + (count == 1 ? "" : "s");
}

/// An entry of a report that is a number of things; one that is missing is "0".
inline std::string CountText(const ReportFields& report, const std::string& name)
{
  return GroupedText(report.Number(name).value_or(0.0));
}

/// "there is 1 file", "there are 2 files"
inline std::string ThereAreText(std::size_t count, const std::string& noun)
{
  return (count == 1 ? "there is " : "there are ") +
    CountText(static_cast<std::int64_t>(count), noun);
}
}

#endif
