// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the baselines of the image tests; the target RemakePictures runs it.
#include "Display.h"
#include "Phantom.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <iostream>

namespace
{
using namespace bonedecimate;

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
}

int main(int argc, char* argv[])
{
  // Mesa's rendering, as in the tests, whatever display there is.
  const Display display(Display::Choice::VirtualOnly);
  const bool isMade = argc == 3 && display.GetProblem().empty() && MakeBaselines(argv[1], argv[2]);
  if (!isMade)
  {
    std::cerr << "usage: MakePictures SMALL_VOLUME BASELINE_FOLDER\n"
              << display.GetProblem() << "\n";
  }
  return isMade ? 0 : 1;
}
