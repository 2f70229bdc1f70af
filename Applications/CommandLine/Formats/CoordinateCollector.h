// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoordinateCollector.h
 * @brief Coordinates of a file without a rounding: in single precision only if that holds each of
 * them exactly.
 */
#ifndef BoneDecimate_Applications_CoordinateCollector_h
#define BoneDecimate_Applications_CoordinateCollector_h

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

namespace bonedecimate
{
class CoordinateCollector
{
public:
  CoordinateCollector();

  /// The next coordinate; three make a point.
  void Add(double coordinate);

  vtkIdType CountPoints() const;

  /// Points in single precision if that holds every coordinate exactly, else in double precision.
  vtkSmartPointer<vtkPoints> MakePoints();

private:
  bool AreSingle = true;
  vtkNew<vtkFloatArray> Singles;
  vtkNew<vtkDoubleArray> Doubles; // all of them, from the first that is not exactly single
};
}

#endif
