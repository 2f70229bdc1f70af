// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoadOnDemand.h
 * @brief Libraries that few runs need and that take longer to load than the rest of the program.
 *
 * A program of one file, as in the wheel, contains them; there BONEDECIMATE_LOADS_ON_DEMAND is not
 * defined.
 */
#ifndef BoneDecimate_Applications_LoadOnDemand_h
#define BoneDecimate_Applications_LoadOnDemand_h

#include <dlfcn.h>
#include <string>

namespace bonedecimate
{
/**
 * Loads a library unless it is loaded already; it remains until the program ends. It is looked for
 * where libraries of the file that calls this are. That is why the function is inline.
 * @param object Name of an object of this library with C linkage.
 * @param problem What went wrong, if the result is null.
 */
inline const void* LoadOnDemand(const char* library, const char* object, std::string& problem)
{
  void* const loaded = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  const void* const found = loaded ? dlsym(loaded, object) : nullptr;
  if (!found)
  {
    const char* const reason = dlerror();
    problem = reason ? reason : library;
  }
  return found;
}
}

#endif
