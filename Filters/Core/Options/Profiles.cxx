// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Profiles.h"

#include "Base/Text.h"

#include <algorithm>

namespace bonedecimate
{
const std::vector<Profile>& ProfileTable()
{
  static const std::vector<Profile> table = {
    { "planning", "Surgical planning: measuring, cutting, registration.",
      {
        { "mode", "Accurate",
          "a plan is made once and displayed often, so fewer triangles are worth the time", true },
        { "max-error", "0.25", "it is less than half of a voxel of most CT scans", true },
        { "intersection-guard", "on", "gaps of joints and fractures are what is planned" },
        { "diagnose", "on", "defects of the segmentation belong into the report of a plan" },
      } },
    { "print", "Models for 3D printers.",
      {
        { "mode", "Balanced", "slicing a model takes longer than decimating it", true },
        { "max-error", "0.1", "it is about a layer of a printer, and finer detail is lost", true },
        { "intersection-guard", "on",
          "walls that intersect or touch are filled or split by slicers" },
        { "precision", "Single", "STL holds single precision, so that the proof is of the file" },
        { "prune-size", "2", "specks below 2 mm are not printed, or come loose" },
      } },
    { "FEM", "Surfaces for volume meshers and finite elements.",
      {
        { "mode", "Balanced", "its moves and flips give better triangles than Fast", true },
        { "max-error", "0.5", "elements are larger than this", true },
        { "min-angle", "20",
          "triangles with small angles become elements with small angles, which spoil the "
          "condition of the stiffness matrix" },
        { "intersection-guard", "on", "volume meshers reject surfaces that intersect themselves" },
        { "prune-size", "5",
          "a loose piece can move freely and makes the stiffness matrix singular" },
      } },
    { "web", "Surfaces for browsers and for sending.",
      {
        { "mode", "Balanced", "a file is loaded more often than it is made", true },
        { "max-error", "0.5", "it is about a pixel where a whole bone fills the window", true },
        { "precision", "Single", "graphics hardware computes in single precision" },
        { "pass-arrays", "off", "arrays of the input enlarge the file" },
        { "prune-size", "2", "specks cost draw calls and bytes and are not seen" },
      } },
  };
  return table;
}

const Profile* FindProfile(const std::string& name)
{
  const auto& table = ProfileTable();
  const auto found = std::find_if(table.begin(), table.end(),
    [&name](const Profile& profile) { return LowerCase(profile.Name) == LowerCase(name); });
  return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> ProfileNames()
{
  std::vector<std::string> names;
  for (const Profile& profile : ProfileTable())
  {
    names.emplace_back(profile.Name);
  }
  return names;
}

std::vector<std::string> AlternativesTo(const std::string& flag)
{
  static const std::vector<std::vector<std::string>> groups = {
    { "max-error", "preset" },
    { "smooth", "auto-smooth" },
    { "target-triangles", "target-reduction" },
    { "iso", "segments" },
    { "normal-tolerance", "auto-normal-tolerance" },
  };
  const auto group = std::find_if(groups.begin(), groups.end(),
    [&flag](const std::vector<std::string>& one)
    { return std::find(one.begin(), one.end(), flag) != one.end(); });
  return group == groups.end() ? std::vector<std::string>{ flag } : *group;
}

std::string ProfileTableMarkdown()
{
  std::string text;
  for (const Profile& profile : ProfileTable())
  {
    text += "\n### " + std::string(profile.Name) + "\n\n" + profile.Purpose +
      "\n\n| option | value | because | levels |\n|---|---|---|---|\n";
    for (const ProfileOption& option : profile.Options)
    {
      text += "| `--" + std::string(option.Flag) + "` | " + option.Value + " | " + option.Reason +
        " | " + (option.IsForLevels ? "yes" : "") + " |\n";
    }
  }
  return text.substr(1);
}
}
