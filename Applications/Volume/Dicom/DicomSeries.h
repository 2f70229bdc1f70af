// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomSeries.h
 * @brief Which slices of many belong together, and where each of them lies.
 */
#ifndef BoneDecimate_Applications_DicomSeries_h
#define BoneDecimate_Applications_DicomSeries_h

#include "Volume.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// What is taken from the header of one slice: its geometry and the meaning of its values, no more.
struct DicomSlice
{
  std::string File;
  std::string Series;        ///< Unique identifier of the series; compared, never written anywhere.
  std::string Description;   ///< Description of the series, UTF-8; written to no report.
  std::string Instance;      ///< Unique identifier of the image, to find copies of one file.
  bool IsTomography = false; ///< CT.
  std::int64_t Frames = 1;
  std::int64_t Frame = 0;        ///< Index of the frame in an enhanced image.
  std::int64_t FramesInFile = 1; ///< Number of frames in an enhanced image.
  std::int64_t Rows = 0;
  std::int64_t Columns = 0;
  Vector3 Position{ { 0.0, 0.0, 0.0 } };    ///< mm, of the first pixel.
  Vector3 AlongRow{ { 0.0, 0.0, 0.0 } };    ///< Direction of growing column index.
  Vector3 AlongColumn{ { 0.0, 0.0, 0.0 } }; ///< Direction of growing row index.
  double RowDistance = 0.0;                 ///< mm, from a row to the next.
  double ColumnDistance = 0.0;
  double Slope = 1.0; ///< Stored value times slope plus intercept is HU.
  double Intercept = 0.0;
  /// Least and largest stored value of pixels that were not measured.
  std::optional<std::array<double, 2>> Padding;
};

struct DicomSeries
{
  std::vector<DicomSlice> Slices; ///< By position.
  VolumeGeometry Geometry;        ///< The step along k is the mean of the distances.
  LayerPositions Layers;
  std::string Problem;
  std::string Note;
  std::string Remark; ///< Remark of the Volume; may be empty.
};

using DicomSlices = std::vector<DicomSlice>;

/// The slices, in any order, by series; CT before any other modality, then the largest first.
std::vector<DicomSlices> GroupSeries(const DicomSlices& slices);

/// "24 slices in S1/S20 from IM0001.dcm on". @param folder The folder above them.
std::string GroupText(const DicomSlices& group, const std::string& folder);

/// Takes one of the groups.
/// @param isRequested Whether the user requested it; otherwise the note names the others.
DicomSeries TakeSeries(const std::vector<DicomSlices>& groups, std::size_t index, bool isRequested,
  const std::string& folder);
}

#endif
