// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneView.h"

#include "ColorFunction.h"
#include "SurfaceDistances.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <array>
#include <cstddef>

namespace bonedecimate
{
namespace
{
void AimCamera(vtkCamera* camera, const Viewpoint& view, const Frame& frame)
{
  camera->ParallelProjectionOn();
  camera->SetParallelScale(frame.HalfHeight);
  camera->SetFocalPoint(frame.Center.data());
  std::array<double, 3> position;
  for (std::size_t i = 0; i < 3; ++i)
  {
    position[i] = frame.Center[i] + 10.0 * frame.HalfHeight * view.ToViewer[i];
  }
  camera->SetPosition(position.data());
  camera->SetViewUp(view.Up.data());
}
}

double Area::Aspect(vtkRenderWindow* window) const
{
  const int* size = window->GetSize();
  const double width = (this->UpperRight[0] - this->LowerLeft[0]) * size[0];
  const double height = (this->UpperRight[1] - this->LowerLeft[1]) * size[1];
  return width / height;
}

vtkSmartPointer<vtkPolyData> TrianglesWithNormals(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(
    MergedTriangles(surface)); // unmerged it would look faceted beside its result
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkActor> MakeBone(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  auto bone = vtkSmartPointer<vtkActor>::New();
  bone->SetMapper(mapper);
  vtkProperty* property = bone->GetProperty();
  property->SetColor(0.93, 0.87, 0.76);
  property->SetAmbient(0.08);
  property->SetDiffuse(0.92);
  property->SetSpecular(0.12);
  property->SetSpecularPower(18.0);
  return bone;
}

void ShadeFlat(vtkActor* bone)
{
  bone->GetProperty()->SetInterpolationToFlat();
}

void ShowTriangles(vtkActor* bone, double lineWidth)
{
  ShadeFlat(bone);
  vtkProperty* property = bone->GetProperty();
  property->EdgeVisibilityOn();
  property->SetEdgeColor(0.42, 0.34, 0.26);
  property->SetLineWidth(static_cast<float>(lineWidth));
}

void ColorByDistance(vtkActor* bone, const std::string& arrayName, const ColorScale& scale)
{
  vtkMapper* mapper = bone->GetMapper();
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(arrayName.c_str());
  mapper->SetLookupTable(MakeColorFunction(scale));
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  mapper->ScalarVisibilityOn();
  // Less shadow and no shine, so that the colors can be read off.
  vtkProperty* property = bone->GetProperty();
  property->SetAmbient(0.3);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.0);
}

void ColorByLabel(vtkActor* bone, const std::vector<NamedLabel>& labels)
{
  if (labels.empty() || (labels.size() == 1 && !labels[0].Color))
  {
    return;
  }
  auto* const mapper = vtkPolyDataMapper::SafeDownCast(bone->GetMapper());
  const auto colors = ColorsOfTriangles(mapper->GetInput(), WithColors(labels));
  if (!colors)
  {
    return;
  }
  vtkNew<vtkPolyData> colored;
  colored->ShallowCopy(mapper->GetInput());
  colored->GetCellData()->AddArray(colors);
  mapper->SetInputData(colored);
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray(colors->GetName());
  mapper->SetColorModeToDirectScalars();
  mapper->ScalarVisibilityOn();
}

void AddBackdrop(vtkRenderWindow* window)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->InteractiveOff();
  window->AddRenderer(renderer);
}

void AddView(vtkRenderWindow* window, const Area& area, vtkActor* bone, const Viewpoint& view,
  const Frame& frame)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(
    area.LowerLeft[0], area.LowerLeft[1], area.UpperRight[0], area.UpperRight[1]);
  renderer->SetBackground(0.965, 0.97, 0.975);
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(1.0);
  lights->SetKeyLightAngle(45.0, -35.0); // from above and the left, as in atlases
  lights->SetKeyToFillRatio(3.0);
  lights->SetKeyToHeadRatio(4.0);
  lights->SetKeyToBackRatio(5.0);
  lights->AddLightsToRenderer(renderer);
  renderer->AddActor(bone);
  AimCamera(renderer->GetActiveCamera(), view, frame);
  renderer->ResetCameraClippingRange();
  window->AddRenderer(renderer);
}
}
