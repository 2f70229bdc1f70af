// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The pictures of the phantom compared with their baselines; wrong pictures must fail.
#include "ComposedPicture.h"
#include "Display.h"
#include "Phantom.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextActor.h"
#include "vtkVector.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace
{
using namespace bonedecimate;

// vtkTesting accepts what lies within two pixels or differs by less than a seventh of the range: a
// picture without its triangles' edges, or with the input in place of the result, passes there. So
// the difference is taken pixel by pixel, averaged over its neighbors because another Mesa moves
// edges by less than a pixel.
constexpr int PixelThreshold = 24; // of 3 * 255
constexpr double Tolerance =
  25.0; // another rasteriser: 4; a camera tilted by 1 degree: 640; colors reversed: 20,000

/// As a file of the format STL holds it.
vtkSmartPointer<vtkPolyData> WithPointsOfItsOwnForEachTriangle(vtkPolyData* surface)
{
  auto soup = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  soup->GetPointData()->CopyAllocate(surface->GetPointData());
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType from = corners->GetId(i);
      const vtkIdType to = points->InsertNextPoint(surface->GetPoint(from));
      soup->GetPointData()->CopyData(surface->GetPointData(), from, to);
      corners->SetId(i, to);
    }
    triangles->InsertNextCell(corners);
  }
  soup->SetPoints(points);
  soup->SetPolys(triangles);
  return soup;
}

/// The words over a picture, and how far from the left each of them is.
std::map<std::string, double> WordsOf(const PictureSubject& subject)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(900, 700);
  ComposePicture(window, subject);
  std::map<std::string, double> words;
  for (vtkIdType i = 0; i < window->GetRenderers()->GetNumberOfItems(); ++i)
  {
    auto* renderer =
      vtkRenderer::SafeDownCast(window->GetRenderers()->GetItemAsObject(static_cast<int>(i)));
    vtkPropCollection* props = renderer->GetViewProps();
    props->InitTraversal();
    while (vtkProp* prop = props->GetNextProp())
    {
      if (auto* text = vtkTextActor::SafeDownCast(prop))
      {
        words[text->GetInput()] = text->GetPosition()[0];
      }
    }
  }
  return words;
}

std::string Footer(const std::string& from)
{
  return "The camera is the same along each row. Seen from " + from + ", a little from above.";
}

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

  /// Difference of an image from a baseline. The image stays in the temporary folder.
  static double Difference(vtkImageData* image, const std::string& name)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName((std::string(TEMPORARY_FOLDER) + "/" + name + ".png").c_str());
    writer->Write();
    vtkNew<vtkPNGReader> baseline;
    baseline->SetFileName((std::string(BASELINE_FOLDER) + "/" + name + ".png").c_str());
    baseline->Update();
    EXPECT_EQ(
      vtkVector3i(baseline->GetOutput()->GetDimensions()), vtkVector3i(image->GetDimensions()));
    vtkNew<vtkImageDifference> difference;
    difference->SetInputData(image);
    difference->SetImageConnection(baseline->GetOutputPort());
    difference->AllowShiftOff();
    difference->AveragingOn();
    difference->SetThreshold(PixelThreshold);
    difference->Update();
    return difference->GetThresholdedError();
  }

  const Display Screen{ Display::Choice::VirtualOnly };
  vtkSmartPointer<vtkBoneDecimate> Filter;
  PictureSubject Subject;
};

TEST_F(PhantomImages, ColoredByDistanceLooksAsItDid)
{
  EXPECT_LT(Difference(RenderPhantom(this->Subject).Distance, "PhantomDistance"), Tolerance);
}

TEST_F(PhantomImages, BeforeAndAfterLookAsTheyDid)
{
  EXPECT_LT(
    Difference(RenderPhantom(this->Subject).BeforeAndAfter, "PhantomBeforeAndAfter"), Tolerance);
}

TEST_F(PhantomImages, DirectionsAreThoseOfTheFrame)
{
  const auto seen = [this](const std::string& frame)
  {
    this->Subject.Frame = frame;
    return WordsOf(this->Subject);
  };
  const auto inLps = seen("LPS");
  EXPECT_LT(inLps.at("R"), inLps.at("L"));
  EXPECT_EQ(inLps.count(Footer("the front")), 1U);
  const auto inRas = seen("RAS");
  EXPECT_LT(inRas.at("L"), inRas.at("R"));
  EXPECT_EQ(inRas.count(Footer("the back")), 1U);
  const auto unknown = seen("");
  EXPECT_EQ(unknown.count("L") + unknown.count("R"), 0U);
  EXPECT_EQ(unknown.count(Footer("the side of -y")), 1U);
}

TEST_F(PhantomImages, AnUnweldedInputLooksTheSame)
{
  const auto soup = WithPointsOfItsOwnForEachTriangle(this->Subject.Before);
  this->Subject.Before = soup;
  const auto pictures = RenderPhantom(this->Subject);
  EXPECT_LT(Difference(pictures.BeforeAndAfter, "PhantomBeforeAndAfter"), Tolerance);
  EXPECT_LT(Difference(pictures.Distance, "PhantomDistance"), Tolerance);
}

TEST_F(PhantomImages, DistancesTurnedRoundAreSeen)
{
  vtkDataArray* distances =
    this->Subject.Before->GetPointData()->GetArray(this->Subject.DistanceArrayName.c_str());
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
  EXPECT_GT(Difference(RenderPhantom(this->Subject).Distance, "PhantomDistance"), 10.0 * Tolerance);
}

TEST_F(PhantomImages, TheInputInsteadOfTheResultIsDetected)
{
  this->Subject.After = this->Subject.Before;
  EXPECT_GT(Difference(RenderPhantom(this->Subject).BeforeAndAfter, "PhantomBeforeAndAfter"),
    10.0 * Tolerance);
}
}
