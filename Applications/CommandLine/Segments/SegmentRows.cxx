// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentRows.h"

#include <numeric>
#include <string>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::json;

Json At(const Json& json, const std::string& pointer)
{
  const Json::json_pointer at(pointer);
  return json.is_object() && json.contains(at) ? json[at] : Json();
}

/// The entry of the list of parts, whose labels are texts; null: it is not listed.
Json PartOf(const Json& report, const std::string& label)
{
  for (const Json& part : At(report, "/parts/list"))
  {
    if (At(part, "/label") == label)
    {
      return part;
    }
  }
  return {};
}

/// mm3, of all components; null if some are not listed.
Json VolumeOf(const Json& segment)
{
  const Json volumes = At(segment, "/volumes");
  const bool areAll = volumes.is_array() && At(segment, "/components") == volumes.size();
  return areAll ? Json(std::accumulate(volumes.begin(), volumes.end(), 0.0,
                    [](double sum, const Json& one) { return sum + one.get<double>(); }))
                : Json();
}
}

std::vector<Json> SegmentRows(const Json& report)
{
  std::vector<Json> rows;
  for (const Json& segment : At(report, "/segments/list"))
  {
    const std::string label = At(segment, "/label").dump();
    const Json part = PartOf(report, label);
    const std::string voxels = "/voxels/of_" + label;
    Json row = { { "label", At(segment, "/label") }, { "segment", At(segment, "/name") },
      { "triangles", At(segment, "/triangles") }, { "components", At(segment, "/components") },
      { "volume_out_mm3", VolumeOf(segment) }, { "voxels", At(report, voxels + "/voxels") },
      { "voxels_lost", At(report, voxels + "/lost") },
      { "voxels_gained", At(report, voxels + "/gained") } };
    row["volume_in_mm3"] = At(part, "/input/volume");
    for (const std::string side : { "in", "out" })
    {
      const std::string of = side + "put";
      row["area_" + side + "_mm2"] = At(part, "/" + of + "/area");
      row["thickness_" + side + "_mm"] = At(part, "/" + of + "/thickness_median");
      row["thickness_percentile_5_" + side + "_mm"] =
        At(part, "/" + of + "/thickness_percentile_5");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}
}
