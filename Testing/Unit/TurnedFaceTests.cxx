// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// No triangle is turned over, in one step or in many: faces keep their ids, so each can be compared
// with its original.
#include "Decimate/Stages/StageList.h"
#include "Mesh/SpatialOrder.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// First normals are kept within a hundredth of a degree.
constexpr double Rounding = 2e-4;
/// First areas are kept within a hundredth.
constexpr double LeastGrowth = 0.99 * HalfEdgeMesh::MaxAreaGrowth;

/// Along the normal.
Vector3 AreaOf(const std::vector<Vector3>& points, const Triangle& t)
{
  return 0.5 * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
}

/// Cosine of the most by which any face has turned since the beginning that has not outgrown its
/// original normal.
double MinFacing(const HalfEdgeMesh& mesh, const Surface& original)
{
  std::vector<Vector3> points;
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    points.push_back(mesh.Position(v));
  }
  double least = 1.0;
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      const Vector3 before = AreaOf(original.Points, original.Triangles[face]);
      const Vector3 after = AreaOf(points, mesh.Corners(face));
      const bool isFree = after.norm() > LeastGrowth * before.norm();
      least = isFree ? least : std::min(least, before.normalized().dot(after.normalized()));
    }
  }
  return least;
}

void RunIn(Editor& editor, Mode mode, const StopTargets& stops)
{
  RunStages({ editor, FindMode(mode), stops, 0.95 }, [](double) { return true; });
}

/// Two triangles of a flat grid lie at the edge p-q, and v is the corner of one of them: where v
/// goes if that triangle swings round the edge.
struct Swing
{
  explicit Swing(const HalfEdgeMesh& mesh)
  {
    for (this->Edge = 0; !this->IsInside(mesh); ++this->Edge)
    {
    }
    this->V = mesh.Apex(this->Edge);
    const Vector3& p = mesh.Position(mesh.Origin(this->Edge));
    this->Along = (mesh.Position(mesh.Target(this->Edge)) - p).normalized();
    const Vector3 arm = mesh.Position(this->V) - p;
    this->Foot = p + arm.dot(this->Along) * this->Along;
    this->Arm = mesh.Position(this->V) - this->Foot;
  }
  bool IsInside(const HalfEdgeMesh& mesh) const
  {
    return (this->Edge & 3) != 3 &&
      mesh.Constraint(mesh.Apex(this->Edge)) == VertexConstraint::Free;
  }
  Vector3 By(double degrees) const
  {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    return this->Foot + std::cos(angle) * this->Arm +
      std::sin(angle) * this->Along.cross(this->Arm);
  }

  Index Edge = 0;
  Index V = None;
  Vector3 Foot, Along, Arm;
};
}

class EveryFace : public testing::TestWithParam<std::tuple<NamedSurface, Mode>>
{
};

TEST_P(EveryFace, KeepsTheSideOfItsOriginalNormal)
{
  const auto& [shape, mode] = GetParam();
  for (const Index divisor : { 3, 12 })
  {
    CleanSurface cleaned = Clean(shape.Surface, true);
    SortAlongCurve(cleaned, 1);
    Editor editor(cleaned, EditorSettings{ mode == Mode::Thesis, true, true, true });
    RunIn(editor, mode, { editor.Mesh().NumberOfFaces() / divisor, 0.0 });
    EXPECT_GE(MinFacing(editor.Mesh(), cleaned.Surface), -Rounding) << "one in " << divisor;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryFace,
  testing::Combine(testing::ValuesIn(AllShapes()), testing::ValuesIn(AllModes())),
  [](const auto& parameters)
  { return std::get<0>(parameters.param).Name + WordOf(std::get<1>(parameters.param)); });

TEST(EditValidity, SmallRotationsCannotAccumulate)
{
  const CleanSurface cleaned = Clean(FlatPlate(6), true);
  Editor editor(cleaned, EditorSettings{ false, false, false });
  editor.PrepareCollapses(1);
  EditWorkspace work;
  const Swing swing(editor.Mesh());
  EXPECT_EQ(editor.Try(MoveTo(swing.V, swing.By(30.0)), work), Rejection::NotRejected);
  EXPECT_EQ(editor.Try(MoveTo(swing.V, swing.By(60.0)), work), Rejection::NotRejected);
  EXPECT_EQ(editor.Try(MoveTo(swing.V, swing.By(89.0)), work), Rejection::NotRejected);
  EXPECT_EQ(editor.Try(MoveTo(swing.V, swing.By(91.0)), work), Rejection::Flip);
  EXPECT_EQ(editor.Try(MoveTo(swing.V, swing.By(60.0)), work), Rejection::NotRejected)
    << "back it may go";
}

TEST(EditValidity, TriangleThatHasGrownMayTurnFarther)
{
  const CleanSurface cleaned = Clean(FlatPlate(6), true);
  Editor editor(cleaned, EditorSettings{ false, false, false });
  editor.PrepareCollapses(1);
  EditWorkspace work;
  const Swing swing(editor.Mesh());
  const FaceId face = HalfEdgeMesh::Face(swing.Edge);
  const Vector3 area = AreaOf(cleaned.Surface.Points, editor.Mesh().Corners(face));
  EXPECT_FALSE(editor.Mesh().IsTurnedOver(face, -area)) << "not changed yet";
  ASSERT_EQ(editor.Try(MoveTo(swing.V, swing.By(30.0)), work), Rejection::NotRejected);
  EXPECT_TRUE(editor.Mesh().IsTurnedOver(face, -area));
  EXPECT_TRUE(editor.Mesh().IsTurnedOver(face, -7.9 * area));
  EXPECT_FALSE(editor.Mesh().IsTurnedOver(face, -8.1 * area));
  EXPECT_FALSE(editor.Mesh().IsTurnedOver(face, 7.9 * area));
}
