// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the baselines of the image tests and the picture of the README; the target RemakePictures
// runs it.
#include "Display.h"
#include "Phantom.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <iostream>

namespace
{
using namespace bonedecimate;

constexpr int ReadmeWidth = 840; // pixels, about what a browser gives a README

void WriteBaseline(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
}

bool MakeBaselines(const std::string& volume, const std::string& folder)
{
  const auto filter = DecimatePhantom(volume);
  if (!filter)
  {
    return false;
  }
  const PhantomPictures pictures = RenderPhantom(SubjectOf(filter));
  WriteBaseline(pictures.BeforeAndAfter, folder + "/PhantomBeforeAndAfter.png");
  WriteBaseline(pictures.Distance, folder + "/PhantomDistance.png");
  return true;
}

bool MakeReadmePicture(const std::string& volume, const std::string& file)
{
  const auto filter = DecimatePhantom(volume);
  if (!filter)
  {
    return false;
  }
  PictureSubject subject = SubjectOf(filter);
  subject.Title = "A phantom of a broken leg";
  subject.Width = ReadmeWidth;
  return WritePicture(subject, file).empty();
}
}

int main(int argc, char* argv[])
{
  // Mesa's rendering, as in the tests, whatever display there is.
  const Display display(Display::Choice::VirtualOnly);
  const bool isMade = argc == 5 && display.GetProblem().empty() &&
    MakeBaselines(argv[1], argv[2]) && MakeReadmePicture(argv[3], argv[4]);
  if (!isMade)
  {
    std::cerr << "usage: MakePictures SMALL_VOLUME BASELINE_FOLDER NORMAL_VOLUME README_PICTURE\n"
              << display.GetProblem() << "\n";
  }
  return isMade ? 0 : 1;
}
