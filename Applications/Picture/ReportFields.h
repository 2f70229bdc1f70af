// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReportFields.h
 * @brief The report as it travels in the field data of a result: read by its names.
 */
#ifndef BoneDecimate_Applications_ReportFields_h
#define BoneDecimate_Applications_ReportFields_h

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Names are those of ReportTable.h, without the prefix of the field data.
class ReportFields
{
public:
  /// @param result Output port 0 of vtkBoneDecimate; may be null or carry no report at all.
  explicit ReportFields(vtkPolyData* result);

  std::optional<double> Number(const std::string& name) const;

  /// The value as text, numbers included; empty where the entry is missing.
  std::string Text(const std::string& name) const;

  /// The names that begin with this, in the report's order.
  std::vector<std::string> NamesBelow(const std::string& beginning) const;

private:
  vtkFieldData* Fields = nullptr;
};
}

#endif
