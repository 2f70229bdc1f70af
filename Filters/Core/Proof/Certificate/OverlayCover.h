// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OverlayCover.h
 * @brief An upper bound of the distance from a triangle T to a surface of which a connected part
 * covers T. It needs no cuts.
 *
 *     map the plane of T to coordinates (b, c), and each point of the surface to the coordinates
 *       where a line through it meets that plane; the line has the direction of the mean normal of
 *       the surface near the corners of T
 *     from triangles of the surface near the corners, cross every edge whose image meets T
 *         an edge that does not have exactly two triangles:                          no bound
 *     an even number of images over one position in T:                               no bound
 *     else the images cover T; each part, the overlay of T and an image, is bounded by the
 *       largest distance between a corner of the part and the point with this image
 *
 * Proof. Every edge of the visited triangles whose image meets T belongs to two of them, so no
 * position in T is on the boundary of their chain (coefficients modulo 2), and the parity of the
 * number of images is the same all over T. It is odd at one position, so every position t of T is
 * the image of a point x of the surface. On the overlay of T and one image, t - x is affine, so its
 * length is largest at a corner. The parts cover T, so each of them may also be bounded in another
 * way.
 *
 * Rounding. The map is defined by the computed coordinates of the points and is linear on each
 * triangle; the proof holds for any x - t. Predicates compare these coordinates exactly or have an
 * error bound; in doubt an edge meets T. An image is clipped at T widened by ClipMargin, so the
 * polygon contains the exact one; its corners carry coordinates and positions. T must not be
 * thinner than MinHeight, so the rounding error of a corner is below 1000 u of the extent (Foot.h).
 */
#ifndef BoneDecimate_Core_Proof_Certificate_OverlayCover_h
#define BoneDecimate_Core_Proof_Certificate_OverlayCover_h

#include "Foot.h"
#include "Simplices.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate::certificate
{
/// An object serves one worker; its memory is proportional to the surface.
class OverlayCover
{
public:
  /// @param surface Must outlive this.
  explicit OverlayCover(const Simplices& surface);

  /// The overlay of T and an image, a polygon.
  struct Part
  {
    std::array<Vector3, 9> Corners; ///< mm, in T but for rounding
    std::size_t Count = 0;
    std::size_t Farthest = 0; ///< the corner where the bound is taken
    double Upper = 0.0;       ///< mm
    Index Nearest = None;     ///< the triangle of the surface
  };

  /// @param seeds Triangles of the surface near the corners of T.
  /// @param limit mm; parts with larger bounds are far.
  /// @return Whether T is covered. False also if there are too many far parts.
  bool Find(const Corners& triangle, const Triangle& seeds, double limit);
  /// mm, the largest bound of a part that is not far.
  double Upper() const { return this->UpperOfNear; }
  const std::vector<Part>& FarParts() const { return this->PartsTooFar; }
  /// The triangles that the last search met, the seeds first.
  const std::vector<Index>& Met() const { return this->VisitedTriangles; }

private:
  /// A point of the surface and its image, which has the signed area coordinates 1 - B - C, B and C
  /// in T.
  struct Image
  {
    Vector3 Point; // mm
    double B, C;
  };
  struct KnownImage
  {
    Image At;
    std::uint8_t Beyond = 0; // a bit for each side of T beyond which the image lies
  };
  using ImageTriangle = std::array<const KnownImage*, 3>;
  /// A clipped triangle. Each clip adds a corner, or half as many again if rounding made the
  /// polygon concave.
  struct Polygon
  {
    std::array<Image, 9> Corners;
    std::size_t Count;
  };

  bool Begin(const Corners& triangle, const Triangle& seeds);
  void NextStamp();
  void Add(Index triangle);
  Vector3 Normal(Index triangle) const;
  void Incline(const Vector3& direction);
  Index ImageOf(Index point);
  bool Visit(Index triangle, double limit);
  bool CountLayer(const ImageTriangle& images);
  void Measure(const ImageTriangle& images, Index triangle, double limit);
  Vector3 InPlane(const Image& at) const { return this->A + at.B * this->AB + at.C * this->AC; }
  bool CrossEdges(const ImageTriangle& images, Index triangle);
  static void Clip(const Polygon& polygon, int side, double margin, Polygon& kept);

  const Simplices& Surface;
  const EdgeSides& Sides;
  Vector3 A, AB, AC;        // mm, of T
  Vector3 TowardB, TowardC; // 1/mm, gradients of the coordinates
  std::uint32_t Stamp = 0;  // marks what belongs to the current T
  std::vector<std::uint32_t> TriangleStamps, PointStamps;
  std::vector<Index> ImageIndices; // position in Images of each point with the current stamp
  std::vector<KnownImage> Images;
  std::vector<Index> VisitedTriangles; // triangles of the surface, in order
  bool IsOdd = false;                  // whether the number of images over the test position is odd
  double UpperOfNear = 0.0;            // mm
  std::vector<Part> PartsTooFar;
  std::size_t FarCorners = 0; // of all parts
};
}

#endif
