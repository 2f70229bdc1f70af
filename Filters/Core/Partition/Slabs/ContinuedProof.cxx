// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContinuedProof.h"

#include "Run/Output/ResultProof.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
namespace
{
/// The corners in their order, the least first; zeros have one sign.
using Key = std::array<std::array<double, 3>, 3>;

Key KeyOf(const Surface& surface, const Triangle& corners)
{
  Key key;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& p = surface.Points[corners[i]];
    key[i] = { p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 };
  }
  std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
  return key;
}

/// The triangles of the second surface that the first one does not have, with all its points.
Surface Changed(const Surface& before, const Surface& after)
{
  std::vector<Key> known;
  known.reserve(before.Triangles.size());
  for (const Triangle& corners : before.Triangles)
  {
    known.push_back(KeyOf(before, corners));
  }
  std::sort(known.begin(), known.end());
  Surface changed = { after.Points, {} };
  std::copy_if(after.Triangles.begin(), after.Triangles.end(),
    std::back_inserter(changed.Triangles),
    [&](const Triangle& corners)
    { return !std::binary_search(known.begin(), known.end(), KeyOf(after, corners)); });
  return changed;
}

/// Bounds the distance of every point of the first surface from the second one.
DirectedCertificate Prove(const Surface& from, const Surface& to,
  const CertificateOptions& question, const Monitor& monitor, ProofStatus& status)
{
  if (from.Triangles.empty())
  {
    DirectedCertificate nothing;
    nothing.Distance.Lower = nothing.Distance.Upper = 0.0;
    return nothing;
  }
  const Certificate found = Certify(from, to, question, monitor);
  const ProofStatus proof = found.Status == CertificateStatus::Good ? found.ReferenceToResult.Proof
                                                                    : ProofStatus::Undecided;
  status = WorseOf(status, proof);
  return found.ReferenceToResult;
}
}

ContinuedProof ProveContinued(
  const ContinuedRun& run, const Options& options, bool withBounds, const Monitor& monitor)
{
  CertificateOptions question;
  question.Tolerance = options.MaximumError;
  question.TightBounds = false;
  question.WithBoundaries = false;
  question.NumberOfThreads = options.NumberOfThreads;
  const Monitor silent = [&](double) { return !monitor || monitor(0.0); };
  ContinuedProof proof;
  const auto bounds = [](const DirectedCertificate& there) {
    return ProvedDistance{ there.Distance.Lower, there.Distance.Upper };
  };
  proof.OriginalToResult = bounds(Prove(run.Covered, run.After, question, silent, proof.Status));
  const Surface changed = Changed(run.Before, run.After);
  question.ReferenceTriangleGap =
    withBounds ? ProofOptions(options, nullptr).ResultTriangleGap : 0.0;
  const DirectedCertificate there = Prove(changed, run.Original, question, silent, proof.Status);
  proof.ResultToOriginal = bounds(there);
  proof.Bounds = BoundsAtPoints(changed, there.TriangleUpper);
  return proof;
}
}
