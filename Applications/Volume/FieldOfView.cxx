// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldOfView.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <locale>
#include <sstream>

namespace bonedecimate::volume
{
namespace
{
/// Neither more nor less than the constant.
template <typename Scalar>
bool IsSame(Scalar value, double constant)
{
  const auto number = static_cast<double>(value);
  return number <= constant && number >= constant;
}
}

void FieldOfView::Begin(const Volume& slab)
{
  const int* const size = slab.Image->GetDimensions();
  this->Size = { { size[0], size[1] } };
  this->Constant = slab.Image->GetPointData()->GetScalars()->GetComponent(0, 0);
  this->IsPossible = this->Constant >= this->Value; // not of a value that is no number
  if (!this->IsPossible)
  {
    return;
  }
  const double sides[2] = { Length(slab.Geometry.Steps[0]), Length(slab.Geometry.Steps[1]) };
  this->PixelSize = std::max(sides[0], sides[1]);
  this->LargestRadius = 0.5 *
    std::min(sides[0] * static_cast<double>(size[0]), sides[1] * static_cast<double>(size[1]));
  const auto offset = [&](int axis, int index)
  { return sides[axis] * (static_cast<double>(index) - 0.5 * (size[axis] - 1)); };
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      this->Distances.push_back(std::hypot(offset(0, x), offset(1, y)));
    }
  }
  const double farthest = *std::max_element(this->Distances.begin(), this->Distances.end());
  this->Rings.resize(1 + this->RingAt(farthest));
}

template <typename Scalar>
void FieldOfView::AddLayer(const Scalar* values)
{
  const vtkIdType count = this->Size[0] * this->Size[1];
  const vtkIdType corners[] = { 0, this->Size[0] - 1, count - this->Size[0], count - 1 };
  this->IsPossible = std::all_of(std::begin(corners), std::end(corners),
    [&](vtkIdType corner) { return IsSame(values[corner], this->Constant); });
  ++this->Layers;
  if (std::all_of(
        values, values + count, [this](Scalar value) { return IsSame(value, this->Constant); }))
  {
    ++this->EmptyLayers;
    return;
  }
  for (vtkIdType i = 0; this->IsPossible && i < count; ++i)
  {
    const double distance = this->Distances[static_cast<std::size_t>(i)];
    Ring& ring = this->Rings[this->RingAt(distance)];
    ++ring.Voxels;
    if (!IsSame(values[i], this->Constant))
    {
      const auto value = static_cast<double>(values[i]);
      ++ring.Measured;
      this->Radius = std::max(this->Radius, distance);
      ring.Least = std::min(ring.Least, value);
      ring.Largest = std::max(ring.Largest, value);
    }
  }
}

void FieldOfView::Add(const Volume& slab)
{
  if (this->NextLayer == 0)
  {
    this->Begin(slab);
  }
  const int* const extent = slab.Image->GetExtent();
  vtkDataArray* const array = slab.Image->GetPointData()->GetScalars();
  for (std::int64_t layer = std::max<std::int64_t>(extent[4], this->NextLayer);
       this->IsPossible && layer <= extent[5]; ++layer)
  {
    const vtkIdType first = (layer - extent[4]) * this->Size[0] * this->Size[1];
    switch (array->GetDataType())
    {
      vtkTemplateMacro(this->AddLayer(static_cast<const VTK_TT*>(array->GetVoidPointer(first))));
      default:
        this->IsPossible = false;
    }
  }
  this->NextLayer = extent[5] + 1;
}

bool FieldOfView::HasPadding() const
{
  constexpr std::size_t leastRings = 4;
  const std::size_t outside = this->IsPossible ? this->RingAt(this->Radius) + 1 : 0;
  if (outside < leastRings || this->Radius > this->LargestRadius)
  {
    return false;
  }
  Ring edge; // the outermost ring is cut by the circle
  for (std::size_t i = outside - 3; i < outside - 1; ++i)
  {
    edge.Voxels += this->Rings[i].Voxels;
    edge.Measured += this->Rings[i].Measured;
    edge.Least = std::min(edge.Least, this->Rings[i].Least);
    edge.Largest = std::max(edge.Largest, this->Rings[i].Largest);
  }
  return 10 * edge.Measured >= 9 * edge.Voxels && edge.Least < edge.Largest &&
    this->LeastMeasured() < this->Value;
}

double FieldOfView::LeastMeasured() const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : this->Rings)
  {
    least = std::min(least, ring.Least);
  }
  return least;
}

template <typename Scalar>
void FieldOfView::ClearLayer(Scalar* values) const
{
  const vtkIdType count = this->Size[0] * this->Size[1];
  const auto least = static_cast<Scalar>(this->LeastMeasured());
  const bool isEmpty = std::all_of(
    values, values + count, [this](Scalar value) { return IsSame(value, this->Constant); });
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (isEmpty || this->Distances[static_cast<std::size_t>(i)] > this->Radius)
    {
      values[i] = least;
    }
  }
}

void FieldOfView::Clear(const Volume& slab) const
{
  const int* const extent = slab.Image->GetExtent();
  vtkDataArray* const array = slab.Image->GetPointData()->GetScalars();
  for (int layer = extent[4]; layer <= extent[5]; ++layer)
  {
    const vtkIdType first = (layer - extent[4]) * this->Size[0] * this->Size[1];
    switch (array->GetDataType())
    {
      vtkTemplateMacro(this->ClearLayer(static_cast<VTK_TT*>(array->GetVoidPointer(first))));
      default:
        break;
    }
  }
}

std::int64_t FieldOfView::Count() const
{
  if (!this->HasPadding())
  {
    return 0;
  }
  const auto inLayer = std::count_if(this->Distances.begin(), this->Distances.end(),
    [this](double distance) { return distance > this->Radius; });
  const auto all = static_cast<std::int64_t>(this->Distances.size());
  return (this->Layers - this->EmptyLayers) * inLayer + this->EmptyLayers * all;
}

std::string FieldOfView::Note() const
{
  if (!this->HasPadding())
  {
    return std::string();
  }
  const std::int64_t count = this->Count();
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << count << " of its voxels, all outside of a circle with a radius of "
       << std::setprecision(4) << this->Radius << std::setprecision(7)
       << " mm, have the constant value " << this->Constant
       << ": they were not measured and count as " << this->LeastMeasured()
       << ", the least measured value";
  if (this->EmptyLayers > 0)
  {
    text << ", as do " << this->EmptyLayers << " layers that have no other value";
  }
  return text.str();
}

std::string FieldOfView::Problem() const
{
  double largest = -std::numeric_limits<double>::infinity();
  for (const Ring& ring : this->Rings)
  {
    largest = std::max(largest, ring.Largest);
  }
  if (!this->HasPadding() || largest >= this->Value)
  {
    return std::string();
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "none of its voxels is above " << this->Value << " HU but those outside of the circle "
       << "that was measured: inside the values go from " << this->LeastMeasured() << " to "
       << largest;
  return text.str();
}
}
