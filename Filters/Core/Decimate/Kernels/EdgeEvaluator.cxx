// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeEvaluator.h"

#include "Decimate/Cost/QuadricDeviation.h"
#include "Decimate/Placement/VolumePreserving.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr float Never = std::numeric_limits<float>::infinity();

void EvaluateOne(
  const SweepPolicies& policies, const EdgeBatch& batch, int lane, EdgeResults& results)
{
  const Freedom freedom = static_cast<Freedom>(batch.Freedoms[lane]);
  const EdgeQuadric quadric = QuadricOfEdge(*batch.First, *batch.Others[lane], batch.PerUnit);
  const Float3 position = policies.Placement(quadric, freedom);
  const float cost =
    policies.Cost({ quadric, position, batch.AccumulatedErrors[lane], batch.CostFactor });
  const Float3 move = quadric.Half + position;
  // A NaN counts as Never.
  results.Costs[lane] = freedom != Freedom::Nowhere && cost < Never ? cost : Never;
  results.Moves[0][lane] = move.X;
  results.Moves[1][lane] = move.Y;
  results.Moves[2][lane] = move.Z;
}
}

EdgeEvaluator::EdgeEvaluator(const SweepPolicies& policies)
  : Policies(policies)
{
  if (policies.Cost == QuadricDeviation && policies.Placement == VolumePreservingPosition)
  {
    this->Kernel = BestKernels().EvaluateEdges;
  }
}

//------------------------------------------------------------------------------
void EdgeEvaluator::operator()(const EdgeBatch& batch, EdgeResults& results) const
{
  if (this->Kernel != nullptr)
  {
    this->Kernel(batch, results);
    return;
  }
  std::fill_n(results.Costs, EdgeBatch::Size, Never);
  for (int lane = 0; lane < batch.Count; ++lane)
  {
    EvaluateOne(this->Policies, batch, lane, results);
  }
  results.MinCost = *std::min_element(results.Costs, results.Costs + EdgeBatch::Size);
}
}
