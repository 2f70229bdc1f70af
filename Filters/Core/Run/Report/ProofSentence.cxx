// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProofSentence.h"

#include "CertificateTable.h"
#include "Figures/BoundText.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr int DecimalsOfBound = 6;
const std::string Proof = "proof.";
const std::string Sentence = "proof.sentence";

std::string BoundariesClause(const ProofFacts& facts)
{
  if (facts.Boundaries == "both" && facts.BoundaryUpper <= facts.Upper)
  {
    return ", open boundaries too";
  }
  if (facts.Boundaries == "both" && std::isfinite(facts.BoundaryUpper))
  {
    return ", open boundaries at most " + UpperBoundText(facts.BoundaryUpper, DecimalsOfBound) +
      " mm";
  }
  return facts.Boundaries == "both" || facts.Boundaries == "not_compared"
    ? ", but for open boundaries"
    : facts.Boundaries == "reference_only" ? ", but only the reference has open boundaries"
    : facts.Boundaries == "result_only"    ? ", but only the result has open boundaries"
                                           : "";
}
}

std::string ProofSentence(const ProofFacts& facts)
{
  const std::string clause = LeftOutClause(facts.LeftOut, facts.Upper);
  return "at most " + UpperBoundText(facts.Upper, DecimalsOfBound) + " mm in both directions" +
    (facts.IsToReference ? " to the reference" : "") + BoundariesClause(facts) +
    (clause.empty() ? "" : ", " + clause);
}

std::string ProofSentence(const Report& report)
{
  return ProofSentence({ report.Proof.Upper(), report.Reference.IsPresent,
    BoundariesWord(report.Proof), report.LeftOut, 0.0 });
}

std::string BoundariesWord(const ErrorProof& proof)
{
  return proof.BoundariesCompared ? BoundaryPresenceWord(proof.Boundaries) : "not_compared";
}

std::string NameBoundToSurface(const std::string& name)
{
  const bool isProved = name.compare(0, Proof.size(), Proof) == 0 && name != Sentence;
  return isProved ? Proof + "if_unchanged." + name.substr(Proof.size()) : name;
}

std::string SentenceBoundToSurface(const std::string& sentence)
{
  return "only of the surface whose triangles have output.checksum: " + sentence;
}

std::vector<ReportEntry> BoundToSurface(const std::vector<ReportEntry>& entries)
{
  std::vector<ReportEntry> bound = entries;
  for (ReportEntry& entry : bound)
  {
    if (entry.Name == Sentence)
    {
      entry.Value = SentenceBoundToSurface(std::get<std::string>(entry.Value));
    }
    entry.Name = NameBoundToSurface(entry.Name);
  }
  return bound;
}
}
