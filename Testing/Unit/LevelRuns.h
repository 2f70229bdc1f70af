// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelRuns.h
 * @brief Recorded runs for the tests of levels.
 */
#ifndef BoneDecimate_Testing_LevelRuns_h
#define BoneDecimate_Testing_LevelRuns_h

#include "Run/Levels.h"
#include "Runs.h"

namespace bonedecimate::testsupport
{
struct Recorded
{
  Result Run;
  bonedecimate::Levels Levels;
};

inline Recorded Record(const Surface& input, const Options& options, bool inputIsSingle = false)
{
  Recorded recorded;
  recorded.Run = RecordLevels(input, options, {}, { inputIsSingle }, recorded.Levels);
  return recorded;
}

/// So large that blocks are swept side by side; its least corner is the origin, so that no
/// coordinate is rounded.
inline Surface LargeBone()
{
  const Surface bone = HeightField(130, 0.4, 5);
  Vector3 least = bone.Points.front();
  for (const Vector3& point : bone.Points)
  {
    least = least.cwiseMin(point);
  }
  return Moved(bone, -least);
}

inline Surface SmallBone()
{
  return BumpySphere(4, 20.0, 0.02, 31);
}
}

#endif
