// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TunnelTable.h
 * @brief What the report says of closed tunnels: entries, warnings, and why they cannot be closed.
 */
#ifndef BoneDecimate_Core_Run_Report_TunnelTable_h
#define BoneDecimate_Core_Run_Report_TunnelTable_h

#include "ReportEntries.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Only if tunnels were to be closed.
void AddTunnels(Entries& entries, const TunnelFigures& tunnels);

/// That there is bone where the input has none, and which tunnels were left open; one sentence
/// each.
std::vector<std::string> TunnelWarnings(const TunnelFigures& tunnels);
}

#endif
