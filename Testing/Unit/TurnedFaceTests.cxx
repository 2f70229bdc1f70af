// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// No triangle is turned over, not in one step nor in many: faces keep their ids, so that each can be held against what it
// was.
#include "Collapse/Sweep.h"
#include "Collapse/ThesisLoop.h"
#include "Mesh/SpatialOrder.h"
#include "Relax/RelaxedLoop.h"
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

Vector3 NormalOf(const std::vector<Vector3>& points, const Triangle& t)
{
  return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).normalized();
}

/// Cosine of the most by which any face has turned since the beginning.
double LeastFacing(const HalfEdgeMesh& mesh, const Surface& original)
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
      const Vector3 before = NormalOf(original.Points, original.Triangles[face]);
      least = std::min(least, before.dot(NormalOf(points, mesh.Corners(face))));
    }
  }
  return least;
}

void RunIn(Editor& editor, Mode mode, const Stops& stops)
{
  const Monitor goOn = [](double) { return true; };
  if (mode == Mode::Thesis)
  {
    ThesisLoop(editor, 0.95, stops).Run(goOn);
  }
  else if (mode == Mode::Fast)
  {
    Sweep(editor, stops, 1).Run(goOn);
  }
  else
  {
    RelaxedLoop(editor, mode == Mode::Balanced ? BalancedRecipe : AccurateRecipe, stops, 1)
      .Run(goOn);
  }
}

/// Two triangles of a flat grid lie at the edge p-q, and v is the corner of one of them: where v goes if that triangle
/// swings round the edge.
struct Swing
{
  explicit Swing(const HalfEdgeMesh& mesh)
  {
    for (this->Edge = 0; !this->IsInside(mesh); ++this->Edge)
    {
    }
    this->V = mesh.Origin(HalfEdgeMesh::Previous(this->Edge));
    const Vector3& p = mesh.Position(mesh.Origin(this->Edge));
    this->Along = (mesh.Position(mesh.Target(this->Edge)) - p).normalized();
    const Vector3 arm = mesh.Position(this->V) - p;
    this->Foot = p + arm.dot(this->Along) * this->Along;
    this->Arm = mesh.Position(this->V) - this->Foot;
  }
  bool IsInside(const HalfEdgeMesh& mesh) const
  {
    return (this->Edge & 3) != 3 &&
      mesh.Kind(mesh.Origin(HalfEdgeMesh::Previous(this->Edge))) == VertexKind::Inside;
  }
  Edit By(double degrees) const
  {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    Edit edit;
    edit.Kind = EditKind::Move;
    edit.Keep = this->V;
    edit.Position =
      this->Foot + std::cos(angle) * this->Arm + std::sin(angle) * this->Along.cross(this->Arm);
    return edit;
  }

  Index Edge = 0;
  Index V = None;
  Vector3 Foot, Along, Arm;
};
}

class EveryFace : public testing::TestWithParam<std::tuple<NamedSurface, Mode>>
{
};

TEST_P(EveryFace, LooksWhereItLookedAtFirst)
{
  const auto& [shape, mode] = GetParam();
  for (const Index divisor : { 3, 12 })
  {
    CleanSurface cleaned = Clean(shape.Surface, true);
    SortAlongCurve(cleaned, 1);
    Editor editor(cleaned, Editor::Books{ mode == Mode::Thesis, true, true });
    RunIn(editor, mode, { editor.Mesh().NumberOfFaces() / divisor, 0.0 });
    EXPECT_GE(LeastFacing(editor.Mesh(), cleaned.Surface), -Rounding) << "one in " << divisor;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryFace,
  testing::Combine(testing::ValuesIn(AllShapes()), testing::ValuesIn(AllModes())),
  [](const auto& parameters)
  { return std::get<0>(parameters.param).Name + WordOf(std::get<1>(parameters.param)); });

TEST(Gate, SeveralSmallTurnsTurnNoFaceOver)
{
  const CleanSurface cleaned = Clean(FlatPlate(6), true);
  Editor editor(cleaned, Editor::Books{ false, false, false });
  editor.ShareVolumes();
  Workspace work;
  const Swing swing(editor.Mesh());
  EXPECT_EQ(editor.ApplySmall(swing.By(30.0), work, 1), Verdict::Allowed);
  EXPECT_EQ(editor.ApplySmall(swing.By(60.0), work, 1), Verdict::Allowed);
  EXPECT_EQ(editor.ApplySmall(swing.By(89.0), work, 1), Verdict::Allowed);
  EXPECT_EQ(editor.ApplySmall(swing.By(91.0), work, 1), Verdict::Flip);
  EXPECT_EQ(editor.ApplySmall(swing.By(60.0), work, 1), Verdict::Allowed) << "back it may go";
}
