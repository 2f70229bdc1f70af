// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartFigures.h
 * @brief Area, volume and thickness of each component or label before and after a run that
 * smoothed.
 */
#ifndef BoneDecimate_Core_Figures_PartFigures_h
#define BoneDecimate_Core_Figures_PartFigures_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace bonedecimate
{
/// mm, lengths of lines inside of a part; NaN if there are none.
struct ThicknessFigures
{
  double Median = std::numeric_limits<double>::quiet_NaN();
  double Percentile5 = std::numeric_limits<double>::quiet_NaN(); ///< 5 % are less.
};

struct PartMeasures
{
  double Area = 0.0;                                        ///< mm^2
  double Volume = std::numeric_limits<double>::quiet_NaN(); ///< mm^3; NaN if it is not closed.
  ThicknessFigures Thickness;                               ///< Only for listed parts.
};

struct PartFigures
{
  std::string Label;                ///< Empty: a component.
  std::int64_t Triangles = 0;       ///< Number of input triangles.
  Vector3 Center = Vector3::Zero(); ///< mm, the middle of its box in the input.
  PartMeasures Input;
  PartMeasures Output;

  /// As a fraction of the volume in the input, with its sign; 0 if the part is not closed.
  double VolumeChange() const;
  /// As a fraction, of the median or of the percentile, whichever lost more; 0 if thickness was not
  /// measured.
  double ThicknessLoss() const;
  /// Whether the part is smaller than a cube of that volume, mm^3; an open part: whether its area
  /// is less than that of the cube.
  bool IsSmallerThan(double volume) const;
};

struct PartComparison
{
  enum class Kind : int
  {
    NotCompared = 0,
    Components,
    Labels
  };
  /// The report lists the largest, and thickness is measured of them alone.
  static constexpr std::size_t MaxListed = 32;

  Kind Of = Kind::NotCompared;    ///< If NotCompared, all other members are meaningless.
  double MinVolume = 0.0;         ///< mm^3; there are no warnings about smaller parts.
  std::vector<PartFigures> Parts; ///< Sorted by their area in the input, largest first.
};

/// Parts whose volume changed by more than a tenth, and parts that lost more than a fifth of their
/// thickness.
std::vector<std::string> PartWarnings(const PartComparison& compared);
}

#endif
