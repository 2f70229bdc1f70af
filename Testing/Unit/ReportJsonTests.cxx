// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Proof/Certificate/Certificate.h"
#include "Run/Report/CertificateTable.h"
#include "Run/Report/ReportFigures.h"
#include "Run/Report/ReportJson.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace bonedecimate;

TEST(ReportJson, NestsEntriesAtTheDotsOfTheirNames)
{
  const std::vector<ReportEntry> entries = { { "version", "", std::string("1.2.3") },
    { "input.triangles", "", std::int64_t{ 12 } }, { "input.area", "mm2", 2.5 },
    { "list.0.size", "mm", 1.0 }, { "list.1.size", "mm", 0.1 } };
  EXPECT_EQ(ReportJson(entries),
    R"({"version": "1.2.3", "input": {"triangles": 12, "area": 2.5}, )"
    R"("list": [{"size": 1.0}, {"size": 0.1}], )"
    R"("units": {"input.area": "mm2", "list.0.size": "mm", "list.1.size": "mm"}})");
}

TEST(ReportJson, NumbersThatAreNotFiniteAreNull)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ReportJson({ { "a", "", std::nan("") }, { "b", "", -infinity }, { "c", "", 1e30 } }),
    R"({"a": null, "b": null, "c": 1e+30, "units": {}})");
}

TEST(ReportJson, TextsAreEscapedAndUtf8)
{
  EXPECT_EQ(ReportJson({ { "a", "", std::string("\"\\\n\t") } }),
    "{\"a\": \"\\\"\\\\\\u000a\\u0009\", \"units\": {}}");
  EXPECT_EQ(ReportJson({ { "a", "", std::string("\xc3\xa9 \xe2\x82\xac \xf0\x9f\xa6\xb4") } }),
    "{\"a\": \"\xc3\xa9 \xe2\x82\xac \xf0\x9f\xa6\xb4\", \"units\": {}}");
  for (const char* wrong : { "\xff", "\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80" })
  {
    const std::string text = ReportJson({ { "a", "", std::string(wrong) } });
    EXPECT_EQ(text.find("{\"a\": \"\\ufffd"), 0U) << text;
    EXPECT_TRUE(std::all_of(
      text.begin(), text.end(), [](char c) { return static_cast<signed char>(c) > 0; }));
  }
}

TEST(ReportFigures, AreNotANumberWithoutProofAndDistances)
{
  Report report;
  EXPECT_TRUE(std::isnan(ProvedError(report)));
  EXPECT_TRUE(std::isnan(MeasuredError(report)));
  report.Proof.WasMade = true;
  report.Proof.InputToOutput.Upper = 0.5;
  report.DistancesMeasured = true;
  report.OutputToInput.Maximum = 0.25;
  EXPECT_EQ(ProvedError(report), 0.5);
  EXPECT_EQ(MeasuredError(report), 0.25);
  report.Edits.Rejections[static_cast<std::size_t>(Rejection::Flip)] = 3;
  report.Edits.Rejections[static_cast<std::size_t>(Rejection::ErrorBound)] = 4;
  EXPECT_EQ(RejectedEdits(report), 7);
  EXPECT_EQ(RejectedEdits(report, "flip"), 3);
  EXPECT_EQ(RejectedEdits(report, "no such reason"), 0);
}

TEST(Words, OfValuesWithoutAWordDoNotReadBeyondTheList)
{
  EXPECT_STREQ(StopReasonWord(static_cast<StopReason>(99)), "unknown");
  EXPECT_STREQ(StopReasonSentence(static_cast<StopReason>(-1)), "unknown");
  EXPECT_STREQ(RejectionWord(static_cast<Rejection>(99)), "unknown");
  EXPECT_STREQ(BoundaryPresenceWord(static_cast<BoundaryPresence>(99)), "unknown");
  EXPECT_STREQ(ProofStatusWord(static_cast<ProofStatus>(99)), "undecided");
}
