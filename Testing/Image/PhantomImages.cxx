// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The phantom's pictures against their baselines, and wrong pictures, which must not pass for right ones.
#include "Display.h"
#include "Phantom.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTesting.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
using namespace bonedecimate;

// Sum of what differs beyond a pixel's neighbourhood; a caption with another number is already above 100.
constexpr double Tolerance = 25.0;

class PhantomImages : public ::testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_EQ(this->Screen.GetProblem(), "");
    this->Filter = DecimatePhantom(PHANTOM_VOLUME);
    ASSERT_TRUE(this->Filter);
    this->Subject = SubjectOf(this->Filter);
  }

  /// Whether an image is the baseline; VTK's differences stay in the temporary folder.
  static bool IsBaseline(vtkImageData* image, const std::string& name, std::string& difference)
  {
    vtkNew<vtkTrivialProducer> source;
    source->SetOutput(image);
    vtkNew<vtkTesting> testing;
    testing->AddArgument("-V");
    testing->AddArgument((std::string(BASELINE_FOLDER) + "/" + name + ".png").c_str());
    testing->AddArgument("-T");
    testing->AddArgument(TEMPORARY_FOLDER);
    std::ostringstream output;
    const int result = testing->RegressionTest(source, Tolerance, output);
    difference = std::to_string(testing->GetImageDifference()) + "\n" + output.str();
    return result == vtkTesting::PASSED;
  }

  const Display Screen{ Display::Choice::VirtualOnly };
  vtkSmartPointer<vtkBoneDecimate> Filter;
  PictureSubject Subject;
};

TEST_F(PhantomImages, ColouredByDistanceLooksAsItDid)
{
  std::string difference;
  EXPECT_TRUE(IsBaseline(RenderPhantom(this->Subject).Distance, "PhantomDistance", difference)) << difference;
}

TEST_F(PhantomImages, BeforeAndAfterLookAsTheyDid)
{
  std::string difference;
  EXPECT_TRUE(IsBaseline(RenderPhantom(this->Subject).BeforeAndAfter, "PhantomBeforeAndAfter", difference))
    << difference;
}

TEST_F(PhantomImages, DistancesTurnedRoundAreSeen)
{
  vtkDataArray* distances = this->Subject.Before->GetPointData()->GetArray(this->Subject.DistanceArrayName.c_str());
  const double largest = distances->GetRange(0)[1];
  vtkNew<vtkDoubleArray> turned;
  turned->SetName("turned");
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    turned->InsertNextValue(largest - distances->GetComponent(i, 0));
  }
  vtkNew<vtkPolyData> before;
  before->ShallowCopy(this->Subject.Before);
  before->GetPointData()->AddArray(turned);
  this->Subject.Before = before;
  this->Subject.DistanceArrayName = "turned";
  std::string difference;
  EXPECT_FALSE(IsBaseline(RenderPhantom(this->Subject).Distance, "PhantomDistance", difference)) << difference;
}

TEST_F(PhantomImages, TheInputInPlaceOfTheResultIsSeen)
{
  this->Subject.After = this->Subject.Before;
  std::string difference;
  EXPECT_FALSE(IsBaseline(RenderPhantom(this->Subject).BeforeAndAfter, "PhantomBeforeAndAfter", difference))
    << difference;
}
}
