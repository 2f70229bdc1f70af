# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The deliberate bugs of mutants.py."""

from __future__ import annotations

from typing import NamedTuple

FOLDER = "Filters/Core/Proof/ErrorBound/"
SMOOTHING = "Filters/Core/Smoothing/"
LABELS = "Filters/Core/Labels/LabelMap/"
GUARD = "Filters/Core/Labels/VoxelGuard/"
INTERSECTIONS = "Filters/Core/Proof/Guard/"
STATE = INTERSECTIONS + "StateCheck.cxx"
SEPARATION = INTERSECTIONS + "Separation.cxx"
DRAFT = "Filters/Core/Decimate/Edit/Draft.cxx"
APPLY = "Filters/Core/Decimate/Edit/EditorApply.cxx"
BULK = FOLDER + "BulkProof.cxx"
CERTIFICATE = "Filters/Core/Proof/Certificate/"
OVERLAY = CERTIFICATE + "OverlayCover.cxx"
JOINT = CERTIFICATE + "JointCover.cxx"


class Mutant(NamedTuple):
    """A bug: a replacement of text in a file."""

    name: str
    file: str
    right: str
    wrong: str
    tests: str = ""  # GoogleTest's filter of the unit tests that look for it, too
    kind: str = "labels"  # the attack that looks for it, if there are unit tests; else it is that on surfaces


SMOOTHING_TESTS = "Smoothing*:AutomaticSmoothing*"
EXTRACTION_TESTS = "*LabelSurfaces*:*NoiseSurfaces*:*Cells*:SingleLabel*"
GUARD_TESTS = "VoxelPatches*:ColumnCrossings*:FixedPoints*:*EachMap*:KeepVoxelsOption*"
CHECK_TESTS = "VoxelChecks*:*EachMap*:KeepVoxelsOption*"

BATCH = "Filters/Core/Decimate/Schedule/BatchSweep.cxx"
BATCH_TESTS = "BatchSweep*"
DRAFT_TESTS = "Draft*:EditJournal*"
GUARD_OF_DRAFT_TESTS = DRAFT_TESTS + ":Separation*:Containment*:*IntersectionGuard*:GapsOfADraft*"
SHAPE_TESTS = "ShapeFilter*:ShapeImprover*:ShapePenalty*:MinimumAngle*:RingShape*"
TUNNEL_TESTS = "Tunnels*:EdgeGraph*"
SPLIT_TESTS = "EdgeSplit*:EdgeLength*:FreeSlots*"
CERTIFICATE_TESTS = "OverlayCover*:JointCover*:PointValues*:EdgeSides*:Certificate*:ResultProof*"


def of_draft(name: str, file: str, right: str, wrong: str, tests: str = DRAFT_TESTS) -> Mutant:
    """A bug that the attack on surfaces and unit tests look for."""
    return Mutant(name, file, right, wrong, tests, "surfaces")


def of_near(name: str, file: str, right: str, wrong: str) -> Mutant:
    """A bug that the attack on near parts and unit tests look for."""
    return Mutant(name, file, right, wrong, GUARD_OF_DRAFT_TESTS, "near")


MUTANTS = (
    Mutant("a limit that is a twentieth too large", FOLDER + "ErrorLimits.cxx", "error * (1.0 - RelativeSlack) - this->RoundingMargin",
           "error * 1.05 - this->RoundingMargin"),
    Mutant("no slack for points that are rounded when they are written", FOLDER + "ErrorLimits.cxx",
           "return AbsoluteSlack * size + rounding;", "return 0.0 * (size + rounding);"),
    Mutant("the most tolerant corner of an original counts", FOLDER + "ErrorLimits.h",
           ": std::min({ this->VertexLimits[c[0]]", ": std::max({ this->VertexLimits[c[0]]"),
    Mutant("originals are not checked", FOLDER + "Prover.cxx", "&& this->OriginalsAreNear(mesh) &&", "&&"),
    Mutant("new faces are not checked", FOLDER + "Prover.cxx", "&& this->NewFacesAreNear();", ";"),
    Mutant("boundaries are not checked", FOLDER + "Prover.cxx", "this->BoundaryIsNear(mesh) &&", ""),
    Mutant("two corners of an original are enough", FOLDER + "Prover.cxx",
           "this->Points[points[1]].NearCandidates & this->Points[points[2]].NearCandidates;", "this->Points[points[1]].NearCandidates;"),
    Mutant("two corners of a piece are enough", FOLDER + "CommonFaceProof.cxx",
           "piece[0].NearCandidates & piece[1].NearCandidates & piece[2].NearCandidates;", "piece[0].NearCandidates & piece[1].NearCandidates;"),
    Mutant("half of a piece is forgotten", FOLDER + "CommonFaceProof.cxx",
           "  this->OpenPieces.push_back(piece);\n  this->OpenPieces.back()[edge] = middle;\n", ""),
    Mutant("the faces that cover an original are not stored", FOLDER + "ErrorBound.cxx",
           "coverage.Add(covered.Id, newElements[i]);", "(void)newElements;"),
    Mutant("an even number of layers is a cover", FOLDER + "PlaneCover.h", "return this->IsOdd;", "return true;"),
    Mutant("a boundary over the face is allowed", FOLDER + "PlaneCover.cxx", "return twin != None;", "return true;"),
    Mutant("any distance from the face is allowed", FOLDER + "PlaneCover.cxx",
           "(farthest > limit * limit && !this->IsNearOver(projected, limit)) ||", "farthest < -limit ||"),
    Mutant("one end of a boundary is enough", FOLDER + "BoundaryProof.cxx", "isNear(this->Candidates[i], 0) &&",
           "isNear(this->Candidates[i], 0) ||"),
    Mutant("half of a face is forgotten", FOLDER + "FaceProof.cxx",
           "  half.Corners[next] = piece.Corners[next];\n  half.Corners[edge] = middle;\n  this->OpenPieces.push_back(half);\n",
           ""),
    Mutant("points that become one in single precision stay where they are", "Filters/Core/Decimate/Stages/DistinctPositions.cxx",
           "            later.push_back(v);\n", "            (void)v;\n"),
    of_draft("overlapping edits of a batch are applied", BATCH,
             "return std::all_of(this->ChangedBoxes.begin(), this->ChangedBoxes.end(), isApart) &&",
             "return (this->BatchNumber > 0 || std::all_of(this->ChangedBoxes.begin(), this->ChangedBoxes.end(), isApart)) &&",
             BATCH_TESTS),
    of_draft("edits of a batch are applied within the reach of others", BATCH, "reach = candidate.Workspace.Change.Reach;", "reach = 0.0;",
             BATCH_TESTS),
    of_draft("filters do not check an edit of a batch again when it is applied", BATCH, " &&\n    this->MeshEditor.StillAccepts(candidate.Workspace);",
             ";", BATCH_TESTS),
    of_draft("the coverage that an edit of a batch read may have changed", FOLDER + "ErrorBound.cxx",
             "coverage.VersionOf(covered.Id) == covered.Version;", "coverage.VersionOf(covered.Id) != covered.Version + 99;", BATCH_TESTS),
    of_draft("the versions of a coverage do not count what is added", FOLDER + "Coverage.h",
             "store(covering, std::memory_order_relaxed);\n    ++this->Versions[item];", "store(covering, std::memory_order_relaxed);\n    --this->Versions[item];",
             BATCH_TESTS),
    of_draft("fragments lose the volume of each edit of a batch alone", "Filters/Core/Proof/EditFilters/FragmentGuard.cxx",
             "return this->Screen(mesh, change, pending).IsAccepted();", "return this->Screen(mesh, change, pending).IsAccepted() || change.Workers == 1;",
             BATCH_TESTS),
    of_draft("an edit of a draft is undone without those that depend on it", "Filters/Core/Proof/EditFilters/EditJournal.cxx",
             "          open.push_back(later);\n", ""),
    of_draft("an edit of a draft is undone without those that depend on it through others",
             "Filters/Core/Proof/EditFilters/EditJournal.cxx", "        if (position == seen.end() || *position != later)",
             "        if (at == edit && (position == seen.end() || *position != later))"),
    of_draft("an undone edit stays the last one of its faces", "Filters/Core/Proof/EditFilters/EditJournal.cxx",
             "    this->LastEdits[face.Face] = face.MadeBy;\n", "    (void)face;\n"),
    of_draft("an undone edit leaves the vertex where it was moved", APPLY,
             "  this->CurrentMesh.Move(entry.Keep, journal.OldPosition(entry));\n", ""),
    of_draft("faces of a draft are not proved", BULK, "                this->Bound.NearTriangles[this->Mesh.Corners(face)[0]])\n",
             "                this->Bound.NearTriangles[this->Mesh.Corners(face)[0]]) || true\n"),
    of_draft("originals of a draft are not proved", BULK, "          if (!covering.IsProved)\n",
             "          if (!covering.IsProved && covering.Count > 99)\n"),
    of_draft("a face that an undone edit restored counts as proved", BULK,
             "this->Journal.LastEditOf(face) != this->ProvedVersion[face] ? 1 : 0",
             "this->Journal.LastEditOf(face) > this->ProvedVersion[face] ? 1 : 0"),
    of_draft("originals keep their covering faces when these change", BULK,
             "originals[i] = hasChanged || !covering.IsProved ? 1 : 0;",
             "originals[i] = (hasChanged && covering.Count == 0) || !covering.IsProved ? 1 : 0;"),
    of_draft("an original that was covered at first counts as covered", BULK,
             "    [this](Index face) { return this->Journal.IsChanged(face); });",
             "    [this](Index face) { return !this->Mesh.IsAlive(FaceId(face)); });"),
    of_draft("two corners of an original of a draft are enough", FOLDER + "OriginalProof.cxx", "    if (second != None && third != None)\n",
             "    if (second != None)\n"),
    of_draft("one covering face is written of each original", FOLDER + "CoveringList.cxx",
             "    for (int i = 0; i < covering.Count; ++i)\n", "    for (int i = 0; i < std::min(covering.Count, 1); ++i)\n"),
    of_near("no limit near other parts", FOLDER + "ErrorLimits.cxx", "    if (isNear(distances[v]))\n",
              "    if (isNear(distances[v]) && part < 0.0)\n"),
    of_near("more than half of the way to another part", DRAFT, "LessThanHalf = 0.49;", "LessThanHalf = 1.5;"),
    of_near("limits near other parts hold in the filter, not in the proof", DRAFT,
              "*editor.BoundFilter, this->Limits, editor.CurrentMesh, *this->Journal, this->Threads);",
              "*editor.BoundFilter, editor.BoundFilter->Limits(), editor.CurrentMesh, *this->Journal, this->Threads);"),
    of_near("other parts count only within the error", DRAFT, "ErrorsOfSeparation = 2.01;", "ErrorsOfSeparation = 0.6;"),
    of_near("what is near another part moves where the mesh is smoothed", DRAFT, "this->StartsFromOriginal ? LessThanHalf : 0.0",
              "this->StartsFromOriginal ? LessThanHalf : 3.0"),
    of_near("a tube counts as a disk", SEPARATION, "return this->Parts == 1 && this->Euler == 1;", "return this->Parts == 1;"),
    of_near("another part counts as the same disk", SEPARATION, "return this->Parts == 1 && this->Euler == 1;",
              "return this->Euler == this->Parts;"),
    of_near("triangles of another part that are left out are not there", SEPARATION, "      limit = end->Distance;\n", ""),
    of_near("what intersects in the state that is left is not looked at", STATE, "  if (Meet(piece, near, this->Written))\n",
              "  if (face == other && Meet(piece, near, this->Written))\n"),
    of_near("pairs of which one face has changed are not looked at", STATE, "(isChanged || this->Journal.IsChanged(other))",
              "(isChanged && this->Journal.IsChanged(other))"),
    of_near("what undone edits have restored is not looked at again", STATE,
              "if (std::exchange(this->CheckedEdits[i], edit) != edit)",
              "if (const Index was = std::exchange(this->CheckedEdits[i], edit); was != edit && was == None)"),
    of_near("faces are looked for where they were at first", STATE,
              "      this->Tree->Set(i, isThere ? boxOf(face) : FloatBox());\n", ""),
    of_near("gaps of a draft are not checked", STATE, "return IsTooNear(this->Widths, piece, near, {}) &&",
              "return face == other && IsTooNear(this->Widths, piece, near, {}) &&"),
    of_near("a gap that the draft itself has narrowed allows a narrow one", STATE, "  if (later.MadeBy == None)\n",
              "  if (later.MadeBy == None || stepsLeft < MaxSteps)\n"),
    of_near("a wide gap of the input allows a narrow one", STATE, ".SquaredLength <= now &&", ".SquaredLength >= now &&"),
    of_near("a merged vertex of a draft keeps its own gap", INTERSECTIONS + "GapPairs.cxx",
              "Min(widths.Of(keep), widths.Of(mesh.OriginalVertex(entry.Gone)))", "widths.Of(keep)"),
    of_near("fragments of a draft may lose their volume", DRAFT, "isWrong[this->MeshEditor.Fragments->ComponentOf(entry.Keep)] != 0",
              "isWrong[this->MeshEditor.Fragments->ComponentOf(entry.Keep)] > 1"),
    of_near("a component may be swallowed", INTERSECTIONS + "Containment.cxx", "    if ((next - first) % 2 != 0)\n",
            "    if (next == first)\n"),
    of_near("what passes an edge of what encloses is not looked at again", INTERSECTIONS + "Containment.cxx",
            "isClear = isClear && result != RayResult::Unclear;", "isClear = isClear && true;"),
    of_near("an edit may jump over something", INTERSECTIONS + "IntersectionGuard.cxx",
              "const bool jumps = JumpOver(work.OldFaces, work.NewFaces, work.SweptFaces);", "const bool jumps = false;"),
    of_near("what is far from the faces before and after may be jumped over", INTERSECTIONS + "IntersectionGuard.cxx",
              "JumpOver(work.OldFaces, work.NewFaces, work.SweptFaces)", "JumpOver(work.OldFaces, work.NewFaces, work.NearFaces)"),
    of_near("intersections are decided where the mesh has the vertices", INTERSECTIONS + "WrittenPositions.cxx",
              "  if (this->Input == nullptr)\n", "  if (this->MaxRounding < 1.0)\n"),
    of_near("one intersection before allows any number", INTERSECTIONS + "PairFace.cxx",
              "this->Pairs > other.Pairs ||", "(this->Pairs > 0 && other.Pairs == 0) ||"),
    of_near("pairs that touch may pierce each other", INTERSECTIONS + "PairFace.cxx",
              " || this->PiercingPairs > other.PiercingPairs", ""),
    of_near("a pair of two fragments replaces one of a fragment", INTERSECTIONS + "PairFace.cxx",
              " ||\n      this->PairsOfFragments > other.PairsOfFragments", ""),
    of_draft("an undone edit leaves the twins as they are", APPLY,
             "    this->CurrentMesh.RestoreTwins(face.Face, entry.Twins[side]);\n", ""),
    of_draft("a layer is counted once too often", OVERLAY, "this->IsOdd = this->IsOdd != (std::abs(turns) == 3);",
             "this->IsOdd = this->IsOdd || std::abs(turns) == 3;", CERTIFICATE_TESTS),
    of_draft("a distance of the overlay is skipped", OVERLAY, "for (std::size_t i = 0; i < kept->Count; ++i)\n  {\n    const Image& at",
             "for (std::size_t i = 1; i < kept->Count; ++i)\n  {\n    const Image& at", CERTIFICATE_TESTS),
    of_draft("the overlay ends at a hole", OVERLAY, "    if (next < 0)\n    {\n      return false;\n    }\n",
             "    if (next < 0)\n    {\n      continue;\n    }\n", CERTIFICATE_TESTS),
    of_draft("an overlay that is clipped at one side too many", OVERLAY, "Clip(*kept, side, ClipMargin * largest, *next);",
             "Clip(*kept, side, -0.1 * largest, *next);", CERTIFICATE_TESTS),
    of_draft("a joint cover needs two corners of a piece", JOINT, "this->PieceCorners[piece[1]].NearCandidates & this->PieceCorners[piece[2]].NearCandidates;",
             "this->PieceCorners[piece[1]].NearCandidates;", CERTIFICATE_TESTS),
    of_draft("a joint cover forgets half of a piece", JOINT, "  this->OpenPieces.push_back(piece);\n  this->OpenPieces.back()[edge] = made;\n", "",
             CERTIFICATE_TESTS),
    of_draft("the nearest corner bounds a piece of a joint cover", JOINT, "std::max({ a[i], b[i], c[i] })",
             "std::min({ a[i], b[i], c[i] })", CERTIFICATE_TESTS),
    of_draft("a joint cover measures to beyond a side", JOINT, "(outside[i] > 0.0 ? toSide : 0.0)", "(outside[i] > 1.0 ? toSide : 0.0)",
             CERTIFICATE_TESTS),
    of_draft("a joint cover forgets the candidates after the first group", JOINT, "this->Measure(corner, this->MeasuredCandidates);",
             "this->Measure(corner, this->PieceCorners.size() > this->InitialCorners ? this->RoundedCount() : this->MeasuredCandidates);", CERTIFICATE_TESTS),
    of_draft("a candidate that is too far covers a piece", JOINT, "corner.Squared[i] <= this->SquaredLimit ?",
             "corner.Squared[i] <= 1.5 * this->SquaredLimit ?", CERTIFICATE_TESTS),
    of_draft("a far part of an overlay is not covered", CERTIFICATE + "PieceSearch.cxx", "part.Corners.data(), part.Count);",
             "part.Corners.data(), 3);", CERTIFICATE_TESTS),
    of_draft("the near parts of an overlay have no bound", CERTIFICATE + "PieceSearch.cxx",
             "  this->CandidateCover.Raise(this->Overlay->Upper());\n", "", CERTIFICATE_TESTS),
    of_draft("the first corner bounds the distance of a piece", CERTIFICATE + "PieceSearch.cxx", "i < piece.Count && upper < bound; ++i",
             "i < piece.Count && upper < 0.0; ++i", CERTIFICATE_TESTS),
    of_draft("a near triangle counts as the nearest", CERTIFICATE + "Target.cxx", "return near.Value <= sufficient ?",
             "return near.Value <= 2.0 * sufficient ?", CERTIFICATE_TESTS),
    of_draft("points of one plane are merged", CERTIFICATE + "EdgeSides.cxx", "points[table[at]] != points[point]",
             "points[table[at]].x() != points[point].x()", CERTIFICATE_TESTS),
    Mutant("points are smoothed too far", SMOOTHING + "Smoothing.cxx", "radii[p] = std::max(0.0, least);",
           "radii[p] = 1.5 * std::max(0.0, least);", SMOOTHING_TESTS),
    Mutant("octahedra without their margin", SMOOTHING + "DisplacementSets.cxx", "constexpr double Slack = 4e-3;",
           "constexpr double Slack = 0.0;", SMOOTHING_TESTS),
    Mutant("octahedra that are too large", SMOOTHING + "DisplacementSets.cxx", "NumberOfOdd(center) - Slack }",
           "1.2 * NumberOfOdd(center) }", SMOOTHING_TESTS),
    Mutant("edits are proved against the smoothed positions", "Filters/Core/Proof/Reference/Original.h",
           "this->UnsmoothedCopy ? *this->UnsmoothedCopy : this->InitialMesh()", "this->InitialMesh()", SMOOTHING_TESTS),
    Mutant("a constrained point is smoothed", SMOOTHING + "Smoothing.cxx", "radii[p] = std::max(0.0, least);",
           "radii[p] = std::max(1e-3 * settings.Radius, least);", SMOOTHING_TESTS),
    Mutant("neighbors of a constrained point are smoothed", SMOOTHING + "Smoothing.cxx",
           "least = std::min(least, (*input.Limits)[neighbor]);", "least = std::min(least, settings.Radius + neighbor);",
           SMOOTHING_TESTS),
    Mutant("boundary points are smoothed off their boundary", SMOOTHING + "SmoothingGraph.cxx",
           "kind == CurveKind::Boundary ? 0.0", "kind == CurveKind::Boundary ? 1.0", SMOOTHING_TESTS),
    Mutant("smoothing makes intersections", SMOOTHING + "Smoothing.cxx", "while (shouldContinue && !found.empty())",
           "while (shouldContinue && found.empty() && !found.empty())", SMOOTHING_TESTS),
    Mutant("the rule of a face differs between its cells", LABELS + "CellSegments.cxx", "a == c && (b != d || b > a)",
           "a == c && (b != d || this->Face % 2 == 0)", EXTRACTION_TESTS),
    Mutant("normals of mirrored grids are turned", LABELS + "LayerSweep.cxx", "(labels[0] > labels[1]) != this->IsMirrored",
           "labels[0] > labels[1]", EXTRACTION_TESTS),
    Mutant("the labels of a wall are not in order", LABELS + "LayerSweep.cxx", "    std::swap(labels[0], labels[1]);\n", "",
           EXTRACTION_TESTS),
    Mutant("closed surfaces lack a cap", LABELS + "VoxelLayers.cxx",
           "  std::fill_n(row, padding * (width + 2 * padding), 0);\n}", "  std::fill_n(row, padding * (width + 2 * padding), 1);\n}",
           EXTRACTION_TESTS),
    Mutant("open surfaces are guarded along one axis", GUARD + "VoxelPatch.cxx",
           "this->KeepsAlong(0, mirrored) && this->KeepsAlong(1, mirrored) &&\n      this->KeepsAlong(2, mirrored);",
           "this->KeepsAlong(0, mirrored);", GUARD_TESTS),
    Mutant("columns across the wrong axes", GUARD + "VoxelPatch.cxx", "this->KeepsColumn({ axis, firstS + at % across,",
           "this->KeepsColumn({ s, firstS + at % across,", GUARD_TESTS),
    Mutant("ties are not antisymmetric", GUARD + "ColumnCrossing.cxx", "dt != 0 ? -SignOfNumber(dt) : SignOfNumber(ds)",
           "dt != 0 ? 1 : SignOfNumber(ds)", GUARD_TESTS),
    Mutant("heights are not exact", GUARD + "ColumnCrossing.cxx", ": this->ExactSign(fromR);", ": this->Side;", GUARD_TESTS),
    Mutant("the margin is not kept", GUARD + "VoxelGuard.cxx", "!patch.IsNearCenter(this->Settings.Margin) &&", "",
           GUARD_TESTS),
    Mutant("the rim of an open surface may come near an edge of the grid", GUARD + "VoxelGuard.cxx",
           "(!isOpen || this->KeepsRim(mesh, change, patch))", "true", GUARD_TESTS),
    Mutant("crossings of different labels cancel", GUARD + "VoxelPatch.cxx", "sum.Below == below && sum.Label == label",
           "sum.Below == below", GUARD_TESTS),
    Mutant("a collapse of a curve between labels is checked on one wall alone", GUARD + "VoxelPatch.cxx",
           "if (crossing.Sign != 0)", "if (crossing.Sign != 0 && face.Labels == this->Faces.front().Labels)", GUARD_TESTS),
    Mutant("positions are guarded as they are before rounding", GUARD + "VoxelGuard.cxx",
           "this->Settings.Rounding.Of(absolute)", "absolute", GUARD_TESTS),
    Mutant("the check voxelizes mirrored grids the wrong way around", LABELS + "VoxelRows.cxx",
           "(winding > 0) != this->Rows.IsMirrored", "(winding > 0)", CHECK_TESTS),
    Mutant("the check counts an end of an edge twice", LABELS + "VoxelRows.cxx", "b[2] <= p[2] && p[2] < a[2]",
           "b[2] <= p[2] && p[2] <= a[2]", CHECK_TESTS),
    Mutant("the check does not see a voxel without a label", LABELS + "VoxelCheck.cxx", "if (before[i] != after[i])",
           "if (before[i] != after[i] && after[i] >= 0)", CHECK_TESTS),
    Mutant("the check leaves out the outermost voxels", LABELS + "VoxelCheck.cxx", "this->IsOpen ? 1 : 0;\n    SliceSum",
           "1;\n    SliceSum", CHECK_TESTS),
    Mutant("the check begins open rows in the background", LABELS + "VoxelRows.cxx",
           "isOpen ? FirstLabel(all, this->Next) : this->Rows.Background",
           "isOpen ? this->Rows.Background : this->Rows.Background", CHECK_TESTS),
    Mutant("the check takes the first crossing in the list for the first on the row", LABELS + "VoxelRows.cxx",
           "isOpen ? FirstLabel(all, this->Next)", "isOpen ? all[this->Next].Labels[0]", CHECK_TESTS),
    Mutant("rounding decides which voxels of an open surface are outermost", LABELS + "VoxelCheck.cxx",
           "endsAtImage ? Intersection(both, BoxOf(settings.Grid)) : both;", "endsAtImage && both.Count[0] < 0 ? Intersection(both, BoxOf(settings.Grid)) : both;", CHECK_TESTS),
    Mutant("points that never move are guarded as they are before rounding", INTERSECTIONS + "WrittenPositions.cxx",
           "vertex, local, this->Rounds);",
           "vertex, local, local == this->Clean->Surface.Points[vertex] ? PointRounding() : this->Rounds);",
           "FlatIntersectionGuard*"),
    of_draft("narrow triangles cost no more than others", "Filters/Core/Decimate/Cost/ShapePenalty.h", "return this->Weight * r * r;",
             "return this->Weight / (1.0 + r * r);", SHAPE_TESTS),
    of_draft("shapes do not count without an angle", "Filters/Core/Decimate/Stages/Refinement.cxx", "editor.LimitsEdits() ? 0.0 : shapeWeight",
             "editor.LimitsEdits() ? shapeWeight : 0.0", SHAPE_TESTS),
    of_draft("only one of the new triangles must have the least angle", "Filters/Core/Proof/EditFilters/ShapeFilter.cxx",
             "after = std::max(after,", "after = std::min(after + 1.0,", SHAPE_TESTS),
    of_draft("an angle may become smaller if the one before was below the least", "Filters/Core/Proof/EditFilters/ShapeFilter.cxx",
             "PositionsOf(mesh, face)) >= after;", "PositionsOf(mesh, face)) >= limit;", SHAPE_TESTS),
    of_draft("a long edge may be made", "Filters/Core/Proof/EditFilters/ShapeFilter.cxx",
             "!this->Limits.LimitsEdges() ||", "true ||", SPLIT_TESTS),
    of_draft("a split mixes up the halves of a face", "Filters/Core/Proof/EditFilters/SurfaceChange.cxx",
             "{ face, { a, vertex, c }, {", "{ made, { a, vertex, c }, {", SPLIT_TESTS),
    of_draft("a split counts as proved", "Filters/Core/Decimate/Edit/EditorCheck.cxx",
             "decision = this->RunFilters(workspace);",
             "decision = this->RunFilters(workspace); decision = edit.Kind == EditKind::Split ? Decision::Accept() : decision;", SPLIT_TESTS),
    Mutant("a split gives a face the labels of the removed one", "Filters/Core/Mesh/HalfEdgeMesh.cxx",
           "this->InputFaces[made] = this->InputFaces[Face(h)];", "", SPLIT_TESTS),
    of_draft("an id that a split takes stays free", APPLY,
             "this->FreeVertexIds->Take(edit.Keep);", "", SPLIT_TESTS),
    of_draft("struts of bone are cut as tunnels are closed", "Filters/Core/Repair/Tunnels/CloseTunnels.cxx",
             ": inwards < -clear * all   ? Surrounded::Bone", ": inwards < -clear * all   ? Surrounded::Tunnel", TUNNEL_TESTS),
    of_draft("plugs may intersect the surface", "Filters/Core/Repair/Tunnels/TunnelPlug.cxx", " || this->Intersects(plug))", ")", TUNNEL_TESTS),
)
