// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ViewerMesh.h
 * @brief Surfaces as the interactive view reads them (Viewer/decode.js): quantized and compressed.
 */
#ifndef BoneDecimate_Applications_ViewerMesh_h
#define BoneDecimate_Applications_ViewerMesh_h

#include "ViewerParts.h"

#include "vtkBoundingBox.h"
#include "vtkPolyData.h"

#include <array>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Coordinates are whole numbers of steps from the origin: 0 to 65535.
struct QuantizationGrid
{
  explicit QuantizationGrid(const vtkBoundingBox& box);

  std::array<double, 3> Origin; ///< mm
  double Step; ///< mm, along all axes; a coordinate is rounded by half of it at most.
};

/// Distances are bytes, rounded down, so that none looks larger than its bound: 255 is the end of
/// the range, or more.
struct QuantizedDistances
{
  std::string ArrayName;  ///< Point array of distances, mm; empty: the surface has none.
  double Range = 1.0;     ///< Where the colors end, mm.
  double Largest = 0.0;   ///< mm, among all surfaces.
  double Tolerance = 0.0; ///< mm; bytes of larger distances are above 127. 0: none.
};

struct EncodedPiece
{
  std::vector<std::size_t> Parts;
  vtkIdType Points = 0;
  vtkIdType Triangles = 0;
};

struct EncodedSurface
{
  std::vector<EncodedPiece> Pieces;
  bool HasDistances = false;
  std::string Base64;
};

/**
 * The same surface gives the same bytes. Each piece has points of its own, in the order of their
 * first use; points at a boundary between pieces are rounded to the same position in both.
 * @param triangles A surface of triangles alone. @param pieces Pieces of these triangles.
 */
EncodedSurface EncodeSurface(vtkPolyData* triangles, const std::vector<ViewerPiece>& pieces,
  const QuantizationGrid& grid, const QuantizedDistances& distances);
}

#endif
