// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FitStep.h
 * @brief The normal equations of one vertex that is fitted to points near its faces: one
 * Gauss-Newton step.
 *
 *     H = sum weight b^2 n n^T + damping,   g = sum weight b (n . r) n,   step = H^-1 g
 *
 *     b   barycentric coordinate of the vertex at the nearest point
 *     r   residual vector        n   its direction
 *
 * H. Hoppe et al., Mesh optimization, 1993: samples are fitted with constant nearest points. A.
 * Fitzgibbon, Robust registration of 2D and 3D point sets, 2003: distances to planes instead of
 * points allow longer steps.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_FitStep_h
#define BoneDecimate_Core_Decimate_Stages_FitStep_h

#include "Decimate/Cost/ShapePenalty.h"
#include "Geometry/TriangleFrame.h"

#include <Eigen/Dense>

#include <array>

namespace bonedecimate
{
class FitStep
{
public:
  void Clear() { *this = {}; }

  /// Adds a sample, which attracts the surface. The vertex is corner A of the frame.
  /// @param nearest The point of the frame nearest to p.
  void AddSample(const Vector3& p, const TriangleFrame& frame, const TriangleFrame::Point& nearest,
    double weight)
  {
    const double fraction = 1.0 - nearest.B - nearest.C;
    if (fraction > 0.0)
    {
      this->Add(p - frame.At(nearest), frame, nearest, fraction, weight);
    }
  }
  /// Adds the vertex, which is attracted to the nearest point of an original triangle, the frame.
  void AddVertex(const Vector3& vertex, const TriangleFrame& frame,
    const TriangleFrame::Point& nearest, double weight)
  {
    this->Add(frame.At(nearest) - vertex, frame, nearest, 1.0, weight);
  }
  /// Adds a point on an edge at the vertex, likewise. @param fraction Weight of the vertex.
  void AddOnEdge(const Vector3& point, const TriangleFrame& frame,
    const TriangleFrame::Point& nearest, double fraction, double weight)
  {
    this->Add(frame.At(nearest) - point, frame, nearest, fraction, weight);
  }

  /// Adds the shape of a triangle with the vertex as corner A.
  void AddShape(const ShapePenalty::Slope& slope)
  {
    this->Pull += slope.Pull;
    this->Upper[0] += slope.Stiffness;
    this->Upper[3] += slope.Stiffness;
    this->Upper[5] += slope.Stiffness;
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

  /// The decrease of the sum of weighted squares that the equations predict.
  double Gain(const Vector3& step) const { return Dot(step, this->Pull); }

private:
  void Add(const Vector3& residual, const TriangleFrame& frame, const TriangleFrame::Point& nearest,
    double fraction, double weight)
  {
    if (nearest.Clamped == 0)
    {
      this->AddAlong(frame.UnitNormal(), Dot(frame.UnitNormal(), residual), fraction, weight);
    }
    else if (nearest.SquaredDistance > 0.0)
    {
      const double length = std::sqrt(nearest.SquaredDistance);
      this->AddAlong(residual / length, length, fraction, weight);
    }
  }

  void AddAlong(const Vector3& n, double length, double fraction, double weight)
  {
    const Vector3 scaled = weight * fraction * n;
    this->Pull += length * scaled;
    const Vector3 twice = fraction * scaled;
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
