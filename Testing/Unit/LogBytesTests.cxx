// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The log as bytes: round trip, damaged and forged.
#include "ForgedLog.h"
#include "LevelRuns.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Bytes = std::vector<unsigned char>;

LogStatus Read(const Bytes& bytes, EditLog& log)
{
  return ReadLog(bytes.data(), bytes.size(), log);
}

LogStatus StatusOf(const Bytes& bytes)
{
  EditLog log;
  return Read(bytes, log);
}

Recorded Example(Mode mode = Mode::Balanced)
{
  return Record(HeightField(12, 0.3, 7), InMode(mode, Triangles(60)));
}

bool IsWithin(const Surface& surface)
{
  return std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
    [&](const Triangle& c)
    {
      return std::all_of(c.begin(), c.end(),
        [&](Index v) { return v >= 0 && v < static_cast<Index>(surface.Points.size()); });
    });
}

EditLog WithoutMarks(EditLog log)
{
  log.Marks.clear();
  return log;
}

/// Rejected, or good for levels whose triangles have points.
void ExpectHarmless(const Bytes& bytes, const Surface& surface)
{
  EditLog log;
  Levels levels;
  if (Read(bytes, log) == LogStatus::Good &&
    levels.Open(surface, std::move(log), 1) == LogStatus::Good)
  {
    for (Index level = 0; level <= levels.NumberOfCollapses(); level += 7)
    {
      EXPECT_TRUE(IsWithin(levels.At(level).Surface));
    }
  }
}

constexpr std::size_t AtVersion = 8;
constexpr std::size_t AtCounts = 24; // vertices, faces, collapses, patches, marks
}

TEST(LogBytes, WhatIsReadIsWhatWasWritten)
{
  for (const Mode mode : AllModes())
  {
    for (const bool isSingle : { false, true })
    {
      const Surface bone = HeightField(12, 0.3, 7);
      const Recorded recorded = Record(bone, InMode(mode, Triangles(60)), isSingle);
      const Bytes bytes = WriteLog(recorded.Levels.Log());
      EditLog log;
      ASSERT_EQ(Read(bytes, log), LogStatus::Good);
      EXPECT_EQ(WriteLog(log), bytes);
      Levels levels;
      ASSERT_EQ(levels.Open(bone, log, 1), LogStatus::Good);
      for (const Index level : { 0, 20, levels.NumberOfCollapses() })
      {
        EXPECT_TRUE(SameBytes(levels.At(level).Surface, recorded.Levels.At(level).Surface));
      }
    }
  }
}

TEST(LogBytes, OfACollapseThereAre24BytesInSinglePrecision)
{
  const Surface bone = SmallBone();
  const Recorded recorded = Record(bone, InMode(Mode::Fast, Triangles(100)), true);
  const EditLog& log = recorded.Levels.Log();
  EXPECT_EQ(WriteLog(log).size(), 44 + 24 * log.Collapses.size() + 24 * log.Marks.size() + 8);
}

TEST(LogBytes, RejectsTruncatedFiles)
{
  const Bytes bytes = WriteLog(Example().Levels.Log());
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    const LogStatus status =
      StatusOf(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
    EXPECT_EQ(status, size < 8 ? LogStatus::NotALog : LogStatus::Damaged) << size;
  }
}

TEST(LogBytes, EveryChangedByteIsFound)
{
  Bytes bytes = WriteLog(Example().Levels.Log());
  for (unsigned char& byte : bytes)
  {
    byte ^= 0x20U;
    EXPECT_NE(StatusOf(bytes), LogStatus::Good);
    byte ^= 0x20U;
  }
  bytes.push_back(0);
  EXPECT_EQ(StatusOf(bytes), LogStatus::Damaged) << "longer than it was";
}

TEST(LogBytes, AnotherVersionIsNamed)
{
  Bytes bytes = WriteLog(Example().Levels.Log());
  PutIndex(bytes, AtVersion, 1);
  EXPECT_EQ(StatusOf(Forged(bytes)), LogStatus::UnknownVersion);
  const std::string text = "ply\nformat binary_little_endian 1.0\n";
  EXPECT_EQ(StatusOf(Bytes(text.begin(), text.end())), LogStatus::NotALog);
}

TEST(LogBytes, CountsBeyondTheFileTakeNoMemory)
{
  const Bytes bytes = WriteLog(Example().Levels.Log());
  for (std::size_t count = 2; count < 5; ++count)
  {
    for (const std::uint32_t value : { 0x7fffffffU, 0xffffffffU, 0x10000000U })
    {
      Bytes forged = bytes;
      PutIndex(forged, AtCounts + 4 * count, value);
      EXPECT_EQ(StatusOf(Forged(forged)), LogStatus::Contradictory);
    }
  }
}

TEST(LogBytes, ForgedNumbersAreRejectedOrHarmless)
{
  const Surface bone = HeightField(12, 0.3, 7);
  const Bytes bytes = WriteLog(Example().Levels.Log());
  ASSERT_EQ(StatusOf(Forged(bytes)), LogStatus::Good) << "the forger knows the checksum";
  Random random(3);
  const std::uint32_t values[] = { 0, 1, 0x7fffffffU, 0xffffffffU, 0x80000000U, 0x7ff80000U };
  for (int i = 0; i < 2000; ++i)
  {
    Bytes forged = bytes;
    for (Index changes = random.Below(3); changes >= 0; --changes)
    {
      const auto at = static_cast<std::size_t>(
        AtVersion + 4 * random.Below(static_cast<Index>((bytes.size() - 8 - AtVersion) / 4)));
      const std::uint32_t value = random.Below(2) == 0
        ? values[random.Below(6)]
        : static_cast<std::uint32_t>(random.Below(300));
      PutIndex(forged, at, value);
    }
    ExpectHarmless(Forged(forged), bone);
  }
}

TEST(LogBytes, RejectsACollapseWhoseOtherFaceLiesAcrossAnotherEdge)
{
  const Surface bone = HeightField(12, 0.3, 7);
  EditLog log = WithoutMarks(Example(Mode::Fast).Levels.Log());
  const auto inside = std::find_if(log.Collapses.begin(), log.Collapses.end(),
    [](const LoggedCollapse& collapse) { return collapse.OtherFace != None; });
  ASSERT_NE(inside, log.Collapses.end());
  const Index right = inside->OtherFace;
  for (Index face = 0; face < log.Faces; ++face)
  {
    inside->OtherFace = face;
    const bool isGood = Levels().Open(bone, log, 1) == LogStatus::Good;
    EXPECT_EQ(isGood, face == right) << face;
  }
}

TEST(LogBytes, RejectsAnotherSurface)
{
  const EditLog log = Example().Levels.Log();
  Levels levels;
  Surface other = HeightField(12, 0.3, 8);
  EXPECT_EQ(levels.Open(other, log, 1), LogStatus::OtherSurface);
  EXPECT_EQ(levels.Open(Surface(), log, 1), LogStatus::OtherSurface);
  EXPECT_FALSE(levels.IsOpen());
}

TEST(LogBytes, RejectsEditsThatNoRunCanHaveMade)
{
  const Surface bone = HeightField(12, 0.3, 7);
  const auto statusWith = [&](const auto& change)
  {
    EditLog log = Example(Mode::Fast).Levels.Log();
    change(log);
    return Levels().Open(bone, std::move(log), 1);
  };
  EXPECT_EQ(statusWith([](EditLog&) {}), LogStatus::Good);
  EXPECT_EQ(
    statusWith([](EditLog& log) { log.Collapses[1] = log.Collapses[0]; }), LogStatus::Contradictory)
    << "a face that is gone";
  EXPECT_EQ(statusWith([](EditLog& log) { log.Collapses[3].KeptVertex = log.Vertices; }),
    LogStatus::Contradictory);
  EXPECT_EQ(
    statusWith([](EditLog& log) { log.Collapses[3].HalfEdge |= 3; }), LogStatus::Contradictory)
    << "a triangle has three corners";
  EXPECT_EQ(statusWith([](EditLog& log) { log.Collapses[3].Position[1] = 1e200; }),
    LogStatus::Contradictory);
  EXPECT_EQ(statusWith([](EditLog& log) { log.Collapses[3].Position[1] = std::nan(""); }),
    LogStatus::Contradictory);
  EXPECT_EQ(
    statusWith([](EditLog& log) { log.Marks.back().Triangles -= 1; }), LogStatus::Contradictory);
  EXPECT_EQ(statusWith(
              [](EditLog& log) {
                log.Patches.push_back({ 99999, {}, {} });
              }),
    LogStatus::Contradictory);
}

TEST(LogBytes, EveryRejectionHasASentence)
{
  EXPECT_TRUE(LogMessage(LogStatus::Good).empty());
  for (const LogStatus status : { LogStatus::NotALog, LogStatus::UnknownVersion, LogStatus::Damaged,
         LogStatus::Contradictory, LogStatus::OtherSurface })
  {
    EXPECT_FALSE(LogMessage(status).empty());
  }
}
