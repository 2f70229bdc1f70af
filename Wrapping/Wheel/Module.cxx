// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bindings.h"

NB_MODULE(_core, module)
{
  nanobind::set_leak_warnings(
    false); // classes of VTK live until the interpreter is gone, and hold rows of the table
  module.doc() = "The core of vtkBoneDecimate. Use it through the package bonedecimate.";
  bonedecimate::BindOptions(module);
  bonedecimate::BindDecimate(module);
  bonedecimate::BindCaps(module);
  bonedecimate::BindCertify(module);
  bonedecimate::BindLabelMaps(module);
  bonedecimate::BindLevels(module);
  bonedecimate::BindPolygons(module);
}
