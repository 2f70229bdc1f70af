// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WholeLabels.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <type_traits>

namespace bonedecimate::volume
{
namespace
{
constexpr double LargestFraction = 0.01; // of labels that were stored with a slope
constexpr vtkIdType None = -1;

std::string NumberText(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(7);
  text << value;
  return text.str();
}

/// "voxel 7, 10, 9", in the order x, y, z.
std::string VoxelText(vtkImageData* slab, vtkIdType index)
{
  const int* const size = slab->GetDimensions();
  const vtkIdType layer = vtkIdType(size[0]) * size[1];
  return "voxel " + std::to_string(index % size[0]) + ", " +
    std::to_string(index % layer / size[0]) + ", " +
    std::to_string(index / layer + slab->GetExtent()[4]);
}

/// What is not whole.
struct Fractions
{
  vtkIdType FirstRounded = None;
  vtkIdType FirstWrong = None; ///< Farther from a whole number, or not finite.
  double Least = 0.0;
  double Largest = 0.0;
};

template <typename Real>
Fractions FindFractions(const Real* values, vtkIdType count)
{
  constexpr double most = 9007199254740992.0;
  Fractions found;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = values[i];
    const double distance = std::abs(value - std::round(value));
    if (!(std::abs(value) <= most) || distance > LargestFraction)
    {
      found.FirstWrong = found.FirstWrong == None ? i : found.FirstWrong;
    }
    else if (distance > 0.0 && found.FirstRounded == None)
    {
      found.FirstRounded = i;
    }
    found.Least = value < found.Least ? value : found.Least;
    found.Largest = value > found.Largest ? value : found.Largest;
  }
  return found;
}

template <typename Real>
WholeLabels RoundReals(Real* values, vtkIdType count, vtkImageData* slab)
{
  WholeLabels labels;
  const Fractions found = FindFractions(values, count);
  if (found.FirstWrong != None)
  {
    const double value = values[found.FirstWrong];
    const bool areProbabilities =
      found.Least >= 0.0 && found.Largest <= 1.0 && std::isfinite(value);
    labels.Problem =
      "its values are no labels, which are whole numbers: " + VoxelText(slab, found.FirstWrong) +
      " has " + NumberText(value) +
      (areProbabilities
          ? "; they are probabilities from 0 to 1: --iso 0.5 takes the surface where they are 0.5"
          : "; --iso VALUE takes the surface at a value");
    return labels;
  }
  if (found.FirstRounded != None)
  {
    const double value = values[found.FirstRounded];
    labels.Note =
      "its values are whole numbers but for rounding, as a slope in the header gives them: " +
      VoxelText(slab, found.FirstRounded) + " has " + NumberText(value) + ", which counts as " +
      NumberText(std::round(value));
    for (vtkIdType i = 0; i < count; ++i)
    {
      values[i] = std::round(values[i]);
    }
  }
  return labels;
}

template <typename Value>
WholeLabels MakeWhole(Value* values, vtkIdType count, vtkImageData* slab)
{
  if constexpr (std::is_floating_point_v<Value>)
  {
    return RoundReals(values, count, slab);
  }
  WholeLabels labels;
  if constexpr (std::is_unsigned_v<Value> && sizeof(Value) == sizeof(std::int64_t))
  {
    constexpr Value largest = std::numeric_limits<std::int64_t>::max();
    for (vtkIdType i = 0; i < count && labels.Problem.empty(); ++i)
    {
      labels.Problem = values[i] <= largest ? std::string()
                                            : VoxelText(slab, i) + " has the label " +
          std::to_string(values[i]) + "; labels go up to 2^63 - 1, " + std::to_string(largest);
    }
  }
  return labels;
}
}

WholeLabels MakeWholeLabels(vtkImageData* slab)
{
  vtkDataArray* const array = slab->GetPointData()->GetScalars();
  switch (array->GetDataType())
  {
    vtkTemplateMacro(return MakeWhole(
      static_cast<VTK_TT*>(array->GetVoidPointer(0)), array->GetNumberOfTuples(), slab));
    default:
      return {};
  }
}
}
