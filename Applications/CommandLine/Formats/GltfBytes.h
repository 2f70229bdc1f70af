// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GltfBytes.h
 * @brief From bytes of a glTF document to numbers.
 */
#ifndef BoneDecimate_Applications_GltfBytes_h
#define BoneDecimate_Applications_GltfBytes_h

#include <cstddef>
#include <string>
#include <string_view>

namespace bonedecimate
{
/// The bytes of a text in Base64, which ends at the first other character.
std::string BytesOfBase64(std::string_view text);

/// A type of components of accessors.
struct ComponentRow
{
  int Type;
  std::size_t Bytes;
  double (*Read)(const char* bytes);
  double Most; ///< Divides normalized numbers.
};

/// The row of a componentType; null: there is none.
const ComponentRow* FindComponent(int type);
}

#endif
