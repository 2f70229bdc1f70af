// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Angle.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;

TEST(Angle, IsThatOfTheMathLibrary)
{
  for (double angle = 0.0; angle <= 3.14159; angle += 0.01)
  {
    const Vector3 a = 3.0 * Vector3(0.6, 0.8, 0.0);
    const Vector3 b =
      0.2 * (std::cos(angle) * Vector3(0.6, 0.8, 0.0) + std::sin(angle) * Vector3(0.0, 0.0, 1.0));
    EXPECT_NEAR(AngleBetween(a, b), angle, 1e-12);
  }
  EXPECT_EQ(AngleBetween(Vector3(1, 0, 0), Vector3(1, 0, 0)), 0.0);
  EXPECT_NEAR(AngleBetween(Vector3(1, 0, 0), Vector3(-1, 0, 0)), 3.141592653589793, 1e-12);
  EXPECT_TRUE(std::isfinite(AngleBetween(Vector3(1, 0, 0), Vector3::Zero())));
}
