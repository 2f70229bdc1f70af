// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlicerXml.h"

#include "Base/Text.h"
#include "Formats/SurfaceFormat.h"
#include "Options/OptionTable.h"
#include "Run/Report/Report.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace bonedecimate
{
namespace
{
/// The first options of a panel. A panel passes every number, so a default that the program ignores
/// next to other options is replaced by a value of its own.
struct Shown
{
  const char* Option;
  const char* Value; // null: the table's
};
constexpr Shown Goals[] = { { "MaximumError", "0.2" }, { "ErrorPreset", nullptr },
  { "VoxelSize", nullptr }, { "TargetNumberOfTriangles", nullptr }, { "TargetReduction", "1" },
  { "Mode", nullptr }, { "IntersectionGuard", nullptr } };

/// "MaximumError" becomes "Maximum error".
std::string LabelOf(const std::string& name)
{
  std::string label;
  for (const char c : name)
  {
    const bool isCapital = c >= 'A' && c <= 'Z';
    label += isCapital && !label.empty() ? std::string(" ") + static_cast<char>(c - 'A' + 'a')
                                         : std::string(1, c);
  }
  return label;
}

/// Slicer takes letters, numbers and underscores.
std::string SlicerFlag(std::string flag)
{
  std::replace(flag.begin(), flag.end(), '-', '_');
  return "--" + flag;
}

class Description
{
public:
  std::string Compose()
  {
    this->Text << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<executable>\n";
    this->Head();
    this->Models();
    this->OpenGroup("How small", "What ends the simplification; the first that is reached does.");
    for (const Shown& goal : Goals)
    {
      this->Add(*FindOption(goal.Option), goal.Value);
    }
    this->CloseGroup();
    this->Regions();
    this->OpenGroup("Everything else", "The other options of the program.", true);
    for (const OptionInfo& info : OptionTable())
    {
      const bool isShown = std::any_of(std::begin(Goals), std::end(Goals),
        [&](const Shown& goal) { return info.Name == goal.Option; });
      if (!isShown && !info.Flag.empty())
      {
        this->Add(info, nullptr);
      }
    }
    this->CloseGroup();
    this->Results();
    this->Text << "</executable>\n";
    return this->Text.str();
  }

private:
  void Put(const char* element, const std::string& text)
  {
    this->Text << "<" << element << ">" << EscapedXml(text) << "</" << element << ">\n";
  }

  void Head()
  {
    this->Put("category", "Surface Models");
    this->Put("title", "Bone Decimation");
    this->Put("description",
      "Makes a surface of bone smaller by edge collapse and proves, in mm, how far the result is "
      "from it. Not a medical device.");
    this->Put("version", Version());
    this->Put("documentation-url", "");
    this->Put("license", "BSD-3-Clause");
    this->Put("contributor", "vtkBoneDecimate contributors");
    this->Put("acknowledgements", "After H. Brandao's thesis on normal field deviation, 2018.");
  }

  void OpenGroup(const char* label, const char* description, bool isAdvanced = false)
  {
    this->Text << (isAdvanced ? "<parameters advanced=\"true\">\n" : "<parameters>\n");
    this->Put("label", label);
    this->Put("description", description);
  }
  void CloseGroup() { this->Text << "</parameters>\n"; }

  void Open(const std::string& element, const std::string& name, const std::string& label,
    const std::string& description)
  {
    this->Text << "<" << element << ">\n";
    this->Put("name", name);
    this->Put("label", label);
    this->Put("description", description);
  }
  /// @param element With or without attributes.
  void Close(const std::string& element)
  {
    this->Text << "</" << element.substr(0, element.find(' ')) << ">\n";
  }

  void Model(const char* name, const char* label, const char* channel, const char* element,
    const std::string& value, bool needsArrays = false)
  {
    std::string extensions;
    for (const SurfaceFormat* format : SurfaceFormats())
    {
      const bool isOfSlicer = !format->NamesUnit; // 3D Slicer's models are in mm
      if (isOfSlicer && (format->HoldsArrays || !needsArrays))
      {
        extensions += (extensions.empty() ? "." : ",.") + std::string(format->Extension);
      }
    }
    this->Open("geometry fileExtensions=\"" + extensions + "\"", name, label, label);
    this->Put("channel", channel);
    this->Put(element, value);
    this->Close("geometry");
  }

  void Models()
  {
    this->OpenGroup("Models", "Closed or open, in mm.");
    this->Model("inputModel", "Input model", "input", "index", "0");
    this->Model("outputModel", "Output model", "output", "index", "1");
    this->Model("heatmapModel", "Input model with its distance to the result", "output", "longflag",
      "--heatmap", true);
    this->CloseGroup();
  }

  void Regions()
  {
    this->OpenGroup("Where", "Needs a maximum error.");
    this->Open("region multiple=\"false\" coordinateSystem=\"lps\"", "roi", "Only inside of",
      "A region of interest: everything outside stays as it is, bit for bit.");
    this->Put("longflag", "--roi");
    this->Close("region");
    this->Open("point multiple=\"true\" coordinateSystem=\"lps\"", "keep", "Keep around",
      "Points: what is near them stays as it is, bit for bit.");
    this->Put("longflag", "--keep");
    this->Close("point");
    this->Open("double", "keepRadius", "Keep within (mm)", "Radius of what stays, mm.");
    this->Put("longflag", SlicerFlag("keep-radius"));
    this->Put("default", "5");
    this->Text << "<constraints><minimum>0</minimum><step>1</step></constraints>\n";
    this->Close("double");
    this->CloseGroup();
  }

  void Constrain(const OptionInfo& info, bool isWhole)
  {
    const bool isBounded = info.Maximum < std::numeric_limits<int>::max();
    this->Text << "<constraints><minimum>" << info.Minimum << "</minimum>";
    if (isBounded)
    {
      this->Text << "<maximum>" << info.Maximum << "</maximum>";
    }
    this->Text << "<step>"
               << (isWhole        ? "1"
                      : isBounded ? "0.01"
                                  : "0.05")
               << "</step></constraints>\n";
  }

  /// Switches are words here, as on the command line.
  void Add(const OptionInfo& info, const char* value)
  {
    const OptionValue standard = GetOption(Options{}, info);
    const bool isSwitch = std::holds_alternative<bool>(standard);
    const bool isChoice = isSwitch || !info.Choices.empty();
    const bool isWhole = std::holds_alternative<int>(standard);
    const std::string element = isChoice         ? "string-enumeration"
      : isWhole                                  ? "integer"
      : std::holds_alternative<double>(standard) ? "double"
                                                 : "string";
    const std::string unit = info.Unit.empty() ? "" : " (" + info.Unit + ")";
    this->Open(element, info.Name, LabelOf(info.Name) + unit, info.Sentence);
    this->Put("longflag", SlicerFlag(info.Flag));
    this->Put("default", value != nullptr ? value : OptionText(Options{}, info));
    if (isChoice)
    {
      for (const std::string& choice :
        isSwitch ? std::vector<std::string>{ "on", "off" } : info.Choices)
      {
        this->Put("element", choice);
      }
    }
    else if (element != "string")
    {
      this->Constrain(info, isWhole);
    }
    this->Close(element);
  }

  void Results()
  {
    this->OpenGroup("Results", "What the run says of itself.");
    for (const SlicerResult& result : SlicerResults())
    {
      this->Open(result.Kind, result.Name, result.Label, result.Label);
      this->Put("channel", "output");
      this->Put("default", std::string(result.Kind) == "string" ? "" : "0");
      this->Close(result.Kind);
    }
    this->CloseGroup();
  }

  std::ostringstream Text;
};
}

const std::vector<SlicerResult>& SlicerResults()
{
  static const std::vector<SlicerResult> results = {
    { "inputTriangles", "integer", "input.triangles", "Triangles before" },
    { "outputTriangles", "integer", "output.triangles", "Triangles after" },
    { "fragments", "integer", "output.components", "Fragments after" },
    { "provedError", "double", "proof.upper", "Proved: no point is farther away (mm)" },
    { "proofStatus", "string", "proof.status", "Whether the requested error is kept" },
    { "averageDistance", "double", "distance.input_to_output.mean", "Average distance (mm)" },
    { "stopReason", "string", "stop_sentence", "Why it ended" },
  };
  return results;
}

std::string SlicerXml()
{
  return Description().Compose();
}
}
