// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeaderUnit.h"

#include "Base/Text.h"
#include "TextNumbers.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace bonedecimate::volume
{
namespace
{
struct KnownUnit
{
  const char* Name;
  double Millimeters;
  std::vector<const char*> Texts;
};

const std::vector<KnownUnit>& KnownUnits()
{
  static const std::vector<KnownUnit> units{
    { "nanometer", 1e-6, { "nm", "nanometer", "nanometers" } },
    { "micrometer", 1e-3,
      { "um", "\xc2\xb5m", "\xce\xbcm", "micron", "microns", "micrometer", "micrometers" } },
    { "millimeter", 1.0, { "", "?", "mm", "millimeter", "millimeters" } },
    { "centimeter", 10.0, { "cm", "centimeter", "centimeters" } },
    { "meter", 1000.0, { "m", "meter", "meters" } },
  };
  return units;
}

bool IsMillimeter(const HeaderUnit& unit)
{
  return !(unit.Millimeters < 1.0 || unit.Millimeters > 1.0);
}
}

HeaderUnit UnitOf(const std::string& text)
{
  const std::string word = LowerCase(Trimmed(text));
  for (const KnownUnit& unit : KnownUnits())
  {
    if (std::find(unit.Texts.begin(), unit.Texts.end(), word) != unit.Texts.end())
    {
      return { unit.Name, unit.Millimeters };
    }
  }
  return { text, 0.0 };
}

std::string UnitProblem(const HeaderUnit& unit)
{
  return unit.Millimeters > 0.0
    ? std::string()
    : "its unit of length is '" + unit.Name + "': save it in millimeters";
}

std::string UnitNote(const HeaderUnit& unit)
{
  return IsMillimeter(unit)
    ? std::string()
    : "its unit is the " + unit.Name + " by its header; lengths are converted to millimeters";
}

VolumeGeometry InMillimeters(const VolumeGeometry& geometry, const HeaderUnit& unit)
{
  VolumeGeometry converted = geometry;
  if (!IsMillimeter(unit))
  {
    converted.Origin = Scaled(geometry.Origin, unit.Millimeters);
    std::transform(geometry.Steps.begin(), geometry.Steps.end(), converted.Steps.begin(),
      [&unit](const Vector3& step) { return Scaled(step, unit.Millimeters); });
  }
  return converted;
}
}
