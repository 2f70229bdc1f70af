// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearVictims.h
 * @brief Random surfaces whose parts are nearer to each other than the largest error, so that they
 * could pass through each other.
 *
 *     rings:    thin tubes; some dip below others, so that straightening would link or unlink them;
 *               or two handles of one component
 *     plates:   boxes thinner than the error, or open plates, one above the other, with specks
 *               between them
 *     shells:   spheres within spheres, turned inside out or not
 *     specks:   tetrahedra near a ball, inside or outside of it, and in spikes
 */
#ifndef BoneDecimate_Testing_NearVictims_h
#define BoneDecimate_Testing_NearVictims_h

#include "Geometry/Surface.h"
#include "Random.h"
#include "Tubes.h"

#include <cstddef>
#include <vector>

namespace bonedecimate::testsupport
{
struct NearVictim
{
  bonedecimate::Surface Surface;
  double Error = 0.0; // mm

  /// A ring that remains around its axis, whatever moves by the error, and a point of it to which
  /// all others remain farther away.
  struct Ring
  {
    Axis Hole;
    Vector3 Start;
  };
  std::vector<Ring> Rings;
  bool AreHandles = false; // of one component

  /// From each vertex of a component that is in the middle of the plates, the ray meets another
  /// one.
  struct View
  {
    std::size_t From;
    std::size_t To;
    Vector3 Direction;
  };
  std::vector<View> Views;
  Axis Middle;         // of the plates
  double Radius = 0.0; // mm, about it
};

/// Triangles that do not intersect, at random position and rotation.
NearVictim AnyNearVictim(Random& random);
}

#endif
