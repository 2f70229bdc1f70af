// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Wavefront OBJ has no counts to compare with, so every number and every index is checked.
/// Not read by VTK, whose reader rounds coordinates to single precision.
#include "Base/Text.h"
#include "FileChecks.h"
#include "FileFrame.h"
#include "LeftOutOfReader.h"
#include "LineReader.h"
#include "ObjCells.h"
#include "SurfaceReaders.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Points, texture coordinates and normals, in the order in which a corner "v/vt/vn" names them.
constexpr std::size_t NumberOfKinds = 3;
const std::array<const char*, NumberOfKinds> KindNames = { "vertex", "texture coordinate",
  "normal" };

/// A kind of cell.
struct Kind
{
  std::size_t FewestCorners;
  const char* TooFew;
};
constexpr Kind FaceKind = { 3, "a face of fewer than 3 corners; the file may be cut off" };
constexpr Kind LineKind = { 2, "a line of fewer than 2 points; the file may be cut off" };
constexpr Kind PointKind = { 1, "a point without a vertex; the file may be cut off" };

using Words = std::vector<const char*>;

/// Names, smoothing groups and display, which change no position.
const Words WordsWithoutShape = { "o", "s", "mg", "mtllib", "usemap", "maplib", "bevel", "c_interp",
  "d_interp", "lod", "shadow_obj", "trace_obj" };

/// Free-form curves and what belongs to free-form geometry.
const Words CurveWords = { "vp", "cstype", "deg", "bmat", "step", "parm", "trim", "hole", "scrv",
  "sp", "end", "con", "curv", "curv2", "ctech", "stech", "res" };
const Words SurfaceWords = { "surf", "bzp", "bsp", "cdc", "cdp" };

bool IsIn(const Words& words, const std::string& word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader
{
public:
  explicit ObjReader(const std::string& path)
    : Path(path)
    , Lines(path)
  {
  }

  vtkSmartPointer<vtkPolyData> Run(std::vector<std::string>& warnings)
  {
    while (this->Lines.Next())
    {
      this->ReadLine();
    }
    for (std::size_t kind = 0; kind < NumberOfKinds; ++kind)
    {
      if (this->Largest[kind] > this->CountOf(kind))
      {
        Reject(this->Path,
          std::string("a face names ") + KindNames[kind] + " " +
            std::to_string(this->Largest[kind]) + ", there are " +
            std::to_string(this->CountOf(kind)) + "; the file may be cut off");
      }
    }
    this->Warn(warnings);
    const vtkSmartPointer<vtkPolyData> surface = SurfaceOf(this->Content);
    AddLeftOutOfReader(
      { "lines_of_file", this->CurvesLeftOut,
        this->CurvesLeftOut == 1 ? "line of curves in the file" : "lines of curves in the file",
        {} },
      surface);
    return surface;
  }

private:
  [[noreturn]] void RejectLine(const std::string& reason)
  {
    Reject(this->Path, this->Lines.Prefix() + reason);
  }

  void Warn(std::vector<std::string>& warnings) const
  {
    if (!this->Lines.IsEnded())
    {
      warnings.emplace_back("the last line of the input has no end; the file may be cut off");
    }
    const auto warn = [&warnings](std::int64_t count, const char* before, const char* after)
    {
      if (count > 0)
      {
        warnings.push_back(before + std::to_string(count) + after);
      }
    };
    warn(this->NumbersLeftOut, "the numbers behind x, y and z of ",
      " vertices, such as weights, are not read");
    warn(this->IncompleteFaces, "",
      " faces have a texture coordinate or a normal at some of their corners alone; the others "
      "have "
      "none");
    const auto colors = static_cast<std::int64_t>(this->Content.Colors.size() / 3);
    warn(colors < this->CountOf(0) ? colors : 0, "the colors of ",
      " vertices are not read, because others have none");
    warn(this->CurvesLeftOut, "", " lines of curves are not read");
  }

  std::int64_t CountOf(std::size_t kind) const
  {
    const vtkIdType counts[] = { this->Content.Vertices.CountPoints(),
      this->Content.TextureCoordinates->GetNumberOfTuples(),
      this->Content.Normals->GetNumberOfTuples() };
    return counts[kind];
  }

  /// The words of the line, with those of the lines that it goes on in, without a comment.
  const std::vector<std::string_view>& WholeLine()
  {
    while (this->Lines.IsContinued())
    {
      if (!this->Lines.Continue())
      {
        this->RejectLine("it goes on in a line that is not there; the file is cut off");
      }
    }
    const std::string_view line = this->Lines.GetLine();
    this->WordsOfLine.clear();
    SplitWords(line.substr(0, line.find('#')), this->WordsOfLine);
    return this->WordsOfLine;
  }

  void ReadLine()
  {
    const std::string_view line = Trimmed(this->Lines.GetLine());
    if (line.empty())
    {
      return;
    }
    if (line[0] == '#')
    {
      this->Content.Frame = this->Content.Frame.empty() ? FrameIn(line) : this->Content.Frame;
      return;
    }
    const std::vector<std::string_view>& words = this->WholeLine();
    const std::string word = words.empty() ? std::string() : LowerCase(std::string(words[0]));
    if (word == "v")
    {
      this->ReadVertex(words);
    }
    else if (word == "vn" || word == "vt")
    {
      this->ReadTuple(
        words, word == "vn" ? this->Content.Normals.Get() : this->Content.TextureCoordinates.Get());
    }
    else if (word == "f" || word == "fo")
    {
      this->ReadCell(words, FaceKind, this->Content.Faces);
    }
    else if (word == "l")
    {
      this->ReadCell(words, LineKind, this->Content.Lines);
    }
    else if (word == "p")
    {
      this->ReadCell(words, PointKind, this->Content.Points);
    }
    else if (!word.empty()) // a backslash alone
    {
      this->ReadState(word);
    }
  }

  double NumberAt(
    const std::vector<std::string_view>& words, std::size_t position, std::size_t least)
  {
    if (position >= words.size())
    {
      this->RejectLine("fewer than " + std::to_string(least) + " numbers; the file may be cut off");
    }
    const std::optional<double> value = ParseNumber<double>(words[position]);
    // The words nan, inf and infinity have an n, no number has.
    if (!value || words[position].find_first_of("nN") != std::string_view::npos)
    {
      this->RejectLine(
        "'" + std::string(words[position].substr(0, 40)) + "' is not a finite number");
    }
    return *value;
  }

  void ReadVertex(const std::vector<std::string_view>& words)
  {
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < point.size(); ++i)
    {
      point[i] = this->NumberAt(words, i + 1, point.size());
    }
    for (const double coordinate : point)
    {
      this->Content.Vertices.Add(coordinate);
    }
    this->ReadRest(words);
  }

  /// Behind x, y and z: a weight, or red, green and blue and perhaps alpha, which MeshLab and
  /// others write.
  void ReadRest(const std::vector<std::string_view>& words)
  {
    const std::size_t numbers = words.size() - 4;
    if (numbers == 3 || numbers == 4)
    {
      for (std::size_t i = 4; i < 7; ++i)
      {
        this->Content.Colors.push_back(static_cast<float>(this->NumberAt(words, i, 6)));
      }
    }
    const bool isOne = numbers == 1 && this->NumberAt(words, 4, 4) == 1.0;
    const bool isRead = numbers == 0 || numbers == 3 || isOne;
    this->NumbersLeftOut += isRead ? 0 : 1;
  }

  void ReadTuple(const std::vector<std::string_view>& words, vtkFloatArray* array)
  {
    const bool isNormal = array == this->Content.Normals.Get();
    const std::size_t least = isNormal ? 3 : 1;
    std::array<float, 3> tuple{};
    for (std::size_t i = 0; i < (isNormal ? 3 : 2); ++i)
    {
      const bool isThere = i < least || i + 1 < words.size();
      tuple[i] = isThere ? static_cast<float>(this->NumberAt(words, i + 1, least)) : 0.0F;
    }
    array->InsertNextTypedTuple(tuple.data());
  }

  void ReadCell(const std::vector<std::string_view>& words, const Kind& kind, ObjCells& cells)
  {
    if (words.size() <= kind.FewestCorners)
    {
      this->RejectLine(kind.TooFew);
    }
    this->Corners.clear();
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      this->Corners.push_back(this->CornerOf(words[i]));
    }
    const ObjCorner& first = this->Corners.front();
    const bool isComplete = std::all_of(this->Corners.begin(), this->Corners.end(),
      [&first](const ObjCorner& corner)
      { return (corner[1] < 0) == (first[1] < 0) && (corner[2] < 0) == (first[2] < 0); });
    this->IncompleteFaces += isComplete ? 0 : 1;
    cells.Add(this->Corners, this->State);
  }

  ObjCorner CornerOf(std::string_view word)
  {
    ObjCorner corner{ { -1, -1, -1 } };
    std::string_view rest = word;
    for (std::size_t kind = 0; kind < NumberOfKinds && !rest.empty(); ++kind)
    {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view digits = rest.substr(0, slash);
      rest.remove_prefix(std::min(slash + 1, rest.size()));
      if (digits.empty() && kind == 1)
      {
        continue; // "3//7" has no texture coordinate
      }
      const std::optional<std::int64_t> index = ParseNumber<std::int64_t>(digits);
      if (index == 0 && kind > 0)
      {
        continue; // some programs write 0 for none
      }
      if (!index || index == 0)
      {
        this->RejectLine("'" + std::string(word.substr(0, 40)) + "' is not a corner of a face");
      }
      corner[kind] = this->IndexOf(*index, kind);
    }
    if (!rest.empty())
    {
      this->RejectLine("'" + std::string(word.substr(0, 40)) + "' is not a corner of a face");
    }
    return corner;
  }

  /// From 0; negative ones count back from the last that was read.
  vtkIdType IndexOf(std::int64_t index, std::size_t kind)
  {
    const std::int64_t count = this->CountOf(kind);
    if (index < -count)
    {
      this->RejectLine(
        "index " + std::to_string(index) + " reaches before the first " + KindNames[kind]);
    }
    this->Largest[kind] = std::max(this->Largest[kind], index);
    return index < 0 ? count + index : index - 1;
  }

  /// What follows the keyword, blanks and all.
  std::string NameOf(std::size_t keywordLength) const
  {
    return std::string(Trimmed(Trimmed(this->Lines.GetLine()).substr(keywordLength)));
  }

  void ReadState(const std::string& word)
  {
    const std::string name = this->NameOf(word.size());
    if (word == "g")
    {
      this->State.Group = this->HasGroup ? this->State.Group + 1 : this->GroupAfterNone();
      this->HasGroup = true;
    }
    else if (word == "mtllib" && !name.empty())
    {
      this->Content.MaterialLibraries.push_back(name);
    }
    else if (word == "usemtl")
    {
      this->SetMaterial(name);
    }
    else if (IsIn(CurveWords, word))
    {
      ++this->CurvesLeftOut;
    }
    else if (IsIn(SurfaceWords, word))
    {
      this->RejectLine(
        "'" + word + "' is a free-form surface, which is not read; export triangles");
    }
    else if (!IsIn(WordsWithoutShape, word))
    {
      this->RejectLine("'" + word.substr(0, 40) + "' is not a keyword of OBJ files");
    }
  }

  void SetMaterial(const std::string& name)
  {
    std::vector<std::string>& names = this->Content.Materials;
    const auto found = std::find(names.begin(), names.end(), name);
    this->State.Material = name.empty() ? -1 : static_cast<int>(found - names.begin());
    if (found == names.end() && !name.empty())
    {
      names.push_back(name);
    }
  }

  /// Faces before the first group are one, too.
  int GroupAfterNone() const
  {
    return this->Content.Faces.Vertices->GetNumberOfCells() > 0 ? 1 : 0;
  }

  const std::string& Path;
  LineReader Lines;
  std::vector<std::string_view> WordsOfLine;
  ObjContent Content;
  ObjState State;
  bool HasGroup = false;
  std::vector<ObjCorner> Corners; // of the cell that is read
  std::array<std::int64_t, NumberOfKinds> Largest{};
  std::int64_t NumbersLeftOut = 0; // vertices with numbers that are not read
  std::int64_t IncompleteFaces = 0;
  std::int64_t CurvesLeftOut = 0; // lines
};
}

vtkSmartPointer<vtkPolyData> ReadObjFile(
  const std::string& path, std::vector<std::string>& warnings)
{
  return ObjReader(path).Run(warnings);
}
}
