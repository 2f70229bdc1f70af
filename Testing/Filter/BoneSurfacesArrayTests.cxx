// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of vtkBoneSurfaces, and the types of labels that it takes.
#include "BruteForce.h"
#include "ImageLabels.h"
#include "LabelImages.h"
#include "LabelMapArrays.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "VtkSurfaces.h"

#include "vtkBoneSurfaces.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

TEST(BoneSurfaces, HaveArraysThatReadBack)
{
  const LabelMap map = ObliqueEllipsoid(true);
  const auto surface = Extracted(ImageOf(map, VTK_UNSIGNED_CHAR, { 2, 0, -3 }));
  const ReadLabelMap read = ReadLabelMapArrays(surface, ToSurface(surface, 1));
  EXPECT_EQ(read.Problem, "");
  EXPECT_EQ(read.Source.Values, (std::vector<std::int64_t>{ 1, 2, 3, 0 }));
  EXPECT_EQ(read.Source.Grid.Dimensions, map.Grid.Dimensions);
  EXPECT_LT((read.Source.Grid.Origin - map.Grid.Origin).norm(), 1e-9);
  EXPECT_EQ(read.Source.Grid.Spacing, map.Grid.Spacing);
  EXPECT_LT((read.Source.Grid.Direction - map.Grid.Direction).norm(), 1e-12);
  const LabelSurfaces expected =
    ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), {});
  EXPECT_EQ(read.Source.OfPoint, expected.Source.OfPoint);
  EXPECT_EQ(read.Source.OfTriangle, expected.Source.OfTriangle);
}

TEST(BoneSurfaces, OfShearedAndUnevenGridsAreThoseOfTheCore)
{
  for (const VoxelGrid& grid :
    { ShearedGrid({ 15, 13, 12 }), Uneven(ShearedGrid({ 15, 13, 12 }, true)) })
  {
    LabelMap map = EllipsoidLabels({ 15, 13, 12 });
    map.Grid = grid;
    const auto surface = Extracted(ImageOf(map, VTK_UNSIGNED_CHAR, { 2, -4, 0 }));
    const ReadLabelMap read = ReadLabelMapArrays(surface, ToSurface(surface, 1));
    ASSERT_EQ(read.Problem, "");
    EXPECT_EQ(read.Source.Grid.Layers, grid.Layers);
    EXPECT_LT((read.Source.Grid.Direction - grid.Direction).norm(), 1e-12);
    const LabelSurfaces expected =
      ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), {});
    const Surface found = ToSurface(surface, 1).Surface;
    ASSERT_EQ(found.Points.size(), expected.Surface.Points.size());
    for (std::size_t p = 0; p < found.Points.size(); ++p)
    {
      ASSERT_LT((found.Points[p] - expected.Surface.Points[p]).norm(), 1e-4);
    }
  }
}

TEST(BoneSurfaces, RejectLayersThatAreNotThoseOfTheImage)
{
  LabelMap map = EllipsoidLabels({ 8, 7, 6 });
  map.Grid = Uneven(map.Grid);
  const auto problemOf = [](vtkImageData* image)
  {
    return ReadImageLabels(
      image, image->GetPointData()->GetScalars(), vtkDataObject::FIELD_ASSOCIATION_POINTS)
      .Problem;
  };
  EXPECT_EQ(problemOf(ImageOf(map)), "");
  const std::vector<std::vector<double>> others = { { 0, 1, 2, 3, 4 }, { 1, 2, 3, 4, 5, 6 },
    { 0, 1, 2, 2, 3, 4 }, { 0, 1, 2, NAN, 3, 4 } };
  for (const std::vector<double>& layers : others)
  {
    map.Grid.Layers = layers;
    EXPECT_NE(problemOf(ImageOf(map)).find("VoxelGridLayers"), std::string::npos);
  }
}

TEST(BoneSurfaces, HaveArraysThatAreRejectedIfTheyDoNotFit)
{
  const auto problemAfter = [](void (*change)(vtkPolyData*))
  {
    const auto surface = Extracted(ImageOf(EllipsoidLabels({ 8, 7, 6 })));
    change(surface);
    const ReadLabelMap read = ReadLabelMapArrays(surface, ToSurface(surface, 1));
    EXPECT_TRUE(read.Problem.empty() || read.Source.Values.empty());
    return read.Problem;
  };
  EXPECT_EQ(problemAfter([](vtkPolyData*) {}), "");
  EXPECT_NE(problemAfter([](vtkPolyData* s)
              { s->GetFieldData()->GetArray("VoxelGridSpacing")->SetComponent(0, 1, 0.0); }),
    "");
  EXPECT_NE(problemAfter([](vtkPolyData* s)
              { s->GetFieldData()->GetArray("VoxelGridOrigin")->SetComponent(0, 1, NAN); }),
    "");
  EXPECT_NE(problemAfter([](vtkPolyData* s)
              { s->GetFieldData()->GetArray("VoxelGridDirection")->SetComponent(0, 1, 0.5); }),
    "");
  EXPECT_NE(problemAfter([](vtkPolyData* s)
              { s->GetFieldData()->GetArray("VoxelGridDimensions")->SetComponent(0, 1, 0); }),
    "");
  EXPECT_NE(problemAfter([](vtkPolyData* s)
              { s->GetCellData()->GetArray("BoundaryLabels")->SetComponent(3, 1, 9); }),
    "");
  EXPECT_NE(problemAfter([](vtkPolyData* s)
              { s->GetFieldData()->GetArray("LabelValues")->SetComponent(0, 0, 7); }),
    "");
  EXPECT_NE(problemAfter([](vtkPolyData* s)
              { s->GetPointData()->GetArray("GridPoint")->SetNumberOfTuples(3); }),
    "");
}

TEST(BoneSurfaces, AreTheSameForEveryTypeOfLabels)
{
  const LabelMap map = NoiseLabels({ 7, 8, 6 }, 5, 3);
  const auto expected = Extracted(ImageOf(map));
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
         VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    const auto surface = Extracted(ImageOf(map, type));
    EXPECT_TRUE(SameBytes(SurfaceOf(surface), SurfaceOf(expected))) << type;
    EXPECT_EQ(LabelsOf(surface), LabelsOf(expected)) << type;
  }
}

TEST(BoneSurfaces, KeepLargeLabels)
{
  vtkNew<vtkTypeInt64Array> labels;
  labels->SetName("Large");
  const vtkTypeInt64 large = (vtkTypeInt64(1) << 60) + 1;
  for (const vtkTypeInt64 label : { vtkTypeInt64(0), large, large + 1, vtkTypeInt64(-5) })
  {
    labels->InsertNextValue(label);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 1, 1);
  image->GetPointData()->SetScalars(labels);
  const auto surface = Extracted(image);
  auto* values = vtkTypeInt64Array::SafeDownCast(surface->GetFieldData()->GetArray("LabelValues"));
  ASSERT_NE(values, nullptr);
  ASSERT_EQ(values->GetNumberOfTuples(), 4);
  EXPECT_EQ(values->GetValue(1), large);
  EXPECT_EQ(values->GetValue(2), large + 1);
  vtkNew<vtkPolyData> single;
  EXPECT_TRUE(vtkBoneSurfaces::ExtractLabel(surface, large + 1, single));
  EXPECT_EQ(CountTopology(SurfaceOf(single)).EulerNumber, 2);
}

TEST(BoneSurfaces, KeepNamesAndColorsInTheOrderOfTheLabels)
{
  const auto image = ImageOf(EllipsoidLabels({ 12, 11, 10 }));
  vtkNew<vtkIntArray> values;
  values->SetName("LabelValues");
  vtkNew<vtkStringArray> names;
  names->SetName("LabelNames");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("LabelColors");
  colors->SetNumberOfComponents(3);
  for (const int label : { 3, 9, 1 })
  {
    values->InsertNextValue(label);
    names->InsertNextValue("bone " + std::to_string(label));
    colors->InsertNextTuple3(label, 20, 30);
  }
  vtkNew<vtkStringArray> patient;
  patient->SetName("Patient");
  patient->InsertNextValue("phantom");
  for (vtkAbstractArray* array :
    { static_cast<vtkAbstractArray*>(values.Get()), static_cast<vtkAbstractArray*>(names.Get()),
      static_cast<vtkAbstractArray*>(colors.Get()), static_cast<vtkAbstractArray*>(patient.Get()) })
  {
    image->GetFieldData()->AddArray(array);
  }
  const auto surface = Extracted(image);
  vtkFieldData* fields = surface->GetFieldData();
  auto* ordered = vtkStringArray::SafeDownCast(fields->GetAbstractArray("LabelNames"));
  ASSERT_NE(ordered, nullptr);
  ASSERT_EQ(ordered->GetNumberOfTuples(), 4);
  EXPECT_EQ(ordered->GetValue(0), "bone 1");
  EXPECT_EQ(ordered->GetValue(1), "");
  EXPECT_EQ(ordered->GetValue(2), "bone 3");
  EXPECT_EQ(fields->GetArray("LabelColors")->GetComponent(2, 0), 3.0);
  EXPECT_EQ(fields->GetArray("LabelColors")->GetComponent(1, 1), 0.0);
  EXPECT_NE(fields->GetAbstractArray("Patient"), nullptr);
  EXPECT_EQ(image->GetFieldData()->GetAbstractArray("LabelNames"), names.Get());
}

TEST(BoneSurfaces, HaveTheRequestedPrecision)
{
  const auto image = ImageOf(ObliqueEllipsoid(false));
  EXPECT_EQ(
    Extracted(image, vtkAlgorithm::DEFAULT_PRECISION)->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(
    Extracted(image, vtkAlgorithm::SINGLE_PRECISION)->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(
    Extracted(image, vtkAlgorithm::DOUBLE_PRECISION)->GetPoints()->GetDataType(), VTK_DOUBLE);
}
