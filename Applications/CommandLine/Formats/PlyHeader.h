// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlyHeader.h
 * @brief What a PLY file announces, checked against the size of the file.
 */
#ifndef BoneDecimate_Applications_PlyHeader_h
#define BoneDecimate_Applications_PlyHeader_h

#include "LineReader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
struct PlyProperty
{
  std::string Name;
  int Type = 0;           ///< Type of the value, or of one entry of a list: VTK_FLOAT and so on.
  int CountType = 0;      ///< Type of the count of a list; VTK_VOID if it is no list.
  bool IsCorners = false; ///< Whether it is the list of a face's vertices.

  bool IsList() const;
};

struct PlyElement
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<PlyProperty> Properties;

  /// Index of the first property of that name; the number of properties if there is none.
  std::size_t IndexOf(const std::string& name) const;

  /// Whether there is a property of that name that is no list.
  bool HasScalar(const std::string& name) const;
};

struct PlyHeader
{
  bool IsText = false;
  bool IsBigEndian = false;
  std::vector<PlyElement> Elements; ///< With a "vertex" and a "face" or "tristrips" among them.
  std::string Frame;                ///< FileFrame.h
  std::int64_t Vertices = 0;
};

/// Leaves the lines behind the header. @throws Failure(ExitCode::InputRejected)
PlyHeader ReadPlyHeader(const std::string& path, LineReader& lines);

std::size_t BytesOfPlyType(int type);
bool IsWholeNumber(int type);
}

#endif
