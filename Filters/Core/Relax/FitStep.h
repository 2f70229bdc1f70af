// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FitStep.h
 * @brief The normal equations of one vertex that is fitted to places near its faces: one Gauss-Newton step.
 *
 *     with b the share of the vertex in the nearest place, r the way from it to the place, n its direction:
 *     H = sum weight b^2 n n^T + damping,   g = sum weight b (n . r) n,   step = H^-1 g
 *
 * H. Hoppe et al., Mesh Optimization, 1993: samples fitted with the nearest places held; A. Fitzgibbon, Robust
 * Registration of 2D and 3D Point Sets, 2003: distances to planes instead of places make the steps long.
 */
#ifndef BoneDecimate_Core_Relax_FitStep_h
#define BoneDecimate_Core_Relax_FitStep_h

#include "Geometry/TriangleFrame.h"

#include <Eigen/Dense>

#include <array>

namespace bonedecimate
{
class FitStep
{
public:
  void Clear() { *this = {}; }

  /// A sample that wants the surface to come to it. The vertex is corner A of the frame.
  /// @param place The nearest to p on the frame's triangle.
  void AddSample(
    const Vector3& p, const TriangleFrame& frame, const TriangleFrame::Place& place, double weight)
  {
    const double share = 1.0 - place.B - place.C;
    if (share > 0.0)
    {
      this->Add(p - frame.At(place), frame, place, share, weight);
    }
  }
  /// The vertex itself, which should come to the place nearest on the original triangle of the frame.
  void AddVertex(const Vector3& vertex, const TriangleFrame& frame,
    const TriangleFrame::Place& place, double weight)
  {
    this->Add(frame.At(place) - vertex, frame, place, 1.0, weight);
  }
  /// A point on an edge at the vertex, as above.  @param share Of the vertex.
  void AddOnEdge(const Vector3& point, const TriangleFrame& frame,
    const TriangleFrame::Place& place, double share, double weight)
  {
    this->Add(frame.At(place) - point, frame, place, share, weight);
  }

  Vector3 Solve() const
  {
    constexpr double damping = 0.005; // of the trace
    const std::array<double, 6>& h = this->Upper;
    const double ridge = damping * (h[0] + h[3] + h[5]);
    if (!(ridge > 0.0))
    {
      return Vector3::Zero();
    }
    Eigen::Matrix3d damped;
    damped << h[0] + ridge, h[1], h[2], h[1], h[3] + ridge, h[4], h[2], h[4], h[5] + ridge;
    return damped.inverse() * this->Pull;
  }

  /// By how much the sum of weighted squares would fall if it were what the equations say.
  double Gain(const Vector3& step) const { return step.dot(this->Pull); }

private:
  void Add(const Vector3& way, const TriangleFrame& frame, const TriangleFrame::Place& place,
    double share, double weight)
  {
    if (place.Clamped == 0)
    {
      this->AddAlong(frame.UnitNormal(), frame.UnitNormal().dot(way), share, weight);
    }
    else if (place.SquaredDistance > 0.0)
    {
      const double length = std::sqrt(place.SquaredDistance);
      this->AddAlong(way / length, length, share, weight);
    }
  }

  void AddAlong(const Vector3& n, double length, double share, double weight)
  {
    const Vector3 scaled = weight * share * n;
    this->Pull += length * scaled;
    const Vector3 twice = share * scaled;
    this->Upper[0] += twice.x() * n.x();
    this->Upper[1] += twice.x() * n.y();
    this->Upper[2] += twice.x() * n.z();
    this->Upper[3] += twice.y() * n.y();
    this->Upper[4] += twice.y() * n.z();
    this->Upper[5] += twice.z() * n.z();
  }

  std::array<double, 6> Upper{};  // xx xy xz yy yz zz of H
  Vector3 Pull = Vector3::Zero(); // g
};
}

#endif
