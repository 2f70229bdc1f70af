// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace
{
using namespace bonedecimate;

TEST(Text, LowersAsciiLettersOnly)
{
  EXPECT_EQ(LowerCase("Bone-7.STL"), "bone-7.stl");
  EXPECT_EQ(LowerCase("\xc3\x84"), "\xc3\x84");
}

TEST(Text, EscapesWhatXmlReserves)
{
  EXPECT_EQ(EscapedXml("<a b=\"c\">'d' & e"), "&lt;a b=&quot;c&quot;&gt;&#39;d&#39; &amp; e");
}

TEST(Text, SplitsIntoAllParts)
{
  EXPECT_EQ(SplitAt("1,,2,", ','), (std::vector<std::string>{ "1", "", "2", "" }));
  EXPECT_EQ(SplitAt("", ','), std::vector<std::string>{ "" });
}

TEST(Text, ReadsWholeTextsAsNumbers)
{
  EXPECT_EQ(ParseNumber<double>("+2.5e-1"), 0.25);
  EXPECT_EQ(ParseNumber<double>("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ParseNumber<std::int64_t>("-12"), -12);
  for (const char* text : { "", " 5", "5 ", "5mm", "0x10", "1,5", "+-5", "++5", "five" })
  {
    EXPECT_EQ(ParseNumber<double>(text), std::nullopt) << text;
    EXPECT_EQ(ParseNumber<std::int64_t>(text), std::nullopt) << text;
  }
  EXPECT_EQ(ParseNumber<std::int64_t>("99999999999999999999"), std::nullopt);
}

TEST(Text, FiniteNumbersAreNeitherInfiniteNorRoundedToZero)
{
  EXPECT_EQ(ParseFinite("0.0e5"), 0.0);
  EXPECT_EQ(ParseFinite("5e-324"), 5e-324);
  for (const char* text : { "nan", "-inf", "1e400", "1e-400" })
  {
    EXPECT_EQ(ParseFinite(text), std::nullopt) << text;
  }
}
}
