// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificateTable.h"

#include "Mesh/Checksum.h"
#include "ProofSentence.h"
#include "ReportEntries.h"
#include "Words.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
void AddDistanceBounds(Entries& entries, const std::string& path, const DistanceBounds& bounds)
{
  entries.push_back({ path + ".lower", "mm", bounds.Lower });
  entries.push_back({ path + ".upper", "mm", bounds.Upper });
  entries.push_back({ path + ".x", "mm", bounds.Position.x() });
  entries.push_back({ path + ".y", "mm", bounds.Position.y() });
  entries.push_back({ path + ".z", "mm", bounds.Position.z() });
  entries.push_back({ path + ".triangle", "", std::int64_t{ bounds.Triangle } });
  entries.push_back({ path + ".nearest_triangle", "", std::int64_t{ bounds.NearestTriangle } });
  entries.push_back({ path + ".cuts", "", bounds.Cuts });
}

void AddMean(Entries& entries, const std::string& path, const MeanDistance& mean)
{
  entries.push_back({ path + ".mean", "mm", mean.Mean });
  entries.push_back({ path + ".mean_error", "mm", mean.MeanError });
  entries.push_back({ path + ".rms", "mm", mean.RootMeanSquare });
  entries.push_back({ path + ".rms_error", "mm", mean.RootMeanSquareError });
  entries.push_back({ path + ".area", "mm2", mean.Area });
  entries.push_back({ path + ".samples", "", mean.Samples });
}

void AddDirection(Entries& entries, const std::string& path, const DirectedCertificate& directed)
{
  entries.push_back({ path + ".status", "", std::string(ProofStatusWord(directed.Proof)) });
  AddDistanceBounds(entries, path, directed.Distance);
  const bool hasExcess = std::isfinite(directed.Excess.Lower) || directed.Excess.Upper < 0.0;
  if (hasExcess)
  {
    AddDistanceBounds(entries, path + ".excess", directed.Excess);
  }
  if (directed.Mean.Samples > 0)
  {
    AddMean(entries, path, directed.Mean);
  }
}

void AddCompared(
  Entries& entries, const std::string& side, const std::optional<ComparedFigures>& figures)
{
  if (figures)
  {
    AddCounts(entries, side, figures->Surface);
    entries.push_back({ side + ".intersecting_pairs", "", figures->IntersectingPairs });
    entries.push_back({ side + ".diagonal", "mm", figures->Diagonal });
    entries.push_back({ side + ".checksum", "", TriangleChecksumText(figures->Checksum) });
  }
}

void AddMissing(Entries& entries, const std::vector<MissingComponent>& missing)
{
  for (std::size_t i = 0; i < missing.size(); ++i)
  {
    const std::string path = "missing." + std::to_string(i);
    entries.push_back({ path + ".triangles", "", missing[i].Triangles });
    entries.push_back({ path + ".diagonal", "mm", missing[i].Diagonal });
    entries.push_back({ path + ".x", "mm", missing[i].Center[0] });
    entries.push_back({ path + ".y", "mm", missing[i].Center[1] });
    entries.push_back({ path + ".z", "mm", missing[i].Center[2] });
  }
}
}

const char* BoundaryPresenceWord(BoundaryPresence presence)
{
  static const char* const words[] = { "neither", "reference_only", "result_only", "both" };
  return WordOf(words, presence);
}

const char* const StoppedSentence = "stopped: bounds proved so far";

std::vector<ReportEntry> CertificateEntries(const Certificate& certificate, const PairFigures& pair)
{
  const bool wasStopped = certificate.Status == CertificateStatus::Aborted;
  const bool isGood = certificate.Status == CertificateStatus::Good || wasStopped;
  Entries entries;
  entries.push_back({ "version", "", std::string(Version()) });
  entries.push_back(
    { "problem", "", std::string(isGood ? "" : StatusSentence(certificate.Status)) });
  entries.push_back({ "status", "", std::string(ProofStatusWord(certificate.Proof)) });
  if (!isGood)
  {
    return entries;
  }
  if (wasStopped)
  {
    entries.push_back({ "stopped", "", std::string(StoppedSentence) });
  }
  const std::string boundaries =
    certificate.BoundariesCompared ? BoundaryPresenceWord(certificate.Boundaries) : "not_compared";
  const double boundaryUpper = std::max(certificate.BoundaryOfReferenceToResult.Distance.Upper,
    certificate.BoundaryOfResultToReference.Distance.Upper);
  entries.push_back({ "lower", "mm", certificate.Lower() });
  entries.push_back({ "upper", "mm", certificate.Upper() });
  entries.push_back({ "sentence", "",
    ProofSentence({ certificate.Upper(), false, boundaries, pair.LeftOut, boundaryUpper }) });
  entries.push_back({ "slack", "mm", certificate.Slack });
  entries.push_back({ "boundaries", "", boundaries });
  entries.push_back({ "seconds", "s", certificate.Seconds });
  AddCompared(entries, "reference", pair.Reference);
  AddCompared(entries, "result", pair.Result);
  AddMissing(entries, pair.Missing);
  AddLeftOut(entries, "left_out", pair.LeftOut);
  AddDirection(entries, "reference_to_result", certificate.ReferenceToResult);
  AddDirection(entries, "result_to_reference", certificate.ResultToReference);
  if (certificate.Boundaries != BoundaryPresence::Neither)
  {
    AddDirection(entries, "boundary_reference_to_result", certificate.BoundaryOfReferenceToResult);
    AddDirection(entries, "boundary_result_to_reference", certificate.BoundaryOfResultToReference);
  }
  return entries;
}
}
