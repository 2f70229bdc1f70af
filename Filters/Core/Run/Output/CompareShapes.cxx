// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CompareShapes.h"

#include "Mesh/TriangleShapes.h"

namespace bonedecimate
{
void CompareShapes(const Surface& surface, const Options& options, const ShapeLimits& limits,
  const Vector3& origin, Report& report)
{
  const double angle = options.EffectiveMinimumAngle();
  report.Angles = angle > 0.0 ? FindBelowAngle(surface, angle) : AngleFigures();
  report.Edges = limits.LimitsEdges() ? FindEdges(surface, limits, origin) : EdgeFigures();
}
}
