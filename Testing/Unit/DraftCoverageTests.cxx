// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a draft leaves to the edits that follow: the certificate, which is independent of it,
// confirms that they are proved.
#include "Decimate/Edit/Editor.h"
#include "EditAlone.h"
#include "MeshState.h"
#include "Proof/Certificate/Certificate.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Collapses each edge of every so many, to an end or to the middle, that far beside it.
void CollapseAnywhere(Editor& editor, Random& random, double beside) // mm
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const Index edge : HalfEdges(mesh, 1 + random.Below(5)))
  {
    const HalfEdgeId h(edge);
    if (mesh.IsAlive(HalfEdgeMesh::Face(h)) && GatherAlone(editor, h).IsAccepted())
    {
      const VertexId keep = random.Below(2) == 0 ? mesh.Origin(h) : mesh.Target(h);
      const Vector3 middle = 0.5 * (mesh.Position(mesh.Origin(h)) + mesh.Position(mesh.Target(h)));
      const Vector3 at = random.Below(2) == 0 ? mesh.Position(keep) : middle;
      TryAlone(editor, { h, keep, at + random.InCube(beside), false });
    }
  }
}
}

/// With errors of a fraction of an edge, so that many originals are covered by several faces.
TEST(DraftCoverage, KnowsAllFacesThatCoverAnOriginal)
{
  for (std::uint64_t seed = 50; seed <= 100; ++seed)
  {
    Random random(seed);
    const Surface input = BumpySphere(2, 10.0, random.Between(0.0, 0.4), seed);
    const double error = random.Between(0.6, 1.8);
    const CleanSurface clean = Clean(input, true);
    EditorSettings settings;
    settings.RecordsDistances = false;
    settings.KeepsAreas = false;
    settings.KeepsQuadrics = true;
    settings.Bound = ErrorBoundSettings{ error };
    Editor editor(clean, settings);
    ASSERT_TRUE(MakeProvedDraft(
      editor, [&] { CollapseAnywhere(editor, random, 0.4 * error * random.Below(2)); }));
    for (int i = 0; i < 4; ++i)
    {
      CollapseAnywhere(editor, random, error * random.Below(2));
    }
    Surface result = SurfaceOf(editor.Mesh());
    for (Vector3& p : result.Points)
    {
      p += clean.Origin;
    }
    CertificateOptions options;
    options.Tolerance = error;
    options.TightBounds = false;
    EXPECT_EQ(Certify(input, result, options).Proof, ProofStatus::Proved) << seed;
  }
}
