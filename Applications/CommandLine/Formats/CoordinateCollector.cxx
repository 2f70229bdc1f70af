// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoordinateCollector.h"

#include <cmath>

namespace bonedecimate
{
CoordinateCollector::CoordinateCollector()
{
  this->Singles->SetNumberOfComponents(3);
  this->Doubles->SetNumberOfComponents(3);
}

void CoordinateCollector::Add(double coordinate)
{
  if (this->AreSingle)
  {
    const float single = static_cast<float>(coordinate);
    if (static_cast<double>(single) == coordinate || std::isnan(coordinate))
    {
      this->Singles->InsertNextValue(single);
      return;
    }
    this->AreSingle = false;
    for (vtkIdType i = 0; i < this->Singles->GetNumberOfValues(); ++i)
    {
      this->Doubles->InsertNextValue(static_cast<double>(this->Singles->GetValue(i)));
    }
    this->Singles->Initialize();
  }
  this->Doubles->InsertNextValue(coordinate);
}

vtkIdType CoordinateCollector::CountPoints() const
{
  return (this->AreSingle ? this->Singles->GetNumberOfValues()
                          : this->Doubles->GetNumberOfValues()) /
    3;
}

vtkSmartPointer<vtkPoints> CoordinateCollector::MakePoints()
{
  vtkDataArray* const coordinates = this->AreSingle
    ? static_cast<vtkDataArray*>(this->Singles.Get())
    : static_cast<vtkDataArray*>(this->Doubles.Get());
  coordinates->Squeeze();
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}
}
