// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PageTemplate.h
 * @brief The blocks of page.html.
 */
#ifndef BoneDecimate_Applications_PageTemplate_h
#define BoneDecimate_Applications_PageTemplate_h

#include <map>
#include <string>

namespace bonedecimate
{
/// The whole of page.html.
extern const char* const PageTemplateText;

/**
 * A block of page.html with its values.
 * @param values HTML by the name between the braces.
 * @throws std::logic_error if there is no such block, or no value for a name in it.
 */
std::string PageBlock(
  const std::string& block, const std::map<std::string, std::string>& values = {});
}

#endif
