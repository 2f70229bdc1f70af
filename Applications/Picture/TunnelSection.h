// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TunnelSection.h
 * @brief The section of a page about tunnels that were closed.
 */
#ifndef BoneDecimate_Applications_TunnelSection_h
#define BoneDecimate_Applications_TunnelSection_h

#include "ReportFields.h"

#include <string>

namespace bonedecimate
{
/// The section as HTML; empty unless tunnels were to be closed.
std::string TunnelSection(const ReportFields& report);
}

#endif
