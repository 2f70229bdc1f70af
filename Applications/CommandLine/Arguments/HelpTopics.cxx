// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpTopics.h"

#include "Base/Text.h"
#include "Commands/CommandLine.h"
#include "ExitCode.h"
#include "HelpFormatter.h"
#include "NearestWord.h"
#include "Options/Modes.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <functional>
#include <iostream>
#include <memory>

namespace bonedecimate
{
namespace
{
constexpr std::size_t LineWidth = 100;
constexpr std::size_t WordColumn = 13;

std::string ModesText()
{
  std::string text = "Modes, for --mode:\n";
  for (const ModeInfo& mode : ModeTable())
  {
    std::string name = std::string("  ") + mode.Name;
    name.resize(std::max(name.size() + 1, WordColumn), ' ');
    text += name + mode.Text.Use + "\n";
  }
  return text;
}

const CLI::App& DefaultApp(const CLI::App& program)
{
  return *FindCommand(program, DefaultCommand);
}

/// Words behind a margin, wrapped; the first line has its head in the margin.
std::string Wrapped(const std::string& head, const std::vector<std::string>& words)
{
  std::string text = "  " + head;
  text.resize(std::max(text.size() + 1, WordColumn), ' ');
  std::size_t width = text.size();
  for (const std::string& word : words)
  {
    if (width + word.size() > LineWidth)
    {
      text.back() = '\n';
      text += std::string(WordColumn, ' ');
      width = WordColumn;
    }
    text += word + " ";
    width += word.size() + 1;
  }
  text.back() = '\n';
  return text;
}

std::vector<std::string> NamesOfCommands(const CLI::App& program)
{
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
  {
    if (command->get_name() != DefaultCommand)
    {
      names.push_back(command->get_name());
    }
  }
  return names;
}

std::string TopicHelp(const CLI::App& program, const HelpTopic& topic)
{
  const std::string options = OptionEntries(DefaultApp(program), topic.Flags);
  const std::string text = topic.Text == nullptr ? std::string() : topic.Text();
  return (options.empty() ? "" : topic.Title + ":\n" + options) +
    (options.empty() || text.empty() ? "" : "\n") + text +
    (text.empty() || text.back() == '\n' ? "" : "\n");
}

/// The first topic with a word in its title, an option or a profile that begins as this one does.
const HelpTopic* TopicWith(const std::string& word)
{
  const std::string beginning = word.substr(0, 4);
  const auto isLike = [&beginning](const std::string& text)
  {
    const std::string lower = LowerCase(text);
    const std::size_t at = lower.find(beginning);
    return at == 0 ||
      (at != std::string::npos && std::isalnum(static_cast<unsigned char>(lower[at - 1])) == 0);
  };
  for (const HelpTopic& topic : HelpTopics())
  {
    if (isLike(topic.Title) || std::any_of(topic.Flags.begin(), topic.Flags.end(), isLike))
    {
      return &topic;
    }
  }
  return nullptr;
}

/// Empty if nothing has that name, or a topic begins with it.
std::string HelpAbout(const CLI::App& program, const std::string& word)
{
  const HelpTopic* beginsWithIt = nullptr;
  for (const HelpTopic& topic : HelpTopics())
  {
    if (topic.Word == word)
    {
      return TopicHelp(program, topic);
    }
    if (topic.Word.compare(0, word.size(), word) == 0 && beginsWithIt == nullptr)
    {
      beginsWithIt = &topic;
    }
  }
  const CLI::App* const command = FindCommand(program, word);
  const std::string text =
    command != nullptr ? command->help() : OptionEntries(DefaultApp(program), { word });
  const HelpTopic* const topic = beginsWithIt != nullptr     ? beginsWithIt
    : word.size() > 4 && word.find('-') == std::string::npos ? TopicWith(LowerCase(word))
                                                             : nullptr;
  return text.empty() && topic != nullptr ? TopicHelp(program, *topic) : text;
}

void PrintHelp(const CLI::App& program, const std::string& word)
{
  const std::string text = word.empty() ? ShortHelp(program) : HelpAbout(program, word);
  if (text.empty())
  {
    std::vector<std::string> known = NamesOfCommands(program);
    for (const HelpTopic& topic : HelpTopics())
    {
      known.push_back(topic.Word);
      known.insert(known.end(), topic.Flags.begin(), topic.Flags.end());
    }
    const std::string nearest = NearestWord(word, known);
    throw Failure(ExitCode::Usage,
      "help has no topic, command or option '" + word + "'; " +
        (nearest.empty() ? "bonedecimate help lists them" : "did you mean " + nearest + "?"));
  }
  std::cout << text;
}
}

const std::vector<HelpTopic>& HelpTopics()
{
  static const std::vector<HelpTopic> topics = {
    { "how-much", "How much: the largest error and the number of triangles",
      { "max-error", "target-triangles", "target-reduction", "mode", "preset", "voxel-size",
        "tolerance-array", "region", "reference", "allow-large-error", "refinement-effort" } },
    { "modes", "What the modes are for", {}, ModesText },
    { "proof", "What is proved and measured",
      { "prove", "prove-each-edit", "measure", "intersection-guard" } },
    { "volumes", "Volumes and label maps",
      { "iso", "segments", "label-names", "fill-volume", "keep-voxels", "label-map", "label",
        "labels", "model-grid", "intensities", "memory", "spacing", "series" } },
    { "smoothing", "Smoothing", { "smooth", "auto-smooth", "feature-angle" } },
    { "cleaning", "Cleaning the input: specks, tunnels, gaps",
      { "prune-size", "prune-area", "prune-volume", "prune-triangles", "close-tunnels", "weld",
        "merge-points", "diagnose" } },
    { "shape", "The shape of triangles",
      { "min-angle", "edge-length", "chordal-error", "edge-length-array" } },
    { "results", "Report, page and pictures",
      { "report", "page", "picture", "heatmap", "vertex-colors", "quiet", "progress" } },
    { "files", "Surface files and their arrays",
      { "also", "format", "unit", "precision", "position-bits", "glb-compression", "pass-arrays",
        "maps", "recompute-normals" },
      FormatsText },
    { "batches", "Many bones", { "jobs", "force", "only", "shard", "time-limit", "memory-limit" },
      BatchText },
    { "settings", "Settings: profiles (planning, print, FEM, web), files, threads",
      { "profile", "config", "threads", "explain" } },
    { "mode-thesis", "Mode Thesis", { "normal-tolerance", "auto-normal-tolerance" } },
    { "program", "The program",
      { "help", "version", "completion", "man", "options-markdown", "options-json",
        "profiles-markdown", "tables" } },
    { "exit-codes", "Exit codes", {}, ExitCodesText },
  };
  return topics;
}

std::string ShortHelp(const CLI::App& program)
{
  std::string text = ProgramDescription() + "\n" +
    "Usage: bonedecimate INPUT OUTPUT [OPTIONS]\n"
    "       bonedecimate ct.nrrd bone.vtp --iso bone --max-error 0.5 --page bone.html\n"
    "       bonedecimate labels.nii.gz folder --segments all --max-error halfvoxel\n"
    "       bonedecimate scans folder --iso bone --max-error 0.5\n\n"
    "Options by topic:\n";
  for (const HelpTopic& topic : HelpTopics())
  {
    std::vector<std::string> flags;
    for (const std::string& flag : topic.Flags)
    {
      if (DefaultApp(program).get_option_no_throw("--" + flag) != nullptr)
      {
        flags.push_back("--" + flag);
      }
    }
    text += Wrapped(topic.Word, flags.empty() ? std::vector<std::string>{ topic.Title } : flags);
  }
  return text + "\n" + Wrapped("commands", NamesOfCommands(program)) +
    "\nbonedecimate help WORD explains a topic, a command or an option; --help has all of "
    "them.\nThis software is not a medical device.\n";
}

//------------------------------------------------------------------------------
std::vector<std::string> WithOptionAsWord(std::vector<std::string> words)
{
  const bool isHelp = words.size() == 2 && words[0] == "help" && words[1].size() > 2;
  if (isHelp && words[1] != "--help" && words[1].compare(0, 2, "--") == 0)
  {
    words[1].erase(0, 2);
  }
  return words;
}

//------------------------------------------------------------------------------
void AddHelpCommand(CLI::App& program)
{
  CLI::App& command = AddCommand(program, "help", { "[TOPIC|COMMAND|OPTION]" },
    "Explains a topic, a command or an option; without one it prints the short help.");
  const auto word = std::make_shared<std::string>();
  command.add_option("TOPIC", *word, "A word of the short help.")->type_name("");
  command.callback([&program, word] { PrintHelp(program, *word); });
}
}
