// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// From a number of triangles to the smallest error that can be proved, and the curve.
#include "Proof/Certificate/Certificate.h"
#include "Run/ErrorSearch.h"
#include "Runs.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
ErrorSearchOptions SearchFor(Mode mode, int triangles, double precision = 0.1)
{
  ErrorSearchOptions options;
  options.Run = InMode(mode, Triangles(triangles));
  options.RelativePrecision = precision;
  return options;
}

const ErrorTrial& BestOf(const ErrorSearchResult& found)
{
  return found.Trials.at(static_cast<std::size_t>(found.Best));
}
}

TEST(ErrorSearch, FindsASurfaceOfThatManyTrianglesWithAProvedError)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    const ErrorSearchResult found = FindSmallestError(input, SearchFor(mode, 700));
    ASSERT_GE(found.Best, 0) << WordOf(mode);
    EXPECT_LE(found.Found.Surface.Triangles.size(), 700U) << WordOf(mode);
    EXPECT_EQ(found.Found.Report.Proof.Upper(), BestOf(found).Proved) << WordOf(mode);
    const Certificate certified = Certify(input, found.Found.Surface);
    EXPECT_LE(certified.Lower(), BestOf(found).Proved) << WordOf(mode);
    for (const ErrorTrial& trial : found.Trials)
    {
      EXPECT_TRUE(!trial.IsReached || trial.Proved >= BestOf(found).Proved) << WordOf(mode);
    }
  }
}

TEST(ErrorSearch, EndsAtTheRequestedPrecision)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  const ErrorSearchResult found = FindSmallestError(input, SearchFor(Mode::Fast, 700, 0.03));
  EXPECT_GE(found.MaxFailedError, 0.97 * BestOf(found).Proved);
  Options failed = InMode(Mode::Fast, Triangles(700));
  failed.MaximumError = found.MaxFailedError;
  EXPECT_GT(Decimate(input, failed).Surface.Triangles.size(), 700U);
}

TEST(ErrorSearch, IsNeverWorseThanTheRunToThatManyTriangles)
{
  const Surface input = Icosphere(4, 20.0);
  const ErrorSearchResult found = FindSmallestError(input, SearchFor(Mode::Balanced, 500));
  EXPECT_EQ(found.Trials.front().MaximumError, 0.0);
  EXPECT_LE(BestOf(found).Proved, found.Trials.front().Proved);
}

TEST(ErrorSearch, ReportsWhenTopologyPreventsTheNumber)
{
  const ErrorSearchResult found = FindSmallestError(Icosphere(3, 20.0), SearchFor(Mode::Fast, 2));
  EXPECT_EQ(found.Best, -1);
  ASSERT_EQ(found.Trials.size(), 1U);
  EXPECT_GT(found.Trials[0].Triangles, 2);
}

TEST(ErrorSearch, ErrorOfASmallEnoughSurfaceIsZero)
{
  const ErrorSearchResult found = FindSmallestError(Icosphere(2, 20.0), SearchFor(Mode::Fast, 320));
  ASSERT_EQ(found.Best, 0);
  EXPECT_EQ(BestOf(found).Proved, 0.0);
  EXPECT_EQ(found.Trials.size(), 1U);
}

TEST(ErrorSearch, IsTheSameForAnyNumberOfThreads)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  ErrorSearchOptions options = SearchFor(Mode::Balanced, 300);
  const ErrorSearchResult one = FindSmallestError(input, options);
  options.Run.NumberOfThreads = 4;
  const ErrorSearchResult four = FindSmallestError(input, options);
  EXPECT_TRUE(SameBytes(one.Found.Surface, four.Found.Surface));
  EXPECT_EQ(one.Trials.size(), four.Trials.size());
  EXPECT_EQ(BestOf(one).Proved, BestOf(four).Proved);
}

TEST(ErrorSearch, AnAbortKeepsEarlierResults)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  double last = 0.0;
  const ErrorSearchResult whole = FindSmallestError(input, SearchFor(Mode::Fast, 300),
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    });
  EXPECT_LE(last, 1.0);
  const ErrorSearchResult stopped =
    FindSmallestError(input, SearchFor(Mode::Fast, 300), [](double done) { return done < 0.8; });
  EXPECT_LT(stopped.Trials.size(), whole.Trials.size());
  EXPECT_TRUE(stopped.WasAborted);
  EXPECT_FALSE(whole.WasAborted);
  EXPECT_EQ(stopped.Found.Report.Proof.Upper(), BestOf(stopped).Proved);
}

TEST(ErrorSearch, RejectsTheSameInputsAsDecimation)
{
  const ErrorSearchResult found = FindSmallestError({}, SearchFor(Mode::Fast, 300));
  EXPECT_EQ(found.Best, -1);
  EXPECT_EQ(found.Found.Report.Status, InputStatus::Empty);
}

TEST(ErrorCurve, HasAProvedRunForEachErrorInTheirOrder)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  const std::vector<double> errors = { 0.05, 0.2, 0.8 };
  const ErrorSearchResult found = FindErrorCurve(input, errors, SearchFor(Mode::Fast, 0));
  ASSERT_EQ(found.Trials.size(), errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    const ErrorTrial& trial = found.Trials[i];
    EXPECT_EQ(trial.MaximumError, errors[i]);
    EXPECT_TRUE(trial.IsReached);
    EXPECT_LE(trial.Proved, errors[i]);
    EXPECT_TRUE(i == 0 || trial.Triangles < found.Trials[i - 1].Triangles);
    EXPECT_EQ(static_cast<std::size_t>(trial.Triangles),
      Decimate(input, InMode(Mode::Fast, Error(errors[i]))).Surface.Triangles.size());
  }
}
