// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// A file that is not what was proved: the check after writing, with a surface that changed in
// between.
#include "ExitCode.h"
#include "Files/WrittenProof.h"
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Error = 0.3; // mm

class WrittenProof : public testing::Test
{
protected:
  WrittenProof()
    : Input(Bumps(3))
    , Run(this->Input)
  {
    this->Run->SetMaximumError(Error);
    this->Output = SurfaceOf(this->Run.Output());
  }

  std::string Prove(const Surface& readBack)
  {
    return ProveWritten(
      { this->Input, this->Run.Output(), Error, "", true, 1 }, PolyData(readBack), "bone.ply");
  }

  vtkSmartPointer<vtkPolyData> Input;
  FilterRun Run;
  Surface Output;
};
}

TEST_F(WrittenProof, OfTheSameBitsNeedsNoSecondCertificate)
{
  EXPECT_EQ(this->Prove(this->Output), "same_bits");
  EXPECT_EQ(this->Prove(Unwelded(this->Output)), "same_bits") << "as STL files are read";
}

TEST_F(WrittenProof, OfOtherBitsIsTheCertificateOfTheFile)
{
  this->Output.Points[0].x() += 1e-9;
  EXPECT_EQ(this->Prove(this->Output), "certified");
}

TEST_F(WrittenProof, OfADamagedFileIsAFailureWithItsCodeAndTheDistance)
{
  this->Output.Points[0] *= 1.2;
  try
  {
    this->Prove(this->Output);
    FAIL() << "nothing was noticed";
  }
  catch (const Failure& failure)
  {
    EXPECT_EQ(failure.Code, ExitCode::Violated);
    EXPECT_NE(std::string(failure.what()).find("'bone.ply' as it was read back contradicts"),
      std::string::npos)
      << failure.what();
  }
}

TEST_F(WrittenProof, OfAFileWithoutATriangleIsAFailure)
{
  this->Output.Triangles.pop_back();
  EXPECT_THROW(this->Prove(this->Output), Failure);
}
