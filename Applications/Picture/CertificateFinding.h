// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertificateFinding.h
 * @brief The point that a certificate is about: where the tolerance is violated most, or where the
 * distance is largest.
 */
#ifndef BoneDecimate_Applications_CertificateFinding_h
#define BoneDecimate_Applications_CertificateFinding_h

#include "FarthestPoints.h"
#include "Picture.h"
#include "ReportFields.h"

#include <array>
#include <optional>
#include <string>

namespace bonedecimate
{
/// mm; 0 if there is none for all points.
double ToleranceOf(const ReportFields& report);

/// Rounded up, but not above a tolerance that the bound keeps.
std::string UpperText(double upper, double tolerance, int decimals);

/// @param path Of the bounds, with a point at its end.
std::array<double, 3> PositionOf(const ReportFields& report, const std::string& path);

/// The bound below, at the position that has it.
LargestDistance LargestOf(const ReportFields& report, const std::string& path);

/// The path of the direction in which open boundaries violate the tolerance, if nothing else does;
/// empty otherwise.
std::string ViolatingBoundary(const ReportFields& report);

/// The figure of a violation and its meaning: of the tolerance of a point, of the distance of all
/// points, or of the open boundaries, if they alone violate it.
/// @param frame Of the anatomical directions, "LPS" or "RAS"; empty: not known.
std::array<std::string, 2> Violation(const ReportFields& report, const std::string& frame);

/// What the picture of a certificate marks: the largest violation of the tolerance of a point, else
/// the largest distance or, if nothing else violates the tolerance, an open boundary. Empty if the
/// two surfaces are the same.
std::optional<PictureMark> MarkOfCertificate(const std::string& certificate);
}

#endif
