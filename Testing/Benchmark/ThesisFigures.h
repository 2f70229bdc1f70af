// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThesisFigures.h
 * @brief The figures that H. Brandao's thesis (Groningen 2018) prints, on a Core i7-4510U and its own two meshes.
 *
 * Distances of the simplified surface's points to the original, mm. A negative value was not printed there.
 */
#ifndef BoneDecimate_Testing_ThesisFigures_h
#define BoneDecimate_Testing_ThesisFigures_h

#include <vector>

struct ThesisRow
{
  double Asked; ///< Triangles, or mm in error mode.
  double Faces;
  double Maximum;
  double Second;
  double Average;
  double RootMeanSquare;
  double Seconds;
};

struct ThesisBone
{
  const char* Name;
  int Faces;
  std::vector<ThesisRow> ByCount;
  std::vector<ThesisRow> ByError;
};

inline const ThesisBone& ThesisMaxilla()
{
  static const ThesisBone bone = { "maxilla", 105002,
    { { 65000, 65000, 0.2341, -1, 0.00445, 0.01323, 4.72 },
      { 40000, 40000, 0.7644, -1, 0.01824, 0.0346, 7.09 },
      { 10000, 10000, 0.6109, -1, 0.0796, 0.1088, 9.44 },
      { 1000, 1000, 1.7012, -1, 0.3427, 0.4578, 10.14 } },
    { { 0.1, 94698, 0.1188, 0.0784, 0.00037, 0.0023, -1 },
      { 0.5, 53864, 0.5935, 0.2342, 0.0088, 0.0209, -1 },
      { 1.0, 6578, 1.7066, 0.7481, 0.1084, 0.1500, -1 } } };
  return bone;
}

inline const ThesisBone& ThesisFrontalBone()
{
  static const ThesisBone bone = { "frontal bone", 78640,
    { { 65000, 65000, 0.1555, -1, 0.00078, 0.00405, 1.54 },
      { 40000, 40000, 0.2494, -1, 0.00727, 0.01855, 3.90 },
      { 10000, 10000, 0.5583, -1, 0.0574, 0.0822, 6.29 },
      { 1000, 1000, 1.4873, -1, 0.2648, 0.3481, 6.86 } },
    { { 0.1, 68502, 0.1538, 0.0845, 0.0005, 0.0029, -1 },
      { 0.5, 12558, 0.5583, 0.4644, 0.0470, 0.0696, -1 },
      { 1.0, 4814, 1.5474, 0.6953, 0.0980, 0.1372, -1 } } };
  return bone;
}

#endif
