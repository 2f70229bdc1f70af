// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneSurfaces against VTK's own extraction.
#include "BruteForce.h"
#include "LabelImages.h"
#include "RejectionWalk.h"
#include "VtkSurfaces.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneSurfaces.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDiscreteFlyingEdges3D.h"
#include "vtkExtractVOI.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// In units of 1e-4 mm.
using Position = std::array<long, 3>;

std::multiset<Position> PositionsOf(vtkPolyData* surface)
{
  std::multiset<Position> positions;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    const double* x = surface->GetPoint(p);
    positions.insert({ std::lround(1e4 * x[0]), std::lround(1e4 * x[1]), std::lround(1e4 * x[2]) });
  }
  return positions;
}

/// A voxel of background on all sides, as VTK's filters need it for closed surfaces.
LabelMap Padded(const LabelMap& map)
{
  const auto& size = map.Grid.Dimensions;
  LabelMap padded = MakeLabelMap({ size[0] + 2, size[1] + 2, size[2] + 2 },
    [&](const std::array<Index, 3>& v)
    {
      const bool isInside =
        v[0] > 0 && v[1] > 0 && v[2] > 0 && v[0] <= size[0] && v[1] <= size[1] && v[2] <= size[2];
      return isInside ? map.Labels[static_cast<std::size_t>(v[0] - 1 +
                          size[0] * (v[1] - 1 + static_cast<Index>(size[1]) * (v[2] - 1)))]
                      : 0;
    });
  const auto dimensions = padded.Grid.Dimensions;
  padded.Grid = map.Grid;
  padded.Grid.Dimensions = dimensions;
  padded.Grid.Origin = map.Grid.ToMillimeters(Vector3::Constant(-1.0));
  return padded;
}

}

TEST(BoneSurfaces, OfTwoLabelsHaveThePointsOfFlyingEdges)
{
  for (const LabelMap& map : { NoiseLabels({ 17, 12, 14 }, 2, 1), ObliqueEllipsoid(false) })
  {
    LabelMap binary = map;
    binary.Grid.Direction.setIdentity(); // vtkFlyingEdges3D has no other
    binary.Grid.Direction.setIdentity(); // vtkFlyingEdges3D has no other
    std::transform(map.Labels.begin(), map.Labels.end(), binary.Labels.begin(),
      [](std::int32_t label) { return label > 0 ? 1 : 0; });
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(ImageOf(Padded(binary)));
    edges->SetValue(0, 0.5);
    edges->Update();
    const auto surface = Extracted(ImageOf(binary));
    EXPECT_GT(surface->GetNumberOfPoints(), 100);
    EXPECT_EQ(PositionsOf(surface), PositionsOf(edges->GetOutput()));
  }
}

/// A label alone: the points of the discrete filter, and where three labels meet, also those on
/// faces and in cells.
TEST(BoneSurfaces, OfALabelHaveThePointsOfDiscreteFlyingEdges)
{
  const LabelMap map = NoiseLabels({ 12, 11, 10 }, 4, 2);
  const auto all = Extracted(ImageOf(map));
  for (int label = 1; label < 4; ++label)
  {
    vtkNew<vtkDiscreteFlyingEdges3D> edges;
    edges->SetInputData(ImageOf(Padded(map)));
    edges->SetValue(0, label);
    edges->Update();
    vtkNew<vtkPolyData> single;
    EXPECT_TRUE(vtkBoneSurfaces::ExtractLabel(all, label, single));
    const auto ofSingle = PositionsOf(single);
    const auto ofEdges = PositionsOf(edges->GetOutput());
    EXPECT_TRUE(std::includes(ofSingle.begin(), ofSingle.end(), ofEdges.begin(), ofEdges.end()));
    EXPECT_EQ(CountWithVtk(single).BoundaryEdges, 0);
    EXPECT_EQ(CountWithVtk(single).NonManifoldEdges, 0);
    EXPECT_GT(SignedVolume(SurfaceOf(single)), 0.0);
  }
}

TEST(BoneSurfaces, GiveEveryVoxelItsLabelAfterDirectionAndExtentOfTheImage)
{
  for (const bool isMirrored : { false, true })
  {
    const LabelMap map = ObliqueEllipsoid(isMirrored);
    const auto surface = Extracted(ImageOf(map, VTK_SHORT, { 5, -7, 3 }));
    std::vector<BoundaryLabels> labels = LabelsOf(surface);
    for (BoundaryLabels& both : labels)
    {
      for (Index& label : both)
      {
        label = label == 0 ? 3 : label - 1; // the values are 1, 2, 3 and 0
      }
    }
    const std::vector<Index> voxels = VoxelizeLabels(SurfaceOf(surface), labels, map.Grid, 3, 0);
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      ASSERT_EQ(voxels[i], map.Labels[i] == 0 ? 3 : map.Labels[i] - 1) << "voxel " << i;
    }
  }
}

TEST(BoneSurfaces, OfCellsAreThoseOfVoxelsAtTheCellCenters)
{
  const LabelMap map = ObliqueEllipsoid(false);
  const auto ofPoints = ImageOf(map);
  vtkNew<vtkImageData> ofCells;
  const auto& size = map.Grid.Dimensions;
  ofCells->SetDimensions(size[0] + 1, size[1] + 1, size[2] + 1);
  const Vector3 origin = map.Grid.ToMillimeters(Vector3::Constant(-0.5));
  ofCells->SetOrigin(origin.data());
  ofCells->SetSpacing(map.Grid.Spacing.data());
  ofCells->SetDirectionMatrix(ofPoints->GetDirectionMatrix());
  ofCells->GetCellData()->SetScalars(ofPoints->GetPointData()->GetScalars());
  EXPECT_EQ(PositionsOf(Extracted(ofCells)), PositionsOf(Extracted(ofPoints)));
}

TEST(BoneSurfaces, ChooseLabelsBackgroundAndArray)
{
  const LabelMap map = EllipsoidLabels({ 12, 11, 10 });
  const auto image = ImageOf(map);
  vtkNew<vtkIntArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(static_cast<vtkIdType>(map.Labels.size()));
  other->Fill(4);
  other->SetValue(700, 6);
  image->GetPointData()->AddArray(other);
  vtkNew<vtkBoneSurfaces> filter;
  filter->SetInputData(image);
  filter->AddLabel(3);
  filter->AddLabel(1);
  EXPECT_EQ(filter->GetNumberOfLabels(), 2);
  EXPECT_EQ(filter->GetLabel(1), 1);
  EXPECT_EQ(filter->GetLabel(2), 0);
  filter->Update();
  std::set<BoundaryLabels> walls;
  for (const BoundaryLabels& both : LabelsOf(filter->GetOutput()))
  {
    walls.insert(both);
  }
  EXPECT_EQ(walls, (std::set<BoundaryLabels>{ { 1, 0 }, { 1, 3 }, { 3, 0 } }));
  filter->RemoveAllLabels();
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
  filter->SetBackgroundLabel(4);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 8);
  filter->SetBackgroundLabel(6);
  filter->ClosedOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 8);
  EXPECT_LT(SignedVolume(SurfaceOf(filter->GetOutput())), 0.0) << "a cavity";
}

TEST(BoneSurfaces, WarnOfAChosenLabelThatNoVoxelHas)
{
  vtkNew<vtkBoneSurfaces> filter;
  filter->SetInputData(ImageOf(EllipsoidLabels({ 12, 11, 10 })));
  filter->AddLabel(1);
  filter->AddLabel(99);
  std::string said;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&said);
  observer->SetCallback([](vtkObject*, unsigned long, void* client, void* text)
    { *static_cast<std::string*>(client) += static_cast<const char*>(text); });
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  EXPECT_NE(said.find("no voxel has the label 99"), std::string::npos) << said;
  EXPECT_EQ(said.find("label 1\n"), std::string::npos);
}

TEST(BoneSurfaces, AreThoseOfTheWholeImageInAPipeline)
{
  const auto image = ImageOf(EllipsoidLabels({ 16, 14, 12 }));
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  vtkNew<vtkExtractVOI> part;
  part->SetInputConnection(producer->GetOutputPort());
  part->SetVOI(0, 15, 0, 13, 0, 11);
  vtkNew<vtkBoneSurfaces> filter;
  filter->SetInputConnection(part->GetOutputPort());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), Extracted(image)->GetNumberOfCells());
}

TEST(BoneSurfaces, ComeInPiecesThatFitTogether)
{
  const auto image = ImageOf(EllipsoidLabels({ 16, 14, 12 }));
  const auto whole = Extracted(image);
  vtkDataArray* labels = whole->GetCellData()->GetArray("BoundaryLabels");
  vtkNew<vtkBoneSurfaces> filter;
  filter->SetInputData(image);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkIdType cell = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    filter->UpdatePiece(piece, 3, 0);
    vtkPolyData* part = filter->GetOutput();
    EXPECT_NEAR(part->GetNumberOfCells(), whole->GetNumberOfCells() / 3.0, 1.0);
    std::set<vtkIdType> used;
    for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i, ++cell)
    {
      const double* pair = part->GetCellData()->GetArray("BoundaryLabels")->GetTuple(i);
      EXPECT_EQ(pair[0], labels->GetComponent(cell, 0));
      EXPECT_EQ(pair[1], labels->GetComponent(cell, 1));
      for (int corner = 0; corner < 3; ++corner)
      {
        const vtkIdType id = part->GetCell(i)->GetPointId(corner);
        const vtkIdType idOfWhole = whole->GetCell(cell)->GetPointId(corner);
        used.insert(id);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_EQ(part->GetPoint(id)[axis], whole->GetPoint(idOfWhole)[axis]);
          EXPECT_EQ(part->GetPointData()->GetArray("GridPoint")->GetComponent(id, axis),
            whole->GetPointData()->GetArray("GridPoint")->GetComponent(idOfWhole, axis));
        }
      }
    }
    EXPECT_EQ(static_cast<vtkIdType>(used.size()), part->GetNumberOfPoints());
  }
  EXPECT_EQ(cell, whole->GetNumberOfCells());
}

TEST(BoneSurfaces, RejectsAnImageThatIsAPiece)
{
  const auto producer = PieceOf(ImageOf(EllipsoidLabels({ 16, 14, 12 })));
  vtkNew<vtkBoneSurfaces> filter;
  filter->SetInputConnection(producer->GetOutputPort());
  ErrorTexts errors(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(errors.Count("one of several pieces"), 1);
}

TEST(BoneSurfaces, CanBeDecimatedWithTheirLabels)
{
  vtkNew<vtkBoneSurfaces> surfaces;
  surfaces->SetInputData(ImageOf(EllipsoidLabels({ 20, 18, 16 })));
  vtkNew<vtkBoneDecimate> decimate;
  decimate->SetInputConnection(surfaces->GetOutputPort());
  decimate->SetLabelArrayName("BoundaryLabels");
  decimate->SetTargetReduction(0.5);
  decimate->Update();
  vtkPolyData* output = decimate->GetOutput();
  EXPECT_LT(output->GetNumberOfCells(), 0.6 * surfaces->GetOutput()->GetNumberOfCells());
  for (int label = 1; label < 4; ++label)
  {
    vtkNew<vtkPolyData> single;
    EXPECT_TRUE(vtkBoneSurfaces::ExtractLabel(output, label, single));
    EXPECT_EQ(CountWithVtk(single).BoundaryEdges, 0);
    EXPECT_EQ(CountWithVtk(single).NonManifoldEdges, 0);
  }
}

TEST(BoneSurfaces, RejectImagesWithoutLabels)
{
  const auto errorOf = [](vtkImageData* image, bool closed)
  {
    vtkNew<vtkBoneSurfaces> filter;
    ErrorTexts errors(filter);
    filter->SetInputData(image);
    filter->SetClosed(closed);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints() == 0, !errors.Texts.empty());
    return errors.Texts.empty() ? std::string() : errors.Texts.front();
  };
  const auto contains = [](const std::string& text, const std::string& part)
  { return text.find(part) != std::string::npos; };
  vtkNew<vtkImageData> empty;
  empty->SetDimensions(2, 3, 4);
  EXPECT_TRUE(contains(errorOf(empty, true), "the image has no labels"));
  const auto fractions = ImageOf(EllipsoidLabels({ 5, 6, 7 }), VTK_FLOAT);
  fractions->GetPointData()->GetScalars()->SetTuple1(17, 1.25);
  EXPECT_TRUE(
    contains(errorOf(fractions, true), "not whole numbers, the first is that of voxel 17"));
  fractions->GetPointData()->GetScalars()->SetTuple1(17, NAN);
  EXPECT_TRUE(contains(errorOf(fractions, true), "voxel 17"));
  const auto colors = ImageOf(EllipsoidLabels({ 5, 6, 7 }));
  colors->AllocateScalars(VTK_SHORT, 3);
  EXPECT_TRUE(contains(errorOf(colors, true), "several components"));
  EXPECT_TRUE(contains(errorOf(ImageOf(EllipsoidLabels({ 5, 6, 1 })), false), "one voxel thin"));
  EXPECT_EQ(errorOf(ImageOf(EllipsoidLabels({ 5, 6, 1 })), true), "");
}

TEST(BoneSurfaces, AreThoseOfTheOnlyArrayIfNoneIsActive)
{
  const auto image = ImageOf(EllipsoidLabels({ 8, 7, 6 }));
  const vtkIdType cells = Extracted(image)->GetNumberOfCells();
  image->GetPointData()->GetScalars()->SetName("Labels");
  image->GetPointData()->SetActiveScalars(nullptr);
  EXPECT_EQ(Extracted(image)->GetNumberOfCells(), cells);
  vtkNew<vtkBoneSurfaces> filter;
  ErrorTexts errors(filter);
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
  filter->Update();
  ASSERT_EQ(errors.Texts.size(), 1U);
  EXPECT_NE(
    errors.Texts[0].find("of points there are: 'Labels'; of cells: none"), std::string::npos)
    << errors.Texts[0];
}

TEST(BoneSurfaces, ExtractNothingOfALabelThatIsNotThere)
{
  vtkNew<vtkPolyData> single;
  EXPECT_FALSE(vtkBoneSurfaces::ExtractLabel(Sphere(1), 1, single));
  EXPECT_FALSE(
    vtkBoneSurfaces::ExtractLabel(Extracted(ImageOf(EllipsoidLabels({ 8, 7, 6 }))), 8, single));
  EXPECT_EQ(single->GetNumberOfPoints(), 0);
}

TEST(BoneSurfaces, PrintTheirProperties)
{
  vtkNew<vtkBoneSurfaces> filter;
  filter->AddLabel(12);
  std::ostringstream text;
  filter->Print(text);
  for (const char* property : { "Labels: 12", "BackgroundLabel: 0", "Closed: on", "ModelGrid: auto",
         "NumberOfThreads: 0", "OutputPointsPrecision: 2" })
  {
    EXPECT_NE(text.str().find(property), std::string::npos) << property;
  }
}

TEST(BoneSurfaces, ExtractsNoLabelOfASurfaceWithAPointThatIsNotThere)
{
  const vtkSmartPointer<vtkPolyData> surface = Extracted(ImageOf(EllipsoidLabels({ 8, 7, 6 })));
  vtkNew<vtkPolyData> single;
  EXPECT_TRUE(vtkBoneSurfaces::ExtractLabel(surface, 1, single));
  surface->GetPolys()->ReplaceCellAtId(0, { 0, 1, 1000000 });
  EXPECT_FALSE(vtkBoneSurfaces::ExtractLabel(surface, 1, single));
  EXPECT_EQ(single->GetNumberOfPoints(), 0);
}
