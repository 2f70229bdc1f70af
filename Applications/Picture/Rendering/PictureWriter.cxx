// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureWriter.h"

#include "ComposedPicture.h"
#include "Display.h"

#include "vtkImageShrink3D.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
constexpr double HeightByWidth = 7.0 / 9.0;
// Mesa has no multisampling to rely on: everything is rendered larger and averaged.
constexpr int Oversampling = 2;

vtkSmartPointer<vtkUnsignedCharArray> RenderPng(const PictureSubject& subject)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  const int height = static_cast<int>(std::lround(subject.Width * HeightByWidth));
  window->SetSize(Oversampling * subject.Width, Oversampling * height);
  ComposePicture(window, subject);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(grab->GetOutputPort());
  average->SetShrinkFactors(Oversampling, Oversampling, 1);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(average->GetOutputPort());
  writer->SetCompressionLevel(7); // 9 takes five times as long for 4 % fewer bytes
  writer->WriteToMemoryOn();
  writer->Write();
  return writer->GetResult();
}

/// Into the file itself, never by renaming another: the process that reserved it holds a lock on
/// it.
std::string WriteWhole(vtkUnsignedCharArray* bytes, const std::string& file)
{
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
  stream.close();
  if (stream)
  {
    return {};
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  return "could not write the picture '" + file + "'";
}

std::string Write(const PictureSubject& subject, const std::string& file)
{
  if (!subject.Before || !subject.After ||
    subject.Before->GetNumberOfPolys() + subject.Before->GetNumberOfStrips() == 0)
  {
    return "there is no surface to show";
  }
  const Display display; // has to outlive the window
  if (!display.GetProblem().empty())
  {
    return display.GetProblem();
  }
  const auto bytes = RenderPng(subject);
  return bytes && bytes->GetNumberOfValues() > 0 ? WriteWhole(bytes, file) : "nothing was rendered";
}
}
}

const bonedecimate::PictureWriter BoneDecimatePictureWriter = { bonedecimate::Write };
