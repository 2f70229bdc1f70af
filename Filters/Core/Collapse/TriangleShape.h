// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleShape.h
 * @brief What every edit must respect: triangles do not turn over, lose their area or become needles.
 */
#ifndef BoneDecimate_Core_Collapse_TriangleShape_h
#define BoneDecimate_Core_Collapse_TriangleShape_h

#include "Mesh/FaceAreas.h"
#include "Report.h"

namespace bonedecimate
{
/// Cosine of the most (78 degrees) by which a face may turn in one step; 90 would let it end on its edge.
constexpr double LeastCosine = 0.2;
/// Below this quality, no face may become worse than before.
constexpr double LeastShapeQuality = 0.02;

/// 4 sqrt(3) area / sum of squared edges: 1 for an equilateral triangle, 0 without area.
inline double ShapeQuality(double area, const Vector3& a, const Vector3& b, const Vector3& c)
{
  constexpr double qualityOfEquilateral = 6.928203230275509; // 4 sqrt(3)
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0.0 ? qualityOfEquilateral * area / squares : 0.0;
}

inline bool IsTurned(const FaceAreas::Face& before, const Vector3& after, double area)
{
  return before.Area > 0.0 && before.Normal.dot(after) < LeastCosine * area;
}

/// Whether a face may have its first corner moved.
inline Verdict JudgeCorner(const FaceAreas::Face& before, const Vector3& corner,
  const Vector3& position, const Vector3& second, const Vector3& third)
{
  const Vector3 after = AreaVector(position, second, third);
  const double area = after.norm();
  if (!(area > 0.0))
  {
    return Verdict::Degenerate;
  }
  if (IsTurned(before, after, area))
  {
    return Verdict::Flip;
  }
  const double quality = ShapeQuality(area, position, second, third);
  const bool needle =
    quality < LeastShapeQuality && quality < ShapeQuality(before.Area, corner, second, third);
  return needle ? Verdict::Degenerate : Verdict::Allowed;
}
}

#endif
