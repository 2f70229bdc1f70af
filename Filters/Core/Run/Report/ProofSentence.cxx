// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProofSentence.h"

#include "CertificateTable.h"
#include "Figures/BoundText.h"

namespace bonedecimate
{
namespace
{
constexpr int DecimalsOfBound = 6;
const std::string Proof = "proof.";
const std::string Sentence = "proof.sentence";
}

std::string ProofSentence(const ProofFacts& facts)
{
  const std::string clause = LeftOutClause(facts.LeftOut, facts.Upper);
  return "at most " + UpperBoundText(facts.Upper, DecimalsOfBound) + " mm in both directions" +
    (facts.IsToReference ? " to the reference" : "") +
    (facts.Boundaries == "both"              ? ", open boundaries too"
        : facts.Boundaries == "not_compared" ? ", but for open boundaries"
                                             : "") +
    (clause.empty() ? "" : ", " + clause);
}

std::string ProofSentence(const Report& report)
{
  return ProofSentence({ report.Proof.Upper(), report.Reference.IsPresent,
    BoundariesWord(report.Proof), report.LeftOut });
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
