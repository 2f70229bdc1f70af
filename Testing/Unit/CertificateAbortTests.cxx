// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePairs.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Tiny = 1e-7; // mm, more than the least gap of these small shapes

CertificateOptions OneThread()
{
  CertificateOptions options;
  options.NumberOfThreads = 1; // so that the number of calls is known
  return options;
}

/// The calls of a monitor that never aborts.
int CountCalls(const NamedPair& pair, const CertificateOptions& options)
{
  int calls = 0;
  double last = 0.0;
  const Certificate whole = Certify(pair.Reference, pair.Result, options,
    [&](double done)
    {
      EXPECT_GE(done, last);
      EXPECT_LE(done, 1.0);
      last = done;
      ++calls;
      return true;
    });
  EXPECT_EQ(whole.Status, CertificateStatus::Good);
  EXPECT_EQ(last, 1.0);
  return calls;
}

/// The certificate if the monitor aborts in this call, the first one being 0.
Certificate StoppedAt(int call, const NamedPair& pair, const CertificateOptions& options)
{
  int at = 0;
  const Certificate found =
    Certify(pair.Reference, pair.Result, options, [&](double) { return at++ < call; });
  EXPECT_EQ(found.Status, CertificateStatus::Aborted);
  return found;
}

std::vector<NamedPair> Pairs()
{
  std::vector<NamedPair> pairs = SmallPairs();
  pairs.push_back({ "spheres", BumpySphere(4, 10.0, 0.05, 3), Icosphere(3, 10.0) });
  return pairs;
}

/// The bounds overlap with those of the whole search, and the position is as far as they say.
void ExpectToHold(const DistanceBounds& stopped, const DistanceBounds& whole, const Surface& to)
{
  EXPECT_LE(stopped.Lower, whole.Upper);
  EXPECT_GE(stopped.Upper, whole.Lower);
  EXPECT_GE(stopped.Lower, 0.0);
  EXPECT_LT(stopped.Upper, Infinity);
  ASSERT_NE(stopped.Triangle, None);
  EXPECT_GE(BruteNearest(to, stopped.Position).Distance, stopped.Lower);
}

struct Interval
{
  double Lower = 0.0;
  double Upper = Infinity;

  void ExpectWithin(const Interval& before) const
  {
    EXPECT_GE(this->Lower, before.Lower * (1.0 - 1e-6) - Tiny);
    EXPECT_LE(this->Upper, before.Upper * (1.0 + 1e-6) + Tiny);
  }
};
}

TEST(CertificateAbort, LeavesBoundsThatHoldAtAnyMoment)
{
  for (const NamedPair& pair : Pairs())
  {
    SCOPED_TRACE(pair.Name);
    const Certificate whole = Certify(pair.Reference, pair.Result);
    const int calls = CountCalls(pair, OneThread());
    for (int call = 0; call < calls; call += 1 + calls / 37)
    {
      const Certificate stopped = StoppedAt(call, pair, OneThread());
      ExpectToHold(
        stopped.ReferenceToResult.Distance, whole.ReferenceToResult.Distance, pair.Result);
      ExpectToHold(
        stopped.ResultToReference.Distance, whole.ResultToReference.Distance, pair.Reference);
      EXPECT_EQ(stopped.Boundaries, whole.Boundaries);
    }
  }
}

TEST(CertificateAbort, LaterLeavesTighterBounds)
{
  for (const NamedPair& pair : Pairs())
  {
    SCOPED_TRACE(pair.Name);
    const Certificate whole = Certify(pair.Reference, pair.Result);
    const int calls = CountCalls(pair, OneThread());
    Interval before;
    for (int call = 0; call < calls; call += 1 + calls / 37)
    {
      const Certificate stopped = StoppedAt(call, pair, OneThread());
      const Interval now = { stopped.Lower(), stopped.Upper() };
      now.ExpectWithin(before);
      before = now;
    }
    const Certificate last = StoppedAt(calls - 1, pair, OneThread());
    EXPECT_NEAR(last.Lower(), whole.Lower(), 1e-6 * whole.Upper() + Tiny);
    EXPECT_NEAR(last.Upper(), whole.Upper(), 1e-6 * whole.Upper() + Tiny);
  }
}

TEST(CertificateAbort, OfSeveralThreadsLeavesBoundsThatHold)
{
  const NamedPair pair = Pairs().back();
  const Certificate whole = Certify(pair.Reference, pair.Result);
  CertificateOptions options;
  options.NumberOfThreads = 3;
  for (int call = 0; call < 60; ++call)
  {
    int at = 0;
    const Certificate stopped =
      Certify(pair.Reference, pair.Result, options, [&](double) { return at++ < 10 * call; });
    EXPECT_LE(stopped.Lower(), whole.Upper());
    EXPECT_GE(stopped.Upper(), whole.Lower());
  }
}

TEST(CertificateAbort, ProvesWhatTheBoundsUntilThenProve)
{
  const NamedPair pair = Pairs().back();
  const double distance = Certify(pair.Reference, pair.Result).Upper();
  for (const double tolerance : { 100.0, 1.5 * distance, 0.5 * distance })
  {
    CertificateOptions options = OneThread();
    options.Tolerance = tolerance;
    const int calls = CountCalls(pair, options);
    for (int call = 0; call < calls; call += 1 + calls / 41)
    {
      const Certificate stopped = StoppedAt(call, pair, options);
      const ProofStatus expected = stopped.Upper() <= tolerance ? ProofStatus::Proved
        : stopped.Lower() > tolerance                           ? ProofStatus::Violated
                                                                : ProofStatus::Undecided;
      EXPECT_EQ(stopped.Proof, expected);
      EXPECT_TRUE(tolerance < 100.0 || stopped.Proof == ProofStatus::Proved);
    }
  }
}

TEST(CertificateAbort, ProvesNoToleranceOfPointsAgainstTheWholeSearch)
{
  const NamedPair pair = Pairs().back();
  const double distance = Certify(pair.Reference, pair.Result).Upper();
  CertificateOptions options = OneThread();
  options.Tolerance = 2.0 * distance; // the map is stricter
  options.ToleranceMap.assign(pair.Reference.Points.size(), 0.5 * distance);
  const int calls = CountCalls(pair, options);
  for (int call = 0; call < calls; call += 1 + calls / 41)
  {
    const ProofStatus found = StoppedAt(call, pair, options).Proof;
    EXPECT_TRUE(found == ProofStatus::Undecided || found == ProofStatus::Violated);
  }
}

TEST(CertificateAbort, EndsALongSearchOfASingleTriangle)
{
  Surface grid = Scaled(Grid(28), 1.0 / 28.0);
  for (Vector3& p : grid.Points)
  {
    p = p.unaryExpr([](double x) { return static_cast<double>(static_cast<float>(x)); });
  }
  // Most of the calls, one every 1,024 cuts, are made while a triangle is cut.
  const NamedPair pair = { "flat", grid, Grid(1) };
  const Certificate early = StoppedAt(1000, pair, OneThread());
  const Certificate late = StoppedAt(6000, pair, OneThread());
  EXPECT_LT(late.Upper(), 0.5 * early.Upper());
}

TEST(CertificateBounds, AreToldFromTheBeginningAndGetTighter)
{
  for (const NamedPair& pair : Pairs())
  {
    SCOPED_TRACE(pair.Name);
    const Certificate whole = Certify(pair.Reference, pair.Result);
    for (const int threads : { 1, 3 })
    {
      CertificateOptions options;
      options.NumberOfThreads = threads;
      std::vector<Interval> told;
      options.OnBounds = [&](double lower, double upper) { told.push_back({ lower, upper }); };
      const auto hasTold = [&](double) { return !told.empty(); };
      const Certificate found = Certify(pair.Reference, pair.Result, options, hasTold);
      EXPECT_EQ(found.Status, CertificateStatus::Good);
      EXPECT_EQ(found.Lower(), whole.Lower());
      EXPECT_EQ(found.Upper(), whole.Upper());
      for (std::size_t i = 0; i < told.size(); ++i)
      {
        const Interval before = i == 0 ? Interval() : told[i - 1];
        EXPECT_LE(told[i].Lower, whole.Upper());
        EXPECT_GE(told[i].Upper, whole.Lower());
        EXPECT_GE(told[i].Lower, before.Lower);
        EXPECT_LE(told[i].Upper, before.Upper);
        EXPECT_GT(told[i].Lower - before.Lower + before.Upper - told[i].Upper, 0.0);
      }
      EXPECT_NEAR(told.back().Upper, whole.Upper(), 1e-6 * whole.Upper() + Tiny);
      EXPECT_NEAR(told.back().Lower, whole.Lower(), 1e-6 * whole.Upper() + Tiny);
    }
  }
}
