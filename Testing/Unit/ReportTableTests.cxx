// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTable.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Report/ReportTable.h"

#include <gtest/gtest.h>

#include <set>

using namespace bonedecimate;

namespace
{
const ReportEntry* Find(const std::vector<ReportEntry>& entries, const std::string& name)
{
  for (const ReportEntry& entry : entries)
  {
    if (entry.Name == name)
    {
      return &entry;
    }
  }
  return nullptr;
}

template <typename Type>
Type Read(const Report& report, const std::string& name)
{
  const std::vector<ReportEntry> entries = ReportEntries(report);
  const ReportEntry* entry = Find(entries, name);
  EXPECT_NE(entry, nullptr) << name;
  return entry != nullptr ? std::get<Type>(entry->Value) : Type{};
}

Report MeasuredReport()
{
  Report report;
  report.DistancesMeasured = true;
  report.Stop = StopReason::TargetReached;
  report.Input.Faces = 101;
  report.Output.Faces = 10;
  report.Output.Volume = -2.5;
  report.OutputToInput.Maximum = 0.5;
  report.OutputToInput.Second = 0.25;
  report.InputToOutput.Mean = 0.125;
  report.BoundariesMeasured = true;
  report.BoundaryInputToOutput = { 0.375, 0.4375 };
  report.Edits.Rejections[static_cast<std::size_t>(Rejection::Flip)] = 17;
  report.InputChecksum = 0xABCULL;
  return report;
}
}

TEST(ReportTable, ValuesHaveTheirNames)
{
  const Report report = MeasuredReport();
  EXPECT_EQ(Read<std::int64_t>(report, "input.triangles"), 101);
  EXPECT_EQ(Read<std::int64_t>(report, "output.triangles"), 10);
  EXPECT_EQ(Read<double>(report, "output.volume"), -2.5);
  EXPECT_EQ(Read<double>(report, "distance.output_to_input.max"), 0.5);
  EXPECT_EQ(Read<double>(report, "distance.output_to_input.second"), 0.25);
  EXPECT_EQ(Read<double>(report, "distance.input_to_output.mean"), 0.125);
  EXPECT_EQ(Read<double>(report, "distance.boundary_input_to_output.lower"), 0.375);
  EXPECT_EQ(Read<double>(report, "distance.boundary_input_to_output.upper"), 0.4375);
  EXPECT_EQ(Read<std::int64_t>(report, "rejections.flip"), 17);
  EXPECT_EQ(Read<std::string>(report, "stop_reason"), "target_reached");
  EXPECT_EQ(Read<std::string>(report, "input.checksum"), "fnv1a64:0000000000000abc");
  EXPECT_EQ(Read<std::string>(report, "version"), Version());
}

TEST(ReportTable, NamesAreUniqueAndWithoutSpaces)
{
  std::set<std::string> names;
  for (const ReportEntry& entry : ReportEntries(MeasuredReport()))
  {
    EXPECT_TRUE(names.insert(entry.Name).second) << entry.Name;
    EXPECT_EQ(entry.Name.find(' '), std::string::npos) << entry.Name;
  }
}

TEST(ReportTable, DistancesAreLeftOutWhenNoneWereMeasuredAndNothingElseIs)
{
  Report report = MeasuredReport();
  const std::size_t all = ReportEntries(report).size();
  report.BoundariesMeasured = false;
  EXPECT_EQ(ReportEntries(report).size(), all - 4);
  report.DistancesMeasured = false;
  const std::vector<ReportEntry> entries = ReportEntries(report);
  EXPECT_EQ(entries.size(), all - 28);
  for (const ReportEntry& entry : entries)
  {
    EXPECT_NE(entry.Name.rfind("distance.", 0), 0U) << entry.Name;
  }
}

TEST(ReportTable, ProofIsThereOnlyWhereOneWasMadeAndHasTheLargestOfAllDirections)
{
  Report report = MeasuredReport();
  const std::size_t without = ReportEntries(report).size();
  report.Proof.WasMade = true;
  report.Proof.Status = ProofStatus::Proved;
  report.Proof.Tolerance = 0.5;
  report.Proof.InputToOutput = { 0.25, 0.375 };
  report.Proof.OutputToInput = { 0.125, 0.1875 };
  EXPECT_EQ(Read<std::string>(report, "proof.boundaries"), "not_compared");
  EXPECT_EQ(ReportEntries(report).size(), without + 10);
  report.Proof.BoundariesCompared = true;
  report.Proof.Boundaries = BoundaryPresence::Both;
  report.Proof.BoundaryOutputToInput = { 0.4375, 0.46875 };
  EXPECT_EQ(ReportEntries(report).size(), without + 14);
  EXPECT_EQ(Read<std::string>(report, "proof.status"), "proved");
  EXPECT_EQ(Read<double>(report, "proof.lower"), 0.4375);
  EXPECT_EQ(Read<double>(report, "proof.upper"), 0.46875);
  EXPECT_EQ(Read<double>(report, "proof.tolerance"), 0.5);
  EXPECT_EQ(Read<double>(report, "proof.input_to_output.upper"), 0.375);
  EXPECT_EQ(Read<double>(report, "proof.boundary_output_to_input.lower"), 0.4375);
}

TEST(ReportTable, FragmentGapIsLeftOutWithOneFragment)
{
  Report report = MeasuredReport();
  EXPECT_EQ(Find(ReportEntries(report), "fragment_gap.input"), nullptr);
  report.FragmentGapMeasured = true;
  report.Gap = { 0.75, 0.5 };
  EXPECT_EQ(Read<double>(report, "fragment_gap.input"), 0.75);
  EXPECT_EQ(Read<double>(report, "fragment_gap.output"), 0.5);
}

TEST(ReportTable, LengthsAreInMillimetersAndTimesInSeconds)
{
  for (const ReportEntry& entry : ReportEntries(MeasuredReport()))
  {
    if (std::holds_alternative<double>(entry.Value))
    {
      EXPECT_FALSE(entry.Unit.empty()) << entry.Name;
    }
    EXPECT_EQ(entry.Unit == "s", entry.Name.rfind("seconds.", 0) == 0) << entry.Name;
  }
}

TEST(ReportTable, EveryRejectionReasonAndEveryOptionHasAnEntry)
{
  const std::vector<ReportEntry> entries = ReportEntries(MeasuredReport());
  for (std::size_t i = 1; i < NumberOfRejections; ++i)
  {
    EXPECT_NE(Find(entries, std::string("rejections.") + RejectionWord(static_cast<Rejection>(i))),
      nullptr);
  }
  for (const OptionInfo& info : OptionTable())
  {
    EXPECT_NE(Find(entries, "options." + info.Name), nullptr) << info.Name;
  }
}

TEST(ReportTable, OptionsAreThoseOfTheRun)
{
  Report report = MeasuredReport();
  report.Requested.TargetReduction = 0.75;
  EXPECT_EQ(Read<std::string>(report, "options.TargetReduction"), "0.75");
}

TEST(Report, EveryReasonHasAWordAndASentenceOfItsOwn)
{
  std::set<std::string> words;
  std::set<std::string> sentences;
  for (int i = 0; i <= static_cast<int>(StopReason::Aborted); ++i)
  {
    words.insert(StopReasonWord(static_cast<StopReason>(i)));
    sentences.insert(StopReasonSentence(static_cast<StopReason>(i)));
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(StopReason::Aborted) + 1);
  EXPECT_EQ(sentences.size(), words.size());
}

TEST(Report, MessagesAboutInputsHaveCountAndFirst)
{
  Report report;
  EXPECT_EQ(InputMessage(report), "");
  report.Status = InputStatus::NonFinitePoints;
  report.Cleaning.NonFinitePoints = 12;
  report.Cleaning.FirstNonFinitePoint = 345;
  EXPECT_NE(InputMessage(report).find("12 "), std::string::npos);
  EXPECT_NE(InputMessage(report).find("345"), std::string::npos);
  report.Status = InputStatus::IndexOutOfRange;
  report.Cleaning.TrianglesOutOfRange = 6;
  report.Cleaning.FirstTriangleOutOfRange = 78;
  EXPECT_NE(InputMessage(report).find("6 "), std::string::npos);
  EXPECT_NE(InputMessage(report).find("78"), std::string::npos);
  for (int i = 1; i <= static_cast<int>(InputStatus::TooManyTriangles); ++i)
  {
    report.Status = static_cast<InputStatus>(i);
    EXPECT_NE(InputMessage(report), "") << i;
  }
}

TEST(ReportWarnings, TellOfASpikeUnlessALargestErrorWasSet)
{
  Report report;
  report.DistancesMeasured = true;
  report.Size.Diagonal = 100.0;
  report.OutputToInput.Maximum = 5.1;
  report.OutputToInput.RootMeanSquare = 0.5;
  ASSERT_EQ(InputWarnings(report).size(), 1U);
  EXPECT_NE(InputWarnings(report)[0].find("5.1 mm"), std::string::npos);
  Report bounded = report;
  bounded.Requested.MaximumError = 6.0;
  EXPECT_TRUE(InputWarnings(bounded).empty());
  Report coarse = report;
  coarse.OutputToInput.RootMeanSquare = 0.52;
  EXPECT_TRUE(InputWarnings(coarse).empty());
  report.OutputToInput.Maximum = 4.9;
  report.OutputToInput.RootMeanSquare = 0.1;
  EXPECT_TRUE(InputWarnings(report).empty());
}
