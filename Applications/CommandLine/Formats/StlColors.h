// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StlColors.h
 * @brief Colors in the two bytes that follow each triangle of a binary STL file, 5 bits a channel.
 *
 *     VisCAM, SolidView     blue in the lowest bits; bit 15 set: a color
 *     Magics                the header has "COLOR=" with four bytes, red, green, blue and alpha,
 *                           for all; red in the lowest bits;
 *                           bit 15 not set: a color of its own
 *
 * They become the cell array RGB, three bytes. Triangles without a color have that of the header,
 * or are white.
 */
#ifndef BoneDecimate_Applications_StlColors_h
#define BoneDecimate_Applications_StlColors_h

#include "vtkPolyData.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bonedecimate
{
class StlColors
{
public:
  explicit StlColors(std::string_view header);

  /// The bytes of the next triangle.
  void Add(std::uint16_t attribute)
  {
    this->HasValues = this->HasValues || attribute != 0;
    this->HasColors = this->HasColors || (attribute & Flag) != 0;
    this->Attributes.push_back(attribute);
  }

  /// A warning if there are bytes that are no colors.
  void AddTo(vtkPolyData* surface, std::vector<std::string>& warnings) const;

private:
  static constexpr std::uint16_t Flag = 0x8000;
  using Color = std::array<unsigned char, 3>;
  Color ColorOf(std::uint16_t attribute) const;

  bool IsMagics = false;
  Color OfAll = { 255, 255, 255 };
  bool HasValues = false;
  bool HasColors = false; // with the flag
  std::vector<std::uint16_t> Attributes;
};
}

#endif
