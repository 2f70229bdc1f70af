// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThreeMfModel.h
 * @brief Objects, components and build items of the model parts of a 3MF file, as they stand there.
 */
#ifndef BoneDecimate_Applications_ThreeMfModel_h
#define BoneDecimate_Applications_ThreeMfModel_h

#include "FileParts.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bonedecimate
{
/// A point is a row: (x y z 1) times four rows of three numbers.
struct ThreeMfTransform
{
  std::array<double, 12> Rows = { 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 };

  /// Nothing if it is not twelve numbers. An empty text is the identity.
  static std::optional<ThreeMfTransform> FromText(std::string_view text);

  std::array<double, 3> Of(const std::array<double, 3>& point) const;
  double Determinant() const;
};

/// An object that a component or a build item names.
struct ThreeMfReference
{
  std::string Path; ///< Path of the part that has the object; empty: the same part.
  std::string Object;
  ThreeMfTransform Transform;
  bool IsPrintable = true; ///< Whether a build item is printable.
};

struct ThreeMfObject
{
  std::string Type = "model";
  FilePart Mesh; ///< In units of the part.
  std::vector<ThreeMfReference> Components;
};

struct ThreeMfPart
{
  double Factor = 1.0; ///< mm of the unit
  std::map<std::string, ThreeMfObject> Objects;
  std::vector<ThreeMfReference> Build;
  bool HasBeams = false;
  bool HasSlices = false;
};

/// Takes a part in pieces. @return What is wrong with it, a sentence; empty: nothing.
class ThreeMfParser
{
public:
  ThreeMfParser();
  ~ThreeMfParser();
  ThreeMfParser(const ThreeMfParser&) = delete;
  void operator=(const ThreeMfParser&) = delete;

  std::string Add(std::string_view piece);
  std::string Finish();
  ThreeMfPart& Part();

  /// The part at which the package begins: the target of the relationship that was parsed instead
  /// of a model.
  const std::string& StartPart() const;

private:
  class Elements;
  void Open();

  Elements* Internal;
  bool IsOpen = false; ///< From the first piece to Finish().
};
}

#endif
