// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "DistanceColors.h"
#include "NamedLabels.h"
#include "NumberText.h"
#include "PageTemplate.h"
#include "SurfaceDistances.h"
#include "ViewerMesh.h"
#include "ViewerParts.h"
#include "ViewerProgram.h"
#include "Viewpoint.h"

#include "Base/Text.h"

#include "vtkBoundingBox.h"
#include "vtkPointData.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double Caution = 0.95; // bytes are not quite proportional to triangles
constexpr int MostReductions = 4;
constexpr double Wide = 1e6; // an aspect at which only the height counts
constexpr int Colors = 256;
constexpr int ColorDigits = 255;
constexpr double FirstThreshold = 0.8; // of the largest distance: few points have color at first

/// A surface of the page, ready to be written.
struct Carried
{
  EncodedSurface Encoded;
  std::string Caption;
  vtkIdType Triangles = 0;
  vtkIdType Whole = 0; ///< Triangles of the surface that it was made from.

  std::size_t Size() const { return this->Encoded.Base64.size(); }
};

/// What is left of some bytes.
std::size_t Rest(std::size_t bytes, std::size_t used)
{
  return bytes - std::min(bytes, used);
}

/// Writes the surfaces of one page in the same grid, parts and range.
class SceneWriter
{
public:
  explicit SceneWriter(const ViewerSubject& subject)
    : Subject(subject)
    , Original(MergedTriangles(subject.Before.Surface))
    , Division(this->Original, LabelsOf(subject.Levels.back().Surface))
    , Box(BoxOf(subject))
    , Grid(this->Box)
    , Distances(LargestOf(subject))
  {
  }

  /// The levels within half of the bytes, or within what a whole original leaves, and the original
  /// within the rest.
  std::vector<Carried> Carry(std::size_t bytes) const
  {
    std::vector<Carried> surfaces = { this->Encode(
      this->Subject.Before, this->Subject.Before.Surface) };
    std::size_t left = std::max(bytes / 2, Rest(bytes, surfaces.front().Size()));
    std::size_t used = 0;
    for (const ViewerSurface& level : this->Subject.Levels)
    {
      Carried carried = this->Encode(level, level.Surface);
      if (surfaces.size() == 1)
      {
        carried = this->Fitted(std::move(carried), level, left);
      }
      else if (carried.Size() > left && this->Subject.Reduce)
      {
        break;
      }
      left = Rest(left, carried.Size());
      used += carried.Size();
      surfaces.push_back(std::move(carried));
    }
    surfaces.front() =
      this->Fitted(std::move(surfaces.front()), this->Subject.Before, Rest(bytes, used));
    return surfaces;
  }

  Json Describe(const std::vector<Carried>& surfaces) const
  {
    Json scene = { { "grid", { { "origin", this->Grid.Origin }, { "step", this->Grid.Step } } },
      { "view", this->View() }, { "parts", this->Parts() }, { "distances", this->ColorTable() },
      { "axes", AxisLetters(this->Subject.Frame) }, { "farthest", this->Farthest() } };
    for (int side = 0; side < 6; ++side)
    {
      scene["bounds"].push_back(this->Box.GetBound(side));
    }
    for (const Carried& surface : surfaces)
    {
      Json pieces = Json::array();
      for (const EncodedPiece& piece : surface.Encoded.Pieces)
      {
        pieces.push_back({ { "parts", piece.Parts }, { "points", piece.Points },
          { "triangles", piece.Triangles } });
      }
      scene["surfaces"].push_back({ { "caption", surface.Caption },
        { "hasDistances", surface.Encoded.HasDistances }, { "pieces", pieces } });
    }
    return scene;
  }

  std::string Rounding() const
  {
    const auto bound = [](double length) {
      return ShortText(RoundUp(length, { 1, 1.2, 1.5, 2, 3, 4, 5, 6, 8 })) + " mm";
    };
    return "In this view positions are rounded by up to " +
      bound(0.5 * this->Grid.Step * std::sqrt(3.0)) +
      (this->Distances.Range > 0.0
          ? " and distances down by up to " + bound(this->Distances.Range / (Colors - 1)) +
            "; the files have them whole. " + this->Beyond() +
            "Between points, colors are interpolated: inside a large "
            "triangle the distance may be smaller or larger."
          : "; the files have them whole.");
  }

private:
  /// What has the color of the end, in a sentence; may be empty.
  std::string Beyond() const
  {
    return this->Subject.Tolerance > 0.0 ? "Distances above the tolerance of " +
        ShortText(this->Subject.Tolerance) + " mm have the last color. "
      : this->IsCapped()
      ? "Distances above " + ShortText(this->Distances.Range) + " mm have the color of the end. "
      : std::string();
  }

  /// Whether the colors end below the largest distance.
  bool IsCapped() const { return this->Distances.Largest > this->Distances.Range; }

  static vtkBoundingBox BoxOf(const ViewerSubject& subject)
  {
    vtkBoundingBox box;
    for (const ViewerSurface& level : subject.Levels)
    {
      box.AddBounds(TrianglesOnly(level.Surface)->GetBounds());
    }
    box.AddBounds(TrianglesOnly(subject.Before.Surface)->GetBounds());
    return box;
  }

  /// The range of the colors, that of the picture; 0 without distances.
  static QuantizedDistances LargestOf(const ViewerSubject& subject)
  {
    QuantizedDistances distances;
    distances.Range = 0.0;
    std::vector<const ViewerSurface*> surfaces = { &subject.Before };
    for (const ViewerSurface& level : subject.Levels)
    {
      surfaces.push_back(&level);
    }
    for (const ViewerSurface* surface : surfaces)
    {
      const std::vector<double> sorted =
        SortedDistances(TrianglesOnly(surface->Surface), surface->DistanceArrayName);
      if (!sorted.empty())
      {
        distances.Range = std::max(distances.Range, ColorRange(sorted));
        distances.Largest = std::max(distances.Largest, sorted.back());
      }
    }
    if (subject.Tolerance > 0.0 && distances.Range > 0.0)
    {
      distances.Range = ScaleOfTolerance(subject.Tolerance).Range;
      distances.Tolerance = subject.Tolerance;
    }
    return distances;
  }

  Carried Encode(const ViewerSurface& whole, vtkPolyData* surface) const
  {
    const auto triangles = MergedTriangles(surface);
    QuantizedDistances distances = this->Distances;
    distances.ArrayName = distances.Range > 0.0 ? whole.DistanceArrayName : std::string();
    Carried carried;
    carried.Encoded =
      EncodeSurface(triangles, this->Division.Divide(triangles), this->Grid, distances);
    carried.Triangles = triangles->GetNumberOfPolys();
    carried.Whole = surface == whole.Surface ? carried.Triangles
                                             : MergedTriangles(whole.Surface)->GetNumberOfPolys();
    const std::string count = GroupedText(static_cast<double>(carried.Triangles));
    carried.Caption = this->Subject.Names[&whole == &this->Subject.Before ? 0 : 1] + ": " + count +
      (carried.Triangles == carried.Whole
          ? std::string()
          : " of " + GroupedText(static_cast<double>(carried.Whole))) +
      " triangles" + whole.Caption;
    return carried;
  }

  /// The surface, reduced until it has at most that many bytes. @param carried The whole one.
  Carried Fitted(Carried carried, const ViewerSurface& whole, std::size_t bytes) const
  {
    for (int i = 0; i < MostReductions && this->Subject.Reduce && carried.Size() > bytes; ++i)
    {
      const double ratio =
        Caution * static_cast<double>(bytes) / static_cast<double>(carried.Size());
      const auto triangles = static_cast<vtkIdType>(ratio * static_cast<double>(carried.Triangles));
      carried =
        this->Encode(whole, this->Subject.Reduce(whole.Surface, std::max<vtkIdType>(triangles, 4)));
    }
    return carried;
  }

  Json View() const
  {
    const Viewpoint view = ChooseViewpoint(this->Original,
      this->Original->GetPointData()->GetArray(this->Subject.Before.DistanceArrayName.c_str()));
    const Frame wide = FrameWhole(view, this->Original, Wide);
    const Frame narrow = FrameWhole(view, this->Original, 1.0 / Wide);
    return { { "center", wide.Center }, { "toViewer", view.ToViewer }, { "up", view.Up },
      { "halfHeight", wide.HalfHeight }, { "halfWidth", narrow.HalfHeight / Wide },
      { "radius", 0.5 * this->Box.GetDiagonalLength() } };
  }

  Json Parts() const
  {
    Json parts = Json::array();
    for (const ViewerPart& part : this->Division.GetParts())
    {
      Json color;
      if (part.Color)
      {
        for (const unsigned char value : *part.Color)
        {
          color.push_back(std::round(1000.0 * value / ColorDigits) / 1000.0);
        }
      }
      parts.push_back({ { "name", part.Name }, { "color", color } });
    }
    return parts;
  }

  Json Farthest() const
  {
    Json points = Json::array();
    for (const FarPoint& one : this->Subject.Farthest)
    {
      points.push_back({ { "distance", MeasuredText(one.Distance) },
        { "where", AnatomicalText(one.Position, this->Subject.Frame) },
        { "position", one.Position }, { "outward", one.Outward } });
    }
    return points;
  }

  Json ColorTable() const
  {
    if (this->Distances.Range <= 0.0)
    {
      return nullptr;
    }
    Json colors = Json::array();
    const ColorScale scale = { this->Distances.Range, this->Distances.Tolerance };
    for (int i = 0; i < Colors; ++i)
    {
      // With a tolerance at the middle of each step, so that it ends with one.
      const Color color =
        DistanceColor(scale, i * scale.Range / (Colors - 1) + scale.Tolerance / Colors);
      colors.push_back({ std::lround(ColorDigits * color[0]), std::lround(ColorDigits * color[1]),
        std::lround(ColorDigits * color[2]) });
    }
    const double largest = std::min(this->Distances.Largest, this->Distances.Range);
    const double threshold = scale.Tolerance > 0.0 ? 0.0 : FirstThreshold * largest;
    const double step = (Colors - 1) * std::min(1.0, threshold / this->Distances.Range);
    Json table = { { "range", this->Distances.Range }, { "isCapped", this->IsCapped() },
      { "threshold", static_cast<int>(step) }, { "colors", colors } };
    if (scale.Tolerance > 0.0)
    {
      table["tolerance"] = scale.Tolerance;
    }
    return table;
  }

  const ViewerSubject& Subject;
  vtkSmartPointer<vtkPolyData> Original; // triangles
  ViewerDivision Division;
  vtkBoundingBox Box;
  QuantizationGrid Grid;
  QuantizedDistances Distances;
};

/// "x (right and left)" for the planes across an axis.
std::string AxisText(const std::string& frame, const char* axis, const char* words)
{
  return frame.empty() ? axis : std::string(axis) + " (" + words + ")";
}

/// What the page says of surfaces that are not whole; empty if all are.
std::string Reduced(const ViewerSubject& subject, const std::vector<Carried>& surfaces)
{
  std::string sentences;
  const auto add = [&sentences](const std::string& what, const Carried& surface)
  {
    sentences += "To keep this page small, " + what + " is shown with " +
      GroupedText(static_cast<double>(surface.Triangles)) + " of its " +
      GroupedText(static_cast<double>(surface.Whole)) + " triangles. ";
  };
  if (surfaces.front().Triangles < surfaces.front().Whole)
  {
    add(subject.Names[0] == "Before" ? "the surface before" : "the reference", surfaces.front());
  }
  if (surfaces[1].Triangles < surfaces[1].Whole)
  {
    add(subject.Names[0] == "Before" ? "the surface after" : "the result", surfaces[1]);
  }
  if (surfaces.size() <= subject.Levels.size())
  {
    sentences += "To keep this page small, it ends with the level of " +
      GroupedText(static_cast<double>(surfaces.back().Triangles)) + " triangles.";
  }
  return sentences;
}

/// Text in a script element ends at the first "</script" or "<!--".
std::string InScript(std::string json)
{
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
  {
    json.replace(at, 1, "\\u003c");
  }
  return json;
}
}

bool HasViewer()
{
  return *ViewerProgram != '\0';
}

ViewerHtml ComposeViewer(const ViewerSubject& subject)
{
  if (!HasViewer())
  {
    return {};
  }
  const std::string program = ViewerProgram;
  const SceneWriter writer(subject);
  const std::vector<Carried> surfaces = writer.Carry(Rest(subject.MostBytes, program.size()));
  std::string data;
  for (const Carried& surface : surfaces)
  {
    data += PageBlock("viewer surface", { { "bytes", surface.Encoded.Base64 } });
  }
  const Json scene = writer.Describe(surfaces);
  const bool hasLabels = !LabelsOf(subject.Levels.back().Surface).empty();
  return { PageBlock("viewer",
             { { "legend", subject.Legend }, { "rounding", writer.Rounding() },
               { "reduced", Reduced(subject, surfaces) }, { "before", LowerCase(subject.Names[0]) },
               { "after", LowerCase(subject.Names[1]) },
               { "x", AxisText(subject.Frame, "x", "right and left") },
               { "y", AxisText(subject.Frame, "y", "front and back") },
               { "z", AxisText(subject.Frame, "z", "head and feet") },
               { "parts", hasLabels ? "Labels" : "Components" } }),
    PageBlock("viewer script",
      { { "scene", InScript(scene.dump()) }, { "surfaces", data }, { "program", program } }) };
}
}
