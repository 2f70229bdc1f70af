// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlyElementReader.h
 * @brief The elements of a PLY file one after the other, as text or in binary.
 */
#ifndef BoneDecimate_Applications_PlyElementReader_h
#define BoneDecimate_Applications_PlyElementReader_h

#include "PlyHeader.h"

#include <cstdint>

namespace bonedecimate
{
/// The values of one element; a double holds every type of the format exactly.
struct PlyValues
{
  std::vector<double> Scalars;            ///< One for each property; of a list nothing.
  std::vector<std::vector<double>> Lists; ///< One for each property; of a scalar empty.
};

class PlyElementReader
{
public:
  /// @param lines Behind the header.
  PlyElementReader(const std::string& path, const PlyHeader& header, LineReader& lines);

  /// False where the file ends, or holds what is no value of its type.
  bool Read(const PlyElement& element, PlyValues& values);

  /// Whether there is more than a program may have put behind the last element.
  bool HasMore();

private:
  bool ReadText(const PlyElement& element, PlyValues& values);
  bool ReadProperties(const PlyElement& element, PlyValues& values);
  bool ReadList(const PlyProperty& property, std::vector<double>& list);
  double MostValues(int type);
  bool ReadValue(int type, double& value);
  bool ReadTextValue(int type, double& value);
  bool ReadBinaryValue(int type, double& value);

  const PlyHeader& Header;
  LineReader& Lines;
  std::int64_t BytesLeft = 0; // of a binary file
  std::size_t Word = 0;       // the next one of the line
};
}

#endif
