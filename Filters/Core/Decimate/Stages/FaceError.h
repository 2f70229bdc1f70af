// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceError.h
 * @brief The error of a face by its samples, and limits for how far it may turn away from the
 * original.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FaceError_h
#define BoneDecimate_Core_Decimate_Stages_FaceError_h

#include "Decimate/Cost/SampledErrorCost.h"
#include "Proof/Reference/Samples.h"

#include <array>

namespace bonedecimate
{
/// Cosine of the angle between a face and the original (78 degrees) below which flips and moves may
/// not turn the face farther away.
constexpr double MinFacing = 0.2;

/// Whether two faces fold by more than 90 degrees. Then the edge between them may be a chord that
/// lies far from the original without any sample near it.
inline bool FoldSharply(const Vector3& oneNormal, const Vector3& otherNormal)
{
  return Dot(oneNormal, otherNormal) < 0.0;
}

/// The points of chords that are measured, as fractions of the edge.
constexpr std::array<double, 2> ChordFractions = { 1.0 / 3.0, 2.0 / 3.0 };

/// The part of the error of SampledErrorCost.h that is due to the samples and the shape of a face,
/// squares of the mesh's unit.
/// @param frame The face as it is, or after an edit.
inline double ErrorOfFace(
  const Samples& samples, const ErrorPenalty& penalty, FaceId face, const TriangleFrame& frame)
{
  double error = penalty.OfShapes().Of(frame);
  samples.VisitFace(face,
    [&](const Samples::Sample& sample)
    {
      const Vector3 p = samples.SamplePosition(sample);
      error += penalty.OfSample(sample.Weight, frame.Nearest(p).SquaredDistance);
    });
  return error;
}

/// The same, but infinite if a sample is farther from the frame than its limit: a proof would
/// hardly ever succeed.
inline double ErrorWithinLimits(
  const Samples& samples, const ErrorPenalty& penalty, FaceId face, const TriangleFrame& frame)
{
  double error = penalty.OfShapes().Of(frame);
  samples.VisitFace(face,
    [&](const Samples::Sample& sample)
    {
      const double limit = sample.Limit;
      const double squared = frame.Nearest(samples.SamplePosition(sample)).SquaredDistance;
      error += squared <= limit * limit ? penalty.OfSample(sample.Weight, squared) : Infinity;
    });
  return error;
}
}

#endif
