// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Phantom.h"

#include "BoneVolume.h"
#include "ComposedPicture.h"

#include "vtkExtractVOI.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"

namespace bonedecimate
{
namespace
{
constexpr double Hounsfield = 226.0;
constexpr int Width = 720; // pixels
constexpr int Height = 560;

vtkSmartPointer<vtkImageData> Cut(vtkImageData* image, int first, int last)
{
  vtkNew<vtkExtractVOI> cut;
  cut->SetInputData(image);
  cut->SetVOI(first, last, 0, Height - 1, 0, 0);
  cut->Update();
  // As if it had come from a file: images that begin at another pixel are never equal to
  // vtkTesting.
  vtkSmartPointer<vtkImageData> piece = cut->GetOutput();
  piece->SetExtent(0, last - first, 0, Height - 1, 0, 0);
  return piece;
}
}

vtkSmartPointer<vtkBoneDecimate> DecimatePhantom(const std::string& volume)
{
  const BoneSurface bone = ExtractBoneSurface(volume, Hounsfield);
  if (!bone.Surface)
  {
    return nullptr;
  }
  auto filter = vtkSmartPointer<vtkBoneDecimate>::New();
  filter->SetInputData(bone.Surface);
  filter->SetMeasureInputDistances(true);
  filter->Update();
  return filter;
}

PictureSubject SubjectOf(vtkBoneDecimate* filter)
{
  PictureSubject subject;
  subject.Before = filter->GetOutput(1);
  subject.After = filter->GetOutput(0);
  subject.DistanceArrayName = filter->GetInputDistanceArrayName();
  subject.Title = "Phantom";
  subject.Frame = "LPS";
  return subject;
}

PhantomPictures RenderPhantom(const PictureSubject& subject)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  ComposePicture(window, subject);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  const int third = 2 * Width / 3;
  return { Cut(grab->GetOutput(), 0, third - 1), Cut(grab->GetOutput(), third, Width - 1) };
}
}
