// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Needs.h"

#include "Options.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
using Terms = std::vector<std::vector<PanelTerm>>;
using ModePredicate = bool (ModeInfo::*)() const;

bool HasError(const Options& options)
{
  return options.MaximumError > 0.0 || options.ErrorPreset != ErrorPreset::NoPreset;
}

bool IsLimited(const Options& options)
{
  return HasError(options) || !options.ToleranceArrayName.empty();
}

/// Whether there is an error to prove; smoothing alone has one, too.
bool HasProvableError(const Options& options)
{
  return IsLimited(options) || (options.Smooths() && options.KeepsAllTriangles());
}

/// Whether the run ends at a number of triangles; the default reduction is ignored if there is an
/// error.
bool HasCount(const Options& options)
{
  return options.TargetNumberOfTriangles > 0 || options.EndsAtReduction(HasError(options));
}

/// Whether NormalTolerance is used as it is.
bool HasFixedTolerance(const Options& options)
{
  const bool hasTolerance = FindMode(options.Mode).HasNormalTolerance();
  return !hasTolerance || !options.AutomaticNormalTolerance || !HasCount(options);
}

PanelTerm Is(const char* option, const char* value)
{
  return { option, value, true };
}

PanelTerm IsNot(const char* option, const char* value)
{
  return { option, value, false };
}

/// One of the modes of which the predicate is true.
template <typename Predicate>
std::vector<PanelTerm> ModesThat(const Predicate& predicate)
{
  std::vector<PanelTerm> terms;
  for (const ModeInfo& mode : ModeTable())
  {
    if (predicate(mode))
    {
      terms.push_back({ "Mode", std::to_string(static_cast<int>(mode.Mode)), true });
    }
  }
  return terms;
}

template <typename Predicate>
NeedInfo OfMode(Need need, bool (*isMet)(const Options& options), const Predicate& predicate)
{
  return { need, isMet, "Mode " + ModeNamesWhere(predicate), { ModesThat(predicate) } };
}

/// Needs of a mode.
std::vector<NeedInfo> ModeNeeds()
{
  const auto proves = [](const ModeInfo& mode) { return mode.ProvesError(); };
  const auto provesNot = [](const ModeInfo& mode) { return !mode.ProvesError(); };
  return {
    { Need::ProvingMode, [](const Options& o) { return o.ProvesError(); },
      "another Mode than " + ModeNamesWhere(provesNot), { ModesThat(proves) } },
    OfMode(
      Need::RefiningMode, [](const Options& o) { return FindMode(o.Mode).Refine.ProvedRounds > 0; },
      [](const ModeInfo& mode) { return mode.Refine.ProvedRounds > 0; }),
    OfMode(
      Need::ShapeMode, [](const Options& o) { return FindMode(o.Mode).LimitsShapes(); },
      [](const ModeInfo& mode) { return mode.LimitsShapes(); }),
    OfMode(
      Need::NormalToleranceMode,
      [](const Options& o) { return FindMode(o.Mode).HasNormalTolerance(); },
      [](const ModeInfo& mode) { return mode.HasNormalTolerance(); }),
  };
}

/// Needs of an error.
std::vector<NeedInfo> ErrorNeeds()
{
  const std::string limit = "MaximumError, ErrorPreset or ToleranceArrayName";
  const std::vector<PanelTerm> bound = { IsNot("MaximumError", "0"), IsNot("ErrorPreset", "0") };
  const std::vector<PanelTerm> limited = { bound[0], bound[1], IsNot("ToleranceArrayName", "") };
  return {
    { Need::Bound, HasError, "MaximumError or ErrorPreset", { bound } },
    { Need::Limit, IsLimited, limit, { limited } },
    { Need::ProvableError, HasProvableError, limit, { limited } },
    { Need::Proof, [](const Options& o) { return o.ProveResult && HasProvableError(o); },
      "ProveResult with " + limit, { limited, { Is("ProveResult", "1") } } },
    { Need::ErrorPreset, [](const Options& o) { return o.ErrorPreset != ErrorPreset::NoPreset; },
      "ErrorPreset", { { bound[1] } } },
  };
}

/// Needs of what a run does and measures.
std::vector<NeedInfo> RunNeeds()
{
  std::vector<PanelTerm> measured =
    ModesThat([](const ModeInfo& mode) { return mode.RecordsDistances; });
  measured.push_back(Is("MeasureDistances", "1"));
  return {
    { Need::Count, HasCount, "TargetNumberOfTriangles or TargetReduction", {} },
    { Need::RemovedTriangles, [](const Options& o) { return !o.KeepsAllTriangles(); },
      "TargetReduction above 0", {} },
    { Need::EdgeLength, [](const Options& o) { return o.EdgeLength > 0.0; }, "EdgeLength",
      { { IsNot("EdgeLength", "0") } } },
    { Need::Smoothing, [](const Options& o) { return o.Smooths(); },
      "Smoothing or AutomaticSmoothing",
      { { IsNot("Smoothing", "0"), Is("AutomaticSmoothing", "1") } } },
    { Need::NoSmoothingDistance, [](const Options& o) { return o.Smoothing == 0.0; }, "Smoothing 0",
      { { Is("Smoothing", "0") } } },
    { Need::FixedNormalTolerance, HasFixedTolerance, "AutomaticNormalTolerance off",
      { { Is("AutomaticNormalTolerance", "0") } } },
    { Need::Measured,
      [](const Options& o) { return o.MeasureDistances || FindMode(o.Mode).RecordsDistances; },
      "MeasureDistances", { measured } },
    { Need::InputDistances, [](const Options& o) { return o.MeasureInputDistances; },
      "MeasureInputDistances", { { Is("MeasureInputDistances", "1") } } },
  };
}
}

const std::vector<NeedInfo>& NeedTable()
{
  static const std::vector<NeedInfo> table = []
  {
    std::vector<NeedInfo> rows;
    for (const std::vector<NeedInfo>& group : { ModeNeeds(), ErrorNeeds(), RunNeeds() })
    {
      rows.insert(rows.end(), group.begin(), group.end());
    }
    return rows;
  }();
  return table;
}

const NeedInfo* FindNeed(Need need)
{
  const std::vector<NeedInfo>& table = NeedTable();
  const auto row = std::find_if(
    table.begin(), table.end(), [need](const NeedInfo& info) { return info.Need == need; });
  return row == table.end() ? nullptr : &*row;
}
}
