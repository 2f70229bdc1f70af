// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The predicates of a vertex constraint, value by value.
#include "Mesh/VertexConstraint.h"

#include <gtest/gtest.h>

#include <vector>

using namespace bonedecimate;

namespace
{
const std::vector<VertexConstraint> InAscendingRank = { VertexConstraint::Free,
  VertexConstraint::Boundary, VertexConstraint::Stationary, VertexConstraint::StationaryBoundary,
  VertexConstraint::NonManifold, VertexConstraint::Constrained };

template <typename Predicate>
std::vector<bool> OfAll(const Predicate& predicate)
{
  std::vector<bool> values;
  for (const VertexConstraint constraint : InAscendingRank)
  {
    values.push_back(predicate(constraint));
  }
  return values;
}
}

TEST(VertexConstraint, PredicatesAreThoseOfItsTable)
{
  using Row = std::vector<bool>;
  EXPECT_EQ(OfAll(MovesFreely), (Row{ true, false, false, false, false, false }));
  EXPECT_EQ(OfAll(IsOnBoundary), (Row{ false, true, false, true, false, false }));
  EXPECT_EQ(OfAll(IsStationary), (Row{ false, false, true, true, false, false }));
  EXPECT_EQ(OfAll(IsConstrained), (Row{ false, false, false, false, true, true }));
}

TEST(VertexConstraint, OutranksAllBeforeItAndNotItself)
{
  for (std::size_t i = 0; i < InAscendingRank.size(); ++i)
  {
    for (std::size_t k = 0; k < InAscendingRank.size(); ++k)
    {
      EXPECT_EQ(Outranks(InAscendingRank[i], InAscendingRank[k]), i > k) << i << " " << k;
    }
  }
}

TEST(VertexConstraint, AnInteriorEdgeLeavesTheBoundaryIfNeitherEndMovesFreely)
{
  for (const VertexConstraint one : InAscendingRank)
  {
    for (const VertexConstraint other : InAscendingRank)
    {
      EXPECT_FALSE(LeavesBoundary(one, other, true));
      EXPECT_EQ(LeavesBoundary(one, other, false),
        one != VertexConstraint::Free && other != VertexConstraint::Free);
    }
  }
}
