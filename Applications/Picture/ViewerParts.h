// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ViewerParts.h
 * @brief What the interactive view switches on and off: labels, or components.
 */
#ifndef BoneDecimate_Applications_ViewerParts_h
#define BoneDecimate_Applications_ViewerParts_h

#include "NamedLabels.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct ViewerPart
{
  std::string Name;
  std::optional<LabelColor> Color; ///< Color of the label, if it has one.
};

/// Triangles of a surface that belong to the same parts: a wall between two labels belongs to both.
struct ViewerPiece
{
  std::vector<std::size_t> Parts; ///< One or two.
  std::vector<vtkIdType> Triangles;
};

/// Divides the surfaces of a run in the same way.
class ViewerDivision
{
public:
  /**
   * @param original A surface of triangles.
   * @param labels The labels in its BoundaryLabels, without the background. If there are none, its
   * components are the parts, the largest first. Beyond forty the small ones are one part together.
   */
  ViewerDivision(vtkPolyData* original, const std::vector<NamedLabel>& labels);

  const std::vector<ViewerPart>& GetParts() const { return this->Parts; }

  /// The pieces of the original or of a result. A component of a result is that of the original
  /// nearest to most of its points.
  std::vector<ViewerPiece> Divide(vtkPolyData* triangles) const;

private:
  void AddLabels(const std::vector<NamedLabel>& labels);
  void AddComponents(vtkPolyData* original);
  std::vector<ViewerPiece> DivideByLabel(vtkPolyData* triangles) const;
  std::vector<ViewerPiece> DivideByComponent(vtkPolyData* triangles) const;
  std::vector<std::size_t> PartsOfRegions(
    vtkPolyData* regions, const std::vector<std::size_t>& regionOfPoint) const;

  std::vector<ViewerPart> Parts;
  std::map<std::int64_t, std::size_t> PartOfLabel;     // empty: components
  std::vector<std::size_t> PartOfPoint;                // of the original, by components
  vtkSmartPointer<vtkStaticPointLocator> NearestPoint; // of the original, by components
};
}

#endif
