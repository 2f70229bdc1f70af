// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the baselines of the image tests: MakeBaselines VOLUME FOLDER. The target RemakeImageBaselines runs it.
#include "Display.h"
#include "Phantom.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <iostream>

namespace
{
void Write(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
  std::cout << file << "\n";
}
}

int main(int argc, char* argv[])
{
  const bonedecimate::Display display(bonedecimate::Display::Choice::VirtualOnly);
  const auto filter = argc == 3 ? bonedecimate::DecimatePhantom(argv[1]) : nullptr;
  if (!filter || !display.GetProblem().empty())
  {
    std::cerr << "usage: MakeBaselines VOLUME FOLDER\n" << display.GetProblem() << "\n";
    return 1;
  }
  const auto pictures = bonedecimate::RenderPhantom(bonedecimate::SubjectOf(filter));
  const std::string folder = argv[2];
  Write(pictures.BeforeAndAfter, folder + "/PhantomBeforeAndAfter.png");
  Write(pictures.Distance, folder + "/PhantomDistance.png");
  return 0;
}
