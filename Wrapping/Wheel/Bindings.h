// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bindings.h
 * @brief The core for Python: numpy arrays in, numpy arrays out. Shapes and types are made right by
 * the package around it.
 */
#ifndef BoneDecimate_Wheel_Bindings_h
#define BoneDecimate_Wheel_Bindings_h

#include <nanobind/nanobind.h>

namespace bonedecimate
{
/// The table of options, the values of a run, and the words of the report.
void BindOptions(nanobind::module_& module);

/// One run.
void BindDecimate(nanobind::module_& module);

/// Closed boundaries.
void BindCaps(nanobind::module_& module);

/// The certificate of two surfaces.
void BindCertify(nanobind::module_& module);

/// Surfaces of label maps, and of one label.
void BindLabelMaps(nanobind::module_& module);

/// Polygons and strips as triangles.
void BindPolygons(nanobind::module_& module);

/// A recorded run and every level of detail of it.
void BindLevels(nanobind::module_& module);
}

#endif
