// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Has Slicer's own parser read a module's description and registers it, as Slicer does when it
// starts. The wheel slicer-core has the parser's library and no headers: what is called of it is
// declared here, objects as large as they may be. Compile for the old ABI of strings, as that wheel
// is.
#include <string>

class ModuleDescription
{
public:
  ModuleDescription();
  ModuleDescription(const ModuleDescription&);
  void SetTarget(const std::string&);
  void SetLocation(const std::string&);
  void SetType(const std::string&);

private:
  alignas(16) char Storage[16384] = {};
};

class ModuleDescriptionParser
{
public:
  int Parse(const std::string& xml, ModuleDescription& description);

private:
  alignas(16) char Storage[4096] = {};
};

class vtkMRMLCommandLineModuleNode
{
public:
  static void RegisterModuleDescription(ModuleDescription description);
};

/// 0 if the parser has nothing against it.
extern "C" int RegisterModule(const char* xml, const char* program)
{
  // Never destroyed: their destructors are unknown here.
  ModuleDescription& description = *new ModuleDescription;
  const int problem = (new ModuleDescriptionParser)->Parse(xml, description);
  if (problem == 0)
  {
    description.SetTarget(program);
    description.SetLocation(program);
    description.SetType("CommandLineModule");
    vtkMRMLCommandLineModuleNode::RegisterModuleDescription(*new ModuleDescription(description));
  }
  return problem;
}
