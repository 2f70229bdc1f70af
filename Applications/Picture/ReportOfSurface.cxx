// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportOfSurface.h"

#include "Run/Report/ProofSentence.h"

#include "vtkBoneDecimateAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr const char* const ReportName = "BoneDecimateReport";
constexpr const char* const Sealed = "if_unchanged";

std::string ReportText(vtkPolyData* surface)
{
  auto* const array = surface != nullptr
    ? vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(ReportName))
    : nullptr;
  return array != nullptr && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0))
                                                            : std::string();
}

/// The units of the proof have its names.
Json WithProofNames(const Json& units, const std::string& from, const std::string& to)
{
  Json renamed = Json::object();
  for (const auto& [name, unit] : units.items())
  {
    const bool isProof = name.compare(0, from.size(), from) == 0;
    renamed[isProof ? to + name.substr(from.size()) : name] = unit;
  }
  return renamed;
}

const std::string ProofName = "proof.";
const std::string SealedName = "proof.if_unchanged.";

double NumberOr(const Json& json, const char* name, double other)
{
  return json.contains(name) && json[name].is_number() ? json[name].get<double>() : other;
}

LeftOut LeftOutFrom(const Json& entry)
{
  LeftOut found;
  found.Kind = entry.value("kind", "");
  found.Count = entry.value("count", std::int64_t{ 0 });
  found.What = entry.value("what", "");
  found.Where = entry.value("where", "");
  found.Distance = NumberOr(entry, "distance", found.Distance);
  return found;
}
}

Json ReportOf(vtkPolyData* surface)
{
  Json report = Json::parse(ReportText(surface), nullptr, false);
  if (!report.is_object())
  {
    return Json::object();
  }
  const Json::json_pointer checksum("/output/checksum");
  if (report.contains("proof") && report["proof"].is_object() && report["proof"].contains(Sealed))
  {
    const bool isProved = report.contains(checksum) &&
      report[checksum] == vtkBoneDecimateAlgorithm::GetTriangleChecksum(surface);
    report["proof"] =
      isProved ? Json(report["proof"][Sealed]) : Json({ { "sentence", ChangedSurfaceSentence } });
    if (report.contains("units"))
    {
      report["units"] = WithProofNames(report["units"], SealedName, ProofName);
    }
  }
  UpdateSentences(report);
  return report;
}

//------------------------------------------------------------------------------
void UpdateSentences(Json& report)
{
  std::vector<LeftOut> leftOut;
  if (report.contains("left_out"))
  {
    for (Json& entry : report["left_out"])
    {
      leftOut.push_back(LeftOutFrom(entry));
      entry["sentence"] = leftOut.back().Sentence();
    }
  }
  if (report.contains("proof") && report["proof"].contains("upper"))
  {
    Json& proof = report["proof"];
    proof["sentence"] = ProofSentence({ NumberOr(proof, "upper", Infinity),
      report.contains("reference"), proof.value("boundaries", ""), std::move(leftOut), 0.0 });
  }
}

//------------------------------------------------------------------------------
void SetReportOf(Json report, vtkPolyData* surface)
{
  report["output"]["checksum"] = vtkBoneDecimateAlgorithm::GetTriangleChecksum(surface);
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(surface->GetFieldData());
  vtkNew<vtkStringArray> checksum;
  checksum->SetName("bonedecimate.output.checksum");
  checksum->InsertNextValue(report["output"]["checksum"].get<std::string>());
  fields->AddArray(checksum);
  if (report.contains("proof"))
  {
    Json proof = std::move(report["proof"]);
    const std::string sentence = SentenceBoundToSurface(proof.value("sentence", ""));
    if (proof.contains("upper"))
    {
      vtkNew<vtkDoubleArray> upper;
      upper->SetName("bonedecimate.proof.if_unchanged.upper");
      upper->SetComponentName(0, "mm");
      upper->InsertNextValue(NumberOr(proof, "upper", Infinity));
      fields->AddArray(upper);
    }
    vtkNew<vtkStringArray> text;
    text->SetName("bonedecimate.proof.sentence");
    text->InsertNextValue(sentence);
    fields->AddArray(text);
    proof.erase("sentence");
    report["proof"] = { { Sealed, std::move(proof) }, { "sentence", sentence } };
    report["units"] = WithProofNames(report["units"], ProofName, SealedName);
  }
  vtkNew<vtkStringArray> json;
  json->SetName(ReportName);
  json->InsertNextValue(report.dump());
  fields->AddArray(json);
  surface->SetFieldData(fields);
}
}
