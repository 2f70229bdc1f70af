// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// WritePicture with and without a display, and its error messages.
#include "Display.h"
#include "Picture.h"

#include "vtkElevationFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

namespace
{
using namespace bonedecimate;
namespace fs = std::filesystem;

/// Puts a variable of the environment back as it was.
class KeptVariable
{
public:
  explicit KeptVariable(const char* name)
    : Name(name)
    , Value(std::getenv(name) ? std::optional<std::string>(std::getenv(name)) : std::nullopt)
  {
  }
  ~KeptVariable()
  {
    this->Value ? setenv(this->Name, this->Value->c_str(), 1) : unsetenv(this->Name);
  }
  KeptVariable(const KeptVariable&) = delete;
  KeptVariable& operator=(const KeptVariable&) = delete;

private:
  const char* Name;
  std::optional<std::string> Value;
};

class PictureFile : public ::testing::Test
{
protected:
  void SetUp() override
  {
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(20.0);
    ball->SetThetaResolution(40);
    ball->SetPhiResolution(40);
    this->Elevation->SetInputConnection(ball->GetOutputPort());
    this->Elevation->SetLowPoint(0.0, 0.0, -20.0);
    this->Elevation->SetHighPoint(0.0, 0.0, 20.0);
    this->Elevation->Update();
    this->Subject.Before = this->Elevation->GetPolyDataOutput();
    this->Subject.After = this->Subject.Before;
    this->Subject.DistanceArrayName = "Elevation";
    this->Subject.Width = 600;
  }

  void TearDown() override { fs::remove_all(this->Folder); }

  std::string InFolder(const std::string& name) const { return (this->Folder / name).string(); }

  bool FolderIsEmpty() const { return fs::is_empty(this->Folder); }

  /// The picture is there, alone in its folder, and can be read.
  void ExpectPicture(const std::string& file) const
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], this->Subject.Width);
    EXPECT_GT(reader->GetOutput()->GetScalarRange()[1], reader->GetOutput()->GetScalarRange()[0]);
    EXPECT_EQ(std::distance(fs::directory_iterator(this->Folder), fs::directory_iterator()), 1);
  }

  const fs::path Folder =
    fs::path(TEMPORARY_FOLDER) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const KeptVariable Screen{ "DISPLAY" };
  const KeptVariable Path{ "PATH" };
  vtkNew<vtkElevationFilter> Elevation;
  PictureSubject Subject;
};

TEST_F(PictureFile, IsWrittenWithoutAnyDisplay)
{
  unsetenv("DISPLAY");
  EXPECT_EQ(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  this->ExpectPicture(this->InFolder("picture.png"));
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

TEST_F(PictureFile, IsWrittenWhereTheDisplayIsDead)
{
  setenv("DISPLAY", ":47110", 1);
  EXPECT_EQ(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  this->ExpectPicture(this->InFolder("picture.png"));
  EXPECT_STREQ(std::getenv("DISPLAY"), ":47110");
}

TEST_F(PictureFile, IsWrittenOnTheDisplayThereIs)
{
  const Display existing(Display::Choice::VirtualOnly);
  ASSERT_EQ(existing.GetProblem(), "");
  setenv("PATH", this->Folder.c_str(), 1); // no second server can be started
  EXPECT_EQ(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  this->ExpectPicture(this->InFolder("picture.png"));
}

TEST_F(PictureFile, ReplacesAnOlderOne)
{
  EXPECT_EQ(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  fs::resize_file(this->InFolder("picture.png"), 10);
  EXPECT_EQ(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  this->ExpectPicture(this->InFolder("picture.png"));
}

TEST_F(PictureFile, ShowsSurfacesWithoutDistances)
{
  this->Subject.DistanceArrayName = "no such array";
  EXPECT_EQ(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  this->ExpectPicture(this->InFolder("picture.png"));
}

TEST_F(PictureFile, ShowsAResultWithoutTriangles)
{
  vtkNew<vtkPolyData> nothing;
  this->Subject.After = nothing;
  EXPECT_EQ(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  this->ExpectPicture(this->InFolder("picture.png"));
}

TEST_F(PictureFile, IsRejectedForAnInputWithoutTriangles)
{
  vtkNew<vtkPolyData> nothing;
  this->Subject.Before = nothing;
  EXPECT_NE(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  this->Subject.Before = nullptr;
  EXPECT_NE(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  EXPECT_TRUE(this->FolderIsEmpty());
}

TEST_F(PictureFile, NamesTheFileInAFolderThatIsNotThere)
{
  const std::string file = this->InFolder("missing/picture.png");
  EXPECT_NE(WritePicture(this->Subject, file).find(file), std::string::npos);
  EXPECT_TRUE(this->FolderIsEmpty());
}

TEST_F(PictureFile, LeavesNothingBesideAFolderOfItsName)
{
  fs::create_directories(this->Folder / "picture.png" / "inside");
  EXPECT_NE(WritePicture(this->Subject, this->InFolder("picture.png")), "");
  EXPECT_TRUE(fs::is_directory(this->Folder / "picture.png" / "inside"));
  EXPECT_EQ(std::distance(fs::directory_iterator(this->Folder), fs::directory_iterator()), 1);
}

#ifdef BONEDECIMATE_RENDERS_THROUGH_X
/// The socket of a server: there as long as it runs. Another test's server takes the number, and
/// makes the file anew, as soon as it is free; the time tells the two apart.
struct Socket
{
  fs::path File = "/tmp/.X11-unix/X" + std::string(std::getenv("DISPLAY")).substr(1);
  fs::file_time_type Made = fs::last_write_time(this->File);

  bool IsThere() const
  {
    std::error_code missing;
    return fs::last_write_time(this->File, missing) == this->Made && !missing;
  }
};

TEST_F(PictureFile, SaysWhatIsMissingWithoutDisplayAndXvfb)
{
  unsetenv("DISPLAY");
  setenv("PATH", this->Folder.c_str(), 1);
  EXPECT_NE(
    WritePicture(this->Subject, this->InFolder("picture.png")).find("Xvfb"), std::string::npos);
  EXPECT_TRUE(this->FolderIsEmpty());
}

TEST_F(PictureFile, LeavesNoServerBehind)
{
  auto display = std::make_unique<Display>(Display::Choice::VirtualOnly);
  ASSERT_EQ(display->GetProblem(), "");
  const Socket socket;
  EXPECT_TRUE(socket.IsThere());
  display.reset();
  EXPECT_FALSE(socket.IsThere());
}

TEST_F(PictureFile, LeavesNoServerBehindWhereTheProgramIsAborted)
{
  const std::string note = this->InFolder("note");
  EXPECT_DEATH(
    {
      const Display display(Display::Choice::VirtualOnly);
      const Socket socket;
      std::ofstream(note) << socket.File.string() << ' ' << socket.Made.time_since_epoch().count();
      std::abort();
    },
    "");
  std::string file;
  fs::file_time_type::rep made = 0;
  ASSERT_TRUE(std::ifstream(note) >> file >> made);
  const Socket socket{ file, fs::file_time_type(fs::file_time_type::duration(made)) };
  for (int i = 0; i < 300 && socket.IsThere(); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_FALSE(socket.IsThere());
}
#endif
}
