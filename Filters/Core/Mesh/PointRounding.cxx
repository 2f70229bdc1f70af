// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointRounding.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// Volatile, because optimizers remove the conversion to single precision and back (gcc 12 does at
/// -O2).
double NearestSingle(double value)
{
  const volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}
}

Vector3 RoundedToSingle(const Vector3& position)
{
  return position.unaryExpr(&NearestSingle);
}

//------------------------------------------------------------------------------
Vector3 PointRounding::Of(const Vector3& position) const
{
  Vector3 rounded = position;
  if (this->HasGrid())
  {
    const double step = this->GridStep;
    rounded = rounded.unaryExpr([step](double value) { return std::round(value / step) * step; });
  }
  return this->ToSingle ? RoundedToSingle(rounded) : rounded;
}

Vector3 PointRounding::OfLocal(const Vector3& local, const Vector3& origin) const
{
  return this->Rounds() ? Vector3(this->Of(local + origin) - origin) : local;
}
}
