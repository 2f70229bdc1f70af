// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shapes.h
 * @brief Surfaces built in code, mm. Closed ones are counter-clockwise seen from outside.
 */
#ifndef BoneDecimate_Testing_Shapes_h
#define BoneDecimate_Testing_Shapes_h

#include "Geometry/Surface.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
// Closed ---------------------------------------------------------------------

/// Corners at 0 and 1 on the axes.
Surface Tetrahedron();

/// From 0 to 1, each side of cells x cells squares of two triangles.
Surface Cube(Index cells);

/// 20 * 4^levels triangles, all points at the radius.
Surface Icosphere(int levels, double radius);

/// An icosphere whose points move in and out by up to the amplitude (a fraction of the radius) at
/// random.
Surface BumpySphere(int levels, double radius, double amplitude, std::uint64_t seed);

/// 2 * around * across triangles about the z axis, radii 10 and 3.
Surface Torus(Index around, Index across);

/// A block of cells x cells x 3 unit cubes with a square tunnel along z through its middle.
Surface TunnelBlock(Index cells);

/// A plate of 18 x 9 x 3 unit cubes with three square tunnels along z, 1, 2 and 3 wide, with
/// corners at (3, 3), (7, 3), (12, 3).
Surface DrilledPlate();

/// A box of cells x cells x 1 unit cubes.
Surface FlatPlate(Index cells);

/// A sphere with a sphere turned inside out in it: a bone with a cavity.
Surface NestedSpheres(int levels);

/// Closed cone of 2 * sides triangles, 100 high and 0.01 wide: all its sides are needles.
Surface Needles(Index sides);

/// Tetrahedra and small spheres in turn on a line.
Surface ManyComponents(Index count);

/// Two triangles with the same three points, back to back.
Surface Envelope();

// Closed, with flat parts -----------------------------------------------------

/// Radius 5, height 8: a regular polygon along z, its sides in parts times layers squares; the caps
/// are rings around a center.
Surface Prism(Index sides, Index parts, Index layers);
Surface CappedCylinder(Index around, Index layers);

/// The label of a voxel.
using LabelOf = std::function<int(const std::array<Index, 3>& voxel)>;

/// The surface of one label of a label map, as marching gives it: vertices in the middle between
/// voxels.
Surface LabelSurface(
  const std::array<Index, 3>& size, const Vector3& spacing, const LabelOf& labelOf, int label);

/// An ellipsoid in voxels, and one of its labels 1 to 3: two halves and a core, which touch each
/// other.
Surface VoxelEllipsoid();
Surface LabeledPart(int label);

/// Two spheres, one in the other, at that distance: most edits would make them intersect.
Surface NearSpheres(int levels, double gap);

// Open -----------------------------------------------------------------------

Surface SingleTriangle();

/// cells x cells unit squares of two triangles in the plane z = 0.
Surface Grid(Index cells);

/// A grid whose inner points have random heights up to the amplitude; the boundary stays straight.
Surface HeightField(Index cells, double amplitude, std::uint64_t seed);

/// A grid without the middle third of its cells: two straight-sided boundaries. Cells must be a
/// multiple of 3.
Surface HoledPlate(Index cells);

/// Radius 5, open at both ends: two round boundaries.
Surface OpenCylinder(Index around, Index rings);

/// Annulus of outer radius 10 and inner radius 4 in a plane.
Surface Annulus(Index around, Index rings);

// Not manifold ---------------------------------------------------------------

/// Two open cones whose tips are one point, the sides split rings times.
Surface PinchedVertex(Index around, Index rings);

/// Two closed cones of which the tips are one point.
Surface PinchedSolids(Index around);

/// Regular tetrahedra, each with one corner in common with the next; inner ones have two
/// other corners.
Surface TetrahedronChain(Index count);

/// Three half planes of cells x cells squares with a common edge.
Surface ThreeLeavedBook(Index cells);

/// One-sided: along one row of edges both triangles run in the same direction.
Surface MoebiusStrip(Index around, Index across);

/// A grid of which one triangle in the middle is turned over.
Surface InconsistentGrid(Index cells);

/// An icosphere of which the first triangles stand there twice.
Surface DuplicateTriangles(int levels, Index copies);

/// The ball of that radius in cells, cut by the plane x = 0 into two with a common wall: three
/// patches meet at its rim. Has cells that touch along an edge or in a corner. Smoothed.
Surface HalvedBall(Index radius);

/// Random triangles over few points, with all kinds of non-manifold edges.
Surface RandomSoup(Index points, Index triangles, std::uint64_t seed);

// Changes of a surface -------------------------------------------------------

/// Every triangle with three points of its own, as in STL.
Surface Unwelded(const Surface& surface);

/// Every point halfway to the mean of its neighbors, so many times; all points must be used.
Surface Smoothed(Surface surface, int times);
Surface Moved(Surface surface, const Vector3& offset);
Surface Scaled(Surface surface, double factor);
Surface TurnedInsideOut(Surface surface);

/// Both surfaces in one; the points of the second come after those of the first.
Surface Together(Surface first, const Surface& second);

// Lists ----------------------------------------------------------------------

struct NamedSurface
{
  std::string Name;
  bonedecimate::Surface Surface;
};

/// Manifold and closed, some in several components.
std::vector<NamedSurface> ClosedShapes();
/// Manifold with boundaries.
std::vector<NamedSurface> OpenShapes();
/// Something is not manifold or not consistently oriented.
std::vector<NamedSurface> BrokenShapes();
std::vector<NamedSurface> AllShapes();
}

#endif
