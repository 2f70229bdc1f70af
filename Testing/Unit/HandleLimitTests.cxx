// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Runs that end because of handles say so; others do not.
#include "Runs.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
StopReason StopOf(const Surface& surface, Mode mode, int triangles)
{
  return Decimate(surface, InMode(mode, Triangles(triangles))).Report.Stop;
}
}

TEST(HandleLimit, IsTheReasonWhereATorusHasTooFewEdges)
{
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    EXPECT_EQ(StopOf(Torus(24, 12), mode, 4), StopReason::Handles);
    EXPECT_EQ(StopOf(Torus(24, 12), mode, 100), StopReason::TargetReached);
  }
}

TEST(HandleLimit, IsNotTheReasonWithoutHandles)
{
  EXPECT_EQ(StopOf(Icosphere(2, 10.0), Mode::Balanced, 2), StopReason::NothingLeft);
}
