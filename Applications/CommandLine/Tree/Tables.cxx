// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/Tables.h"

#include "Figures/Rejection.h"
#include "Formats/SurfaceFormat.h"
#include "Options/Modes.h"
#include "Options/Options.h"

#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

Json ModesJson()
{
  Json modes = Json::array();
  for (const ModeInfo& mode : ModeTable())
  {
    modes.push_back({ { "name", mode.Name }, { "use", mode.Text.Use }, { "order", mode.Text.Order },
      { "position", mode.Text.Position }, { "refinement", mode.Text.Refinement },
      { "proves_error", mode.ProvesError() }, { "is_default", mode.Mode == Options().Mode } });
  }
  return modes;
}

Json FormatsJson()
{
  Json formats = Json::array();
  for (const SurfaceFormat* format : SurfaceFormats())
  {
    formats.push_back({ { "extension", format->Extension }, { "holds_arrays", format->HoldsArrays },
      { "holds_doubles", format->HoldsDoubles }, { "keeps_points", format->KeepsPoints },
      { "names_unit", format->NamesUnit }, { "has_grid", format->HasGrid },
      { "missing_library", format->MissingLibrary } });
  }
  return formats;
}

Json RejectionsJson()
{
  Json reasons = Json::array();
  for (const RejectionInfo& row : RejectionTable)
  {
    if (row.Reason != Rejection::NotRejected)
    {
      reasons.push_back({ { "word", row.Word }, { "sentence", row.Sentence } });
    }
  }
  return reasons;
}
}

std::string TablesJson()
{
  const Json tables = { { "modes", ModesJson() }, { "formats", FormatsJson() },
    { "rejections", RejectionsJson() } };
  return tables.dump(2) + "\n";
}
}
