// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Explain/ExplainStages.h"

#include "NumberText.h"
#include "Options/OptionTable.h"
#include "Options/UnmetNeeds.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
struct Step
{
  bool IsThere;
  std::string Text;
};

std::vector<Step> StepsBefore(const Arguments& arguments, const Options& options)
{
  const bool isLimited = options.BoundsError() || !options.ToleranceArrayName.empty();
  return {
    { arguments.FillVolume > 0.0, "fill cavities of the volume" },
    { arguments.Segments.IsRequested() && arguments.Options.Prunes(),
      "remove islands of the label map" },
    { arguments.Segments.IsRequested(), "extract the surfaces of the segments" },
    { arguments.Iso.has_value(), "extract the bone surface" },
    { true, "clean" },
    { options.DiagnoseInput, "diagnose" },
    { options.WeldDistance > 0.0, "weld open boundaries" },
    { options.TunnelSize > 0.0, "close tunnels" },
    { options.Prunes(), "prune" },
    { !arguments.Reference.empty(), "prove the distance of the input to the reference" },
    { options.Smooths(), "smooth" },
    { isLimited && options.ProvesError() && !options.KeepsAllTriangles(), "draft" },
  };
}

std::vector<Step> StepsAfter(const Arguments& arguments, const Options& options)
{
  const bool isProved = options.ProveResult && UnmetNeeds(options, { "ProveResult" }).empty();
  return {
    { options.EffectiveEdgeLength() > 0.0, "bring edges to --edge-length" },
    { options.EffectiveMinimumAngle() > 0.0, "improve triangles below --min-angle" },
    { options.MeasureDistances, "measure distances" },
    { isProved, "prove the result" },
    { true, "write" },
    { isProved, "prove what was written" },
    { !arguments.Picture.empty() || !arguments.Page.empty(), "draw" },
  };
}

void Append(const std::vector<Step>& steps, std::vector<std::string>& names)
{
  for (const Step& step : steps)
  {
    if (step.IsThere)
    {
      names.push_back(step.Text);
    }
  }
}

void ExplainEnd(const Options& options, double triangles, Explanation& explanation)
{
  const bool isLimited = options.BoundsError() || !options.ToleranceArrayName.empty();
  const bool reduces = options.EndsAtReduction(isLimited);
  if (options.TargetNumberOfTriangles > 0)
  {
    explanation.Add(
      "ends at", GroupedText(options.TargetNumberOfTriangles) + " triangles: --target-triangles");
  }
  if (reduces)
  {
    explanation.Add("ends at",
      (triangles > 0.0
          ? GroupedText(std::floor(triangles * (1.0 - options.TargetReduction) + 0.5)) +
            " triangles: "
          : std::string()) +
        "--target-reduction " + OptionText(options, *FindOption("TargetReduction")) +
        (options.TargetReductionIsExplicit ? "" : ", the default"));
  }
  if (isLimited)
  {
    explanation.Add("ends at", "the last edit that the bound allows");
  }
  else if (!reduces && options.TargetNumberOfTriangles == 0)
  {
    explanation.Add("ends at", "the last edit that is valid");
  }
}
}

void ExplainStages(
  const Arguments& arguments, const Options& options, double triangles, Explanation& explanation)
{
  const ModeInfo& mode = FindMode(options.Mode);
  std::vector<std::string> names;
  Append(StepsBefore(arguments, options), names);
  if (!options.KeepsAllTriangles())
  {
    for (const Stage& stage : mode.Stages)
    {
      names.emplace_back(stage.Name);
    }
  }
  Append(StepsAfter(arguments, options), names);
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  explanation.Add("mode", mode.Name);
  explanation.Add("stages", text);
  ExplainEnd(options, triangles, explanation);
}
}
