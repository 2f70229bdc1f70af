// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GltfJson.h
 * @brief Parses JSON whose memory is estimated before it is taken.
 */
#ifndef BoneDecimate_Applications_GltfJson_h
#define BoneDecimate_Applications_GltfJson_h

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

namespace bonedecimate
{
/// Whether the parsed text would take at most so many bytes, as far as it can be parsed.
bool FitsJson(std::string_view text, std::size_t mostBytes);
}

#endif
