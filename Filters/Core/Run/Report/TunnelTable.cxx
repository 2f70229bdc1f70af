// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TunnelTable.h"

#include "Words.h"

#include <algorithm>
#include <cstdio>

namespace bonedecimate
{
namespace
{
/// "3 tunnels were", "1 tunnel was"
std::string CountOf(std::int64_t count)
{
  return std::to_string(count) + (count == 1 ? " tunnel was" : " tunnels were");
}
}

void AddTunnels(Entries& entries, const TunnelFigures& tunnels)
{
  constexpr std::size_t mostListed = 1000;
  static const char* const reasons[] = { "none", "ambiguous", "no_annulus", "constrained",
    "intersection" };
  if (!tunnels.IsRequested)
  {
    return;
  }
  const std::vector<ClosedTunnel>& closed = tunnels.Closed;
  double volume = 0.0;
  for (const ClosedTunnel& tunnel : closed)
  {
    volume += tunnel.Volume;
  }
  entries.push_back({ "tunnels.closed", "", static_cast<std::int64_t>(closed.size()) });
  for (std::size_t i = 1; i < NumberOfTunnelObstacles; ++i)
  {
    entries.push_back({ std::string("tunnels.left.") + reasons[i], "", tunnels.Left[i] });
  }
  entries.push_back({ "tunnels.genus_before", "", tunnels.GenusBefore });
  entries.push_back({ "tunnels.genus_after", "", tunnels.GenusAfter });
  entries.push_back({ "tunnels.distance", "mm", tunnels.Distance });
  entries.push_back({ "tunnels.volume", "mm3", volume });
  for (std::size_t i = 0; i < std::min(closed.size(), mostListed); ++i)
  {
    const std::string path = "tunnels.list." + std::to_string(i);
    entries.push_back({ path + ".diameter", "mm", closed[i].Diameter });
    entries.push_back({ path + ".volume", "mm3", closed[i].Volume });
    AddPosition(entries, path + ".center", closed[i].Center);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> TunnelWarnings(const TunnelFigures& tunnels)
{
  std::vector<std::string> warnings;
  char text[320];
  if (tunnels.IsRequested && !tunnels.Closed.empty())
  {
    std::snprintf(text, sizeof(text),
      "%s closed, so there is bone where the input has none; errors, distances and proof refer to "
      "the surface with its tunnels closed, which is at most %.3g mm from the input",
      CountOf(static_cast<std::int64_t>(tunnels.Closed.size())).c_str(), tunnels.Distance);
    warnings.emplace_back(text);
  }
  if (tunnels.IsRequested && tunnels.NumberLeft() > 0)
  {
    std::snprintf(text, sizeof(text),
      "%s left open although narrow enough: %lld with an ambiguous loop, %lld without a band that "
      "can be replaced, %lld at constrained points or between labels, %lld whose plug would "
      "intersect the surface",
      CountOf(tunnels.NumberLeft()).c_str(), static_cast<long long>(tunnels.Left[1]),
      static_cast<long long>(tunnels.Left[2]), static_cast<long long>(tunnels.Left[3]),
      static_cast<long long>(tunnels.Left[4]));
    warnings.emplace_back(text);
  }
  return warnings;
}
}
