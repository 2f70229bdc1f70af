// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportFields.h
 * @brief The report in the field data of a result, read by the names of its entries.
 */
#ifndef BoneDecimate_Applications_ReportFields_h
#define BoneDecimate_Applications_ReportFields_h

#include "vtkPolyData.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * Names are those of ReportTable.h. Of a surface with a label map there are also label_names.3, the
 * name of label 3, for each label that has one, and voxel_grid.smallest_spacing (mm).
 */
class ReportFields
{
public:
  /// @param result Output port 0 of vtkBoneDecimate; may be null or carry no report at all.
  explicit ReportFields(vtkPolyData* result);

  /// @param json A report or a certificate; anything else has no entries.
  explicit ReportFields(const std::string& json);

  std::optional<double> Number(const std::string& name) const;

  /// The value as text, numbers included; empty where the entry is missing.
  std::string Text(const std::string& name) const;

  /// The names that begin with this, in the report's order.
  std::vector<std::string> NamesBelow(const std::string& beginning) const;

private:
  void AddLabelMap(vtkPolyData* result);

  struct Field
  {
    std::string Name;
    std::optional<double> Number;
    std::string Text;
  };
  const Field* Find(const std::string& name) const;

  std::vector<Field> Fields; // in the order of the report
};

/// A count of the input, "triangles" or "components", before components were pruned.
std::optional<double> CountBeforePruning(const ReportFields& report, const std::string& what);
}

#endif
