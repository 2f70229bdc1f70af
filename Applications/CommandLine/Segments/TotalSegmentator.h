// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TotalSegmentator.h
 * @brief Labels and names of the bones that TotalSegmentator writes.
 *
 * J. Wasserthal et al.: TotalSegmentator: Robust Segmentation of 104 Anatomic Structures in CT
 * Images. Radiology: Artificial Intelligence, 2023. Numbers and names are those of version 2, task
 * "total" (class_map in totalsegmentator/map_to_binary.py of github.com/wasserth/TotalSegmentator).
 */
#ifndef BoneDecimate_Applications_TotalSegmentator_h
#define BoneDecimate_Applications_TotalSegmentator_h

#include <cstdint>
#include <map>
#include <string>

namespace bonedecimate
{
/// Names of the bones by label; organs, vessels, muscles and cartilage are not among them.
const std::map<std::int64_t, std::string>& TotalSegmentatorBones();
}

#endif
