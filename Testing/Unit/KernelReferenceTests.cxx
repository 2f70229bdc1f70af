// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The kernels against the scalar references of Cost/ and Placement/, bit for bit, in every set that
// this processor runs.
#include "Decimate/Cost/AccumulatedError.h"
#include "Decimate/Cost/QuadricDeviation.h"
#include "Decimate/Cost/SpikePenalty.h"
#include "Decimate/Edit/Editor.h"
#include "Decimate/Kernels/Kernels.h"
#include "Decimate/Placement/VolumePreserving.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr float Infinite = std::numeric_limits<float>::infinity();

/// Equal to the last bit, or both not a number, of whatever sign.
template <typename Number>
bool AreSame(Number a, Number b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0 || (std::isnan(a) && std::isnan(b));
}

struct EdgeResult
{
  float Cost;
  Float3 Move; // from the first end, units
};

EdgeResult Reference(const EdgeBatch& batch, std::size_t lane)
{
  const Freedom freedom = static_cast<Freedom>(batch.Freedoms[lane]);
  const EdgeQuadric quadric = QuadricOfEdge(*batch.First, *batch.Others[lane], batch.PerUnit);
  const Float3 x = VolumePreservingPosition(quadric, freedom);
  const float cost =
    QuadricDeviation({ quadric, x, batch.AccumulatedErrors[lane], batch.CostFactor });
  const bool counts = freedom != Freedom::Nowhere && cost < Infinite;
  return { counts ? cost : Infinite, quadric.Half + x };
}

void ExpectReferenceBits(const EdgeBatch& batch, const Kernels& kernels)
{
  EdgeResults found;
  kernels.EvaluateEdges(batch, found);
  float least = Infinite;
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.Count); ++i)
  {
    const EdgeResult expected = Reference(batch, i);
    least = std::min(least, expected.Cost);
    EXPECT_PRED2(AreSame<float>, found.Costs[i], expected.Cost) << kernels.Name << ", lane " << i;
    EXPECT_PRED2(AreSame<float>, found.Moves[0][i], expected.Move.X)
      << kernels.Name << ", lane " << i;
    EXPECT_PRED2(AreSame<float>, found.Moves[1][i], expected.Move.Y)
      << kernels.Name << ", lane " << i;
    EXPECT_PRED2(AreSame<float>, found.Moves[2][i], expected.Move.Z)
      << kernels.Name << ", lane " << i;
  }
  EXPECT_PRED2(AreSame<float>, found.MinCost, least) << kernels.Name;
}

void ExpectReferenceBitsInAllSets(const EdgeBatch& batch)
{
  for (const Kernels* kernels : AvailableKernels())
  {
    ExpectReferenceBits(batch, *kernels);
  }
}

void AddEdge(EdgeBatch& batch, const VertexRecord& other, Freedom freedom, float accumulatedError)
{
  batch.Others[batch.Count] = &other;
  batch.Freedoms[batch.Count] = static_cast<std::int32_t>(freedom);
  batch.AccumulatedErrors[batch.Count++] = accumulatedError;
}

const std::array<Freedom, 5> Freedoms = { Freedom::Space, Freedom::Edge, Freedom::First,
  Freedom::Second, Freedom::Nowhere };

/// The lanes beyond Count hold no edge.
EdgeBatch EmptyBatch()
{
  EdgeBatch batch;
  std::fill_n(batch.Freedoms, EdgeBatch::Size, static_cast<std::int32_t>(Freedom::Nowhere));
  return batch;
}

/// Quadrics of a few planes or none, of areas so small and so large that determinants leave the
/// range of floats.
VertexRecord RandomRecord(Random& random)
{
  VertexRecord record = {};
  const double size = std::pow(10.0, 24.0 * random.Uniform() - 12.0);
  record.Position = random.InCube(1.0);
  const Index planes = random.Below(4);
  for (Index i = 0; i < planes; ++i)
  {
    const Vector3 n = random.InCube(1.0);
    const double area = size * n.norm();
    const Vector3 unit = n.normalized();
    std::size_t k = 0;
    for (int row = 0; row < 3; ++row)
    {
      record.Quadric.G[static_cast<std::size_t>(row)] += static_cast<float>(area * unit[row]);
      for (int column = row; column < 3; ++column)
      {
        record.Quadric.M[k++] += static_cast<float>(area * unit[row] * unit[column]);
      }
    }
  }
  return record;
}

CollapsedEdge EdgeOf(const Fan& fan)
{
  const auto at = [](double* const(&from)[3], int i)
  { return Vector3(from[0][i], from[1][i], from[2][i]); };
  CollapsedEdge edge;
  edge.Start = Vector3::Zero();
  edge.End = { fan.End[0], fan.End[1], fan.End[2] };
  edge.Merged = { fan.Position[0], fan.Position[1], fan.Position[2] };
  for (int i = 0; i < fan.Faces; ++i)
  {
    const Vector3 second = at(fan.Ring, i);
    const Vector3 third = at(fan.Ring, i + 1);
    edge.Before.push_back({ fan.AtEnd[i] != 0 ? edge.End : edge.Start, second, third });
    edge.After.push_back({ edge.Merged, second, third });
  }
  for (int i = 0; i < 4; ++i)
  {
    edge.Before.push_back(
      { edge.Start, edge.End, { fan.Apexes[0][i], fan.Apexes[1][i], fan.Apexes[2][i] } });
  }
  return edge;
}
}

class KernelReferences : public EachShape
{
};

TEST_P(KernelReferences, GiveTheBitsOfCostAndPositionOfEveryEdge)
{
  const CleanSurface cleaned = Clean(GetParam().Surface, true);
  const Editor editor(cleaned, EditorSettings{ false, false, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  Random random(11);
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Outgoing(v) == None || mesh.IsConstrained(v))
    {
      continue;
    }
    for (std::size_t shift = 0; shift < Freedoms.size(); ++shift)
    {
      EdgeBatch batch = EmptyBatch();
      batch.First = &mesh.Record(v);
      batch.PerUnit = 1.0 / mesh.Unit();
      batch.CostFactor = CostNormalization(mesh.InitialEdgeLength() / mesh.Unit());
      mesh.VisitEdges(v,
        [&](Index h)
        {
          if (batch.Count < EdgeBatch::Size)
          {
            const Freedom freedom =
              Freedoms[(static_cast<std::size_t>(batch.Count) + shift) % Freedoms.size()];
            AddEdge(batch, mesh.Record(mesh.OtherEnd(h, v)), freedom,
              static_cast<float>(random.Uniform()));
          }
        });
      ExpectReferenceBitsInAllSets(batch);
    }
  }
}

TEST_P(KernelReferences, GiveTheBitsOfTheAccumulatedError)
{
  const CleanSurface cleaned = Clean(GetParam().Surface, true);
  Editor editor(cleaned, EditorSettings{ false, false, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  Random random(5);
  EditWorkspace work;
  for (const Index edge : HalfEdges(mesh, 3))
  {
    if (editor.Gather(edge, work) != Rejection::NotRejected)
    {
      continue;
    }
    const Vector3 start = mesh.Position(work.Neighborhood.Start);
    const Vector3 along = mesh.Position(work.Neighborhood.End) - start;
    const Vector3 merged = 0.5 * along + random.InCube(along.norm());
    Fan& fan = work.FanArrays.Current();
    std::copy_n(merged.data(), 3, fan.Position);
    const double expected = AccumulatedError(EdgeOf(fan), 0.5, 0.25);
    for (const Kernels* kernels : AvailableKernels())
    {
      EXPECT_PRED2(AreSame<double>, kernels->AccumulateError(fan, 0.5, 0.25), expected)
        << kernels->Name << " at half-edge " << edge;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, KernelReferences, testing::ValuesIn(AllShapes()), NameOf);

TEST(KernelReference, GivesTheBitsOfFewPlanesAndOfExtremeAreas)
{
  Random random(23);
  for (int round = 0; round < 20000; ++round)
  {
    const VertexRecord first = RandomRecord(random);
    std::vector<VertexRecord> others(EdgeBatch::Size);
    EdgeBatch batch = EmptyBatch();
    batch.First = &first;
    batch.PerUnit = 4.0;
    for (VertexRecord& other : others)
    {
      other = RandomRecord(random);
      const Freedom freedom =
        Freedoms[static_cast<std::size_t>(random.Below(static_cast<Index>(Freedoms.size())))];
      AddEdge(batch, other, freedom, static_cast<float>(10.0 * random.Uniform()));
    }
    ExpectReferenceBitsInAllSets(batch);
  }
}

TEST(KernelReference, GivesTheBitsOfAnEdgeWithoutLength)
{
  Random random(3);
  const VertexRecord record = RandomRecord(random);
  for (const Freedom freedom : Freedoms)
  {
    EdgeBatch batch = EmptyBatch();
    batch.First = &record;
    AddEdge(batch, record, freedom, 0.0F);
    ExpectReferenceBitsInAllSets(batch);
  }
}

TEST(QuadricDeviation, GrowsWithTheDistanceToThePlanesAndWithTheAccumulatedError)
{
  VertexRecord flat = {};
  flat.Position = { 0.0, 0.0, 0.0 };
  flat.Quadric = { { 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 2.0F }, { 0.0F, 0.0F, 2.0F } };
  VertexRecord other = flat;
  other.Position = Vector3(1.0, 0.0, 0.0);
  const EdgeQuadric quadric = QuadricOfEdge(flat, other, 1.0);
  const auto costAt = [&](float height, float accumulated) {
    return QuadricDeviation({ quadric, { 0.0F, 0.0F, height }, accumulated, 1.0F });
  };
  EXPECT_LT(costAt(0.0F, 0.0F), costAt(0.1F, 0.0F));
  EXPECT_LT(costAt(0.1F, 0.0F), costAt(0.2F, 0.0F));
  EXPECT_LT(costAt(0.1F, 0.0F), costAt(0.1F, 0.1F));
  // S = 4, q = 4 h^2, cost = 4 h^(3/2): about area times distance^(3/2)
  EXPECT_NEAR(costAt(0.25F, 0.0F), 4.0 * 0.125, 1e-6);
}

TEST(SpikePenalty, GrowsLikeTheMeanFaceAndDoesNotDependOnTheUnit)
{
  const double length = 0.75;
  const double factor = SpikeFactor(0.3, 1000, length, CostNormalization(length));
  EXPECT_EQ(SpikePenalty(factor, 1000, 0.0), 0.0);
  EXPECT_NEAR(SpikePenalty(factor, 250, 0.5), 4.0 * SpikePenalty(factor, 1000, 0.5), 1e-12);
  const double scaled = SpikeFactor(0.3, 1000, 2.0 * length, CostNormalization(2.0 * length));
  EXPECT_NEAR(SpikePenalty(scaled, 250, 1.0), SpikePenalty(factor, 250, 0.5), 1e-6);
}
