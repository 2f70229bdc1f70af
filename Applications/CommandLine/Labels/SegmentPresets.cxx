// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentPresets.h"

#include "Base/Text.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <vector>

namespace bonedecimate
{
namespace
{
using WordSet = std::set<std::string>;

const WordSet& WordsOfSoftTissues()
{
  static const WordSet words = { "artery", "canal", "cartilage", "cartilages", "cord", "disc",
    "discs", "disk", "ligament", "marrow", "meniscus", "muscle", "muscles", "nerve", "tendon",
    "vein" };
  return words;
}

/// Besides the vertebrae, which have names like "L5", too.
const std::map<std::string, WordSet>& WordsOfPresets()
{
  static const std::map<std::string, WordSet> words = []
  {
    std::map<std::string, WordSet> all;
    all["vertebrae"] = { "vertebra", "vertebrae" };
    all["pelvis"] = { "coccyx", "coxa", "coxae", "hip", "hips", "ilium", "innominate", "ischium",
      "pelvis", "pubis", "sacrum" };
    all["skull"] = { "cranium", "jaw", "jawbone", "mandible", "maxilla", "skull", "zygoma",
      "zygomatic" };
    WordSet& bones = all["bones"];
    bones = { "bone", "bones", "calcaneus", "carpal", "carpals", "clavicle", "clavicles",
      "clavicula", "femur", "femurs", "fibula", "fibulas", "humerus", "metacarpal", "metacarpals",
      "metatarsal", "metatarsals", "patella", "patellas", "phalanges", "phalanx", "radius", "rib",
      "ribs", "scapula", "scapulas", "sternum", "talus", "tarsal", "tarsals", "tibia", "tibias",
      "ulna" };
    for (const char* part : { "vertebrae", "pelvis", "skull" })
    {
      bones.insert(all[part].begin(), all[part].end());
    }
    return all;
  }();
  return words;
}

/// In small letters: "vertebrae", "l5" of "vertebrae_L5".
std::vector<std::string> WordsOfName(const std::string& name)
{
  std::vector<std::string> words(1);
  for (const char c : LowerCase(name))
  {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
    {
      words.back() += c;
    }
    else if (!words.back().empty())
    {
      words.emplace_back();
    }
  }
  return words;
}

/// "c1" to "s5".
bool IsNumberOfVertebra(const std::string& word)
{
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  return (word.size() == 2 || word.size() == 3) &&
    std::string("ctls").find(word[0]) != std::string::npos &&
    std::all_of(word.begin() + 1, word.end(), isDigit);
}
}

bool IsPreset(const std::string& word)
{
  return WordsOfPresets().count(LowerCase(word)) > 0;
}

//------------------------------------------------------------------------------
bool IsOfPreset(const std::string& word, const std::string& name)
{
  const auto preset = WordsOfPresets().find(LowerCase(word));
  if (preset == WordsOfPresets().end())
  {
    return false;
  }
  const std::vector<std::string> words = WordsOfName(name);
  const auto isOfBone = [&preset](const std::string& one) { return preset->second.count(one) > 0; };
  const auto isOfSoftTissue = [](const std::string& one)
  { return WordsOfSoftTissues().count(one) > 0; };
  const bool hasVertebrae = preset->second.count("vertebrae") > 0;
  return std::none_of(words.begin(), words.end(), isOfSoftTissue) &&
    (std::any_of(words.begin(), words.end(), isOfBone) ||
      (hasVertebrae && words.size() == 1 && IsNumberOfVertebra(words[0])));
}
}
