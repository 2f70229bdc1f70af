// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The content of the HTML page of a run.
#include "Base/Text.h"
#include "NumberText.h"
#include "Page.h"

#include "vtkBoneDecimate.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace
{
using namespace bonedecimate;

class Page : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Ball->SetRadius(30.0);
    this->Ball->SetThetaResolution(60);
    this->Ball->SetPhiResolution(60);
    this->Filter->SetInputConnection(this->Ball->GetOutputPort());
    this->Filter->SetMeasureInputDistances(true);
    this->Subject.Name = "ball";
  }

  std::string Compose()
  {
    this->Filter->Update();
    this->Subject.Result = this->Filter->GetOutput(0);
    this->Subject.Before = this->Filter->GetOutput(1);
    this->Subject.ResultDistanceArrayName = "Distance";
    this->Subject.DistanceArrayName = this->Filter->GetInputDistanceArrayName();
    return ComposePage(this->Subject);
  }

  vtkNew<vtkSphereSource> Ball;
  vtkNew<vtkBoneDecimate> Filter;
  PageSubject Subject;
};

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST_F(Page, HoldsEveryCountOfBothSurfaces)
{
  const std::string page = this->Compose();
  for (const std::string side : { "input.", "output." })
  {
    for (const char* name : { "triangles", "points", "components", "boundary_edges",
           "non_manifold_edges", "euler_number" })
    {
      const std::string text = GroupedText(this->Filter->GetReportValue(side + name));
      EXPECT_TRUE(Contains(page, "<td>" + text + "</td>")) << side << name << " " << text;
    }
    for (const char* name : { "area", "volume", "shape.smallest_angle", "shape.largest_angle" })
    {
      const std::string text = GroupedText(this->Filter->GetReportValue(side + name), 1);
      EXPECT_TRUE(Contains(page, "<td>" + text + "</td>")) << side << name << " " << text;
    }
  }
}

TEST_F(Page, HoldsTheDistancesOfBothDirections)
{
  const std::string page = this->Compose();
  for (const std::string side : { "distance.output_to_input.", "distance.input_to_output." })
  {
    for (const char* name : { "max", "mean", "rms" })
    {
      const double value = this->Filter->GetReportValue(side + name);
      EXPECT_GT(value, 0.0);
      EXPECT_TRUE(Contains(page, "<td>" + EscapedXml(MeasuredText(value)) + "</td>"))
        << side << name;
    }
    EXPECT_TRUE(
      Contains(page, GroupedText(this->Filter->GetReportValue(side + "samples")) + " samples"));
    EXPECT_TRUE(Contains(
      page, ShortText(this->Filter->GetReportValue(side + "samples_per_mm2")) + " per mm"));
  }
}

/// The number behind the first such text of a page; not a number if there is none.
double NumberBehind(const std::string& page, const std::string& text)
{
  const std::size_t at = page.find(text);
  return at == std::string::npos ? std::nan("")
                                 : std::strtod(page.c_str() + at + text.size(), nullptr);
}

void ExpectRoundedUp(double shown, double bound, double step, const std::string& what)
{
  EXPECT_GE(shown, bound) << what;
  EXPECT_LE(shown, bound + 2.0 * step) << what;
}

constexpr double StepOfHeadline = 1e-4; // mm
constexpr double StepOfTable = 1e-6;

TEST_F(Page, StatesTheProofOfBothDirectionsAndOfOpenBoundaries)
{
  this->Ball->SetEndPhi(120.0);
  this->Filter->SetMaximumError(0.25);
  const std::string page = this->Compose();
  const auto upper = [this](const std::string& name)
  { return this->Filter->GetReportValue("proof." + name + "upper"); };
  ASSERT_LE(upper(""), 0.25);
  ExpectRoundedUp(NumberBehind(page, "<strong>at most "), upper(""), StepOfHeadline, "headline");
  ExpectRoundedUp(
    NumberBehind(page, "but no farther than the proved "), upper(""), StepOfHeadline, "note");
  EXPECT_TRUE(Contains(page, "<em>proved</em>"));
  EXPECT_TRUE(Contains(page, "Open boundaries are as close to each other. Requested: 0.25 mm."));
  EXPECT_TRUE(Contains(page, "Requested: 0.25 mm. It is proved."));
  const std::pair<const char*, const char*> rows[] = { { "both directions", "" },
    { "simplified to original", "output_to_input." },
    { "original to simplified", "input_to_output." },
    { "open boundaries, simplified to original", "boundary_output_to_input." },
    { "open boundaries, original to simplified", "boundary_input_to_output." } };
  for (const auto& [title, name] : rows)
  {
    const std::string begin = "<th scope=\"row\">" + std::string(title) + "</th><td>";
    const double lower = NumberBehind(page, begin);
    EXPECT_LE(lower, this->Filter->GetReportValue("proof." + std::string(name) + "lower")) << title;
    const std::size_t end = page.find("</td><td>", page.find(begin));
    ExpectRoundedUp(NumberBehind(page.substr(end), "</td><td>"), upper(name), StepOfTable, title);
  }
}

TEST_F(Page, SaysWhatIsNotProved)
{
  EXPECT_TRUE(Contains(this->Compose(), "Nothing is proved about the distance"));
  EXPECT_TRUE(Contains(this->Compose(), "no largest error was requested"));
  this->Filter->SetMaximumError(0.25);
  this->Filter->SetMergePoints(false);
  EXPECT_TRUE(Contains(this->Compose(), "Not proved: the distance of open boundaries"));
  EXPECT_TRUE(Contains(this->Compose(), "Exceptions</a>: "));
  this->Filter->SetProveResult(false);
  EXPECT_TRUE(Contains(this->Compose(), "the proof was switched off"));
  this->Filter->SetProveResult(true);
  this->Filter->SetModeToThesis();
  const std::string page = this->Compose();
  EXPECT_TRUE(Contains(page, "<em>measured, not proved</em>"));
  EXPECT_TRUE(Contains(page, "mode Thesis proves no largest error"));
  EXPECT_FALSE(Contains(page, "no farther than the proved"));
}

TEST_F(Page, ShowsNoMeasuredDistanceAboveTheBound)
{
  for (const double error : { 0.05, 0.1, 0.2, 0.5 })
  {
    this->Filter->SetMaximumError(error);
    const std::string page = this->Compose();
    const double bound = NumberBehind(page, "<strong>at most ");
    const std::string row = "Largest measured</th><td>";
    EXPECT_GT(NumberBehind(page, row), 0.9 * error);
    EXPECT_LE(NumberBehind(page, row), bound) << error;
    const std::size_t second = page.find("</td><td>", page.find(row));
    EXPECT_LE(NumberBehind(page.substr(second), "</td><td>"), bound) << error;
    EXPECT_LE(NumberBehind(page, "the farthest at "), bound) << error;
    EXPECT_LE(NumberBehind(page, "<th scope=\"row\">1</th><td>"), bound) << error; // a far
  }
}

TEST_F(Page, SuggestsToLeaveOutSpecksIfThereAreMany)
{
  this->Subject.Specks = { 3.0, 40, 9, 0.0123 };
  EXPECT_FALSE(Contains(this->Compose(), "--prune-size"));
  EXPECT_TRUE(Contains(this->Compose(), "kept; 9 are specks, smaller than 3 mm"));
  this->Subject.Specks.Specks = 10;
  EXPECT_TRUE(Contains(this->Compose(),
    "10 of the 40 components are specks, smaller than 3 mm along every axis: together 1.23 % of "
    "the area. If they are not bone, <code>--prune-size 3</code>"));
}

TEST_F(Page, SaysWhichGridLabelsWereExtractedOn)
{
  this->Subject.ModelGrid = "voxels of <1> mm";
  EXPECT_TRUE(Contains(this->Compose(), "<p>voxels of &lt;1&gt; mm</p>"));
}

TEST_F(Page, TellsHowTheResultCameAbout)
{
  this->Filter->SetTargetNumberOfTriangles(1234);
  const std::string page = this->Compose();
  for (const char* name : { "version", "stop_sentence", "input.checksum", "options.Mode" })
  {
    EXPECT_FALSE(this->Filter->GetReportText(name).empty()) << name;
    EXPECT_TRUE(Contains(page, EscapedXml(this->Filter->GetReportText(name)))) << name;
  }
  EXPECT_TRUE(Contains(page, "TargetNumberOfTriangles: 1234"));
  EXPECT_TRUE(
    Contains(page, "turn over: " + GroupedText(this->Filter->GetReportValue("rejections.flip"))));
  EXPECT_TRUE(Contains(
    page, GroupedText(this->Filter->GetReportValue("seconds.decimate"), 2) + " s to simplify"));
}

TEST_F(Page, SumsUpInPlainWords)
{
  const std::string page = this->Compose();
  const std::string after = GroupedText(this->Filter->GetReportValue("output.triangles"));
  const std::string before = GroupedText(this->Filter->GetReportValue("input.triangles"));
  EXPECT_TRUE(Contains(page, "<strong>" + after + "</strong>triangles, "));
  EXPECT_TRUE(Contains(page, " % of " + before + "</div>"));
  EXPECT_TRUE(Contains(page, "<strong>1 of 1</strong>components (separate pieces) kept</div>"));
}

TEST_F(Page, SaysItIsNotAMedicalDevice)
{
  EXPECT_TRUE(Contains(this->Compose(), "This software is not a medical device."));
}

std::string WithoutScripts(std::string page)
{
  for (std::size_t at = page.find("<script"); at != std::string::npos; at = page.find("<script"))
  {
    page.erase(at, page.find("</script>", at) - at);
  }
  return page;
}

TEST_F(Page, NeedsNothingFromOutside)
{
  const std::string page = this->Compose();
  EXPECT_TRUE(
    Contains(page, "Content-Security-Policy\" content=\"default-src 'none'; img-src data:;"));
  EXPECT_FALSE(Contains(page, "<script src"));
  for (const char* word : { "http:", "https:", "src=", "<link", "@import", "url(" })
  {
    EXPECT_FALSE(Contains(WithoutScripts(page), word)) << word;
  }
}

TEST_F(Page, HasTheInteractiveViewOfBothSurfaces)
{
  const std::string page = this->Compose();
  EXPECT_EQ(Contains(page, "viewer-stage"), HasViewer());
  EXPECT_EQ(Contains(page, "\"caption\":\"Before: "), HasViewer());
  this->Subject.Before = nullptr;
  EXPECT_FALSE(Contains(ComposePage(this->Subject), "viewer-stage"));
}

TEST_F(Page, HasTheSameViewForTheSameSurfaces)
{
  this->Compose();
  ViewerSubject subject;
  subject.Before = { this->Subject.Before, this->Subject.DistanceArrayName, "" };
  subject.Levels = { { this->Subject.Result, "Distance", "" } };
  const ViewerHtml first = ComposeViewer(subject);
  const ViewerHtml second = ComposeViewer(subject);
  EXPECT_EQ(first.Section, second.Section);
  EXPECT_EQ(first.Script, second.Script);
}

TEST_F(Page, ReducesSurfacesThatAreTooLargeAndSaysSo)
{
  if (!HasViewer())
  {
    GTEST_SKIP() << "built without the interactive view";
  }
  this->Compose();
  ViewerSubject subject;
  subject.Before = { this->Subject.Before, this->Subject.DistanceArrayName, "" };
  subject.Levels = { { this->Subject.Result, "Distance", "" } };
  const std::size_t whole = ComposeViewer(subject).Script.size();
  subject.MostBytes = whole - 20000;
  subject.Reduce = [](vtkPolyData* surface, vtkIdType triangles)
  {
    vtkNew<vtkBoneDecimate> reduce;
    reduce->SetInputData(surface);
    reduce->SetTargetNumberOfTriangles(static_cast<int>(triangles));
    reduce->Update();
    return vtkSmartPointer<vtkPolyData>(reduce->GetOutput());
  };
  const ViewerHtml reduced = ComposeViewer(subject);
  EXPECT_LE(reduced.Script.size(), whole - 10000);
  EXPECT_TRUE(Contains(reduced.Section, "the surface before is shown with "));
  EXPECT_TRUE(Contains(reduced.Script, " of 6,960 triangles\""));
}

TEST_F(Page, ListsEveryLevel)
{
  this->Compose();
  LevelsPageSubject subject;
  subject.Name = "<ball>";
  subject.Before = this->Subject.Before;
  subject.Levels = { { this->Subject.Result, 0.25, 0.125 },
    { this->Subject.Before, std::nan(""), std::nan("") } };
  const std::string page = ComposeLevelsPage(subject);
  EXPECT_TRUE(Contains(page, "&lt;ball&gt;"));
  EXPECT_TRUE(Contains(page, "<td>0.2500</td><td>0.1250</td>"));
  EXPECT_TRUE(Contains(page, "<th scope=\"row\">6,960</th><td>not measured</td>"));
}

TEST_F(Page, StatesTheProofOfLevels)
{
  this->Compose();
  LevelsPageSubject subject;
  subject.Before = this->Subject.Before;
  subject.Levels = { { this->Subject.Result, 0.25, 0.125 } };
  EXPECT_TRUE(Contains(ComposeLevelsPage(subject), "the levels come from a log"));
  subject.Report = this->Filter->GetReportAsJson();
  EXPECT_TRUE(Contains(ComposeLevelsPage(subject), "no largest error was requested"));
  this->Filter->SetMaximumError(0.25);
  this->Compose();
  subject.Report = this->Filter->GetReportAsJson();
  const std::string page = ComposeLevelsPage(subject);
  EXPECT_TRUE(Contains(page, "requested: 0.25 mm"));
  ExpectRoundedUp(NumberBehind(page, "certified: no farther than "),
    this->Filter->GetReportValue("proof.upper"), StepOfHeadline, "levels");
}

TEST_F(Page, EscapesNames)
{
  this->Subject.Name = "<b>\"O'Hara\" & sons";
  const std::string page = this->Compose();
  EXPECT_FALSE(Contains(page, "<b>"));
  EXPECT_TRUE(Contains(page, "&lt;b&gt;&quot;O&#39;Hara&quot; &amp; sons"));
}

TEST_F(Page, DrawsTheFractionOfPointsWithinADistance)
{
  EXPECT_TRUE(Contains(this->Compose(), "<svg"));
  this->Subject.Before = nullptr;
  EXPECT_FALSE(Contains(ComposePage(this->Subject), "<svg"));
}

TEST_F(Page, LeavesOutPointsThatNoTriangleUses)
{
  this->Compose();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(this->Subject.Before);
  before->GetPoints()->InsertNextPoint(0.0, 0.0, 80.0);
  before->GetPointData()->GetArray(this->Subject.DistanceArrayName.c_str())->InsertNextTuple1(50.0);
  const std::string page = ComposePage(this->Subject);
  this->Subject.Before = before;
  EXPECT_EQ(ComposePage(this->Subject), page);
}

TEST_F(Page, SaysSoWhereDistancesWereNotMeasured)
{
  this->Filter->SetMeasureDistances(false);
  this->Filter->SetMeasureInputDistances(false);
  const std::string page = WithoutScripts(this->Compose());
  EXPECT_TRUE(Contains(page, "The distances were not measured in this run."));
  EXPECT_FALSE(Contains(page, "RMS"));
  EXPECT_FALSE(Contains(page, "nan"));
}

TEST_F(Page, ComesWithoutAnyReport)
{
  vtkNew<vtkPolyData> bare;
  this->Subject.Result = bare;
  EXPECT_TRUE(Contains(ComposePage(this->Subject), "not known"));
  this->Subject.Result = nullptr;
  EXPECT_TRUE(Contains(ComposePage(this->Subject), "not known"));
}

TEST_F(Page, HoldsThePictureItself)
{
  const std::string file = std::string(TEMPORARY_FOLDER) + "/page-picture.png";
  std::ofstream(file, std::ios::binary) << "Many hands";
  this->Subject.PictureFile = file;
  EXPECT_TRUE(Contains(this->Compose(), "src=\"data:image/png;base64,TWFueSBoYW5kcw==\""));
  std::filesystem::remove(file);
  const std::string page = this->Compose();
  EXPECT_FALSE(Contains(page, "<img"));
  EXPECT_TRUE(Contains(page, "There is no picture"));
}
}
