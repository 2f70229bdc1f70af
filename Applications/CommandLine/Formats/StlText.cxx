// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StlText.h"

#include "Base/Text.h"
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "FileFrame.h"
#include "LineReader.h"

#include <array>

namespace bonedecimate
{
namespace
{
/// Keywords in the order in which they come.
enum class Word
{
  Solid,
  Facet,
  Outer,
  Vertex,
  EndLoop,
  EndFacet,
  EndSolid,
  Other
};

Word WordOf(const std::string& lower)
{
  static const std::array<const char*, 7> words = { "solid", "facet", "outer", "vertex", "endloop",
    "endfacet", "endsolid" };
  std::size_t i = 0;
  while (i < words.size() && lower != words[i])
  {
    ++i;
  }
  return static_cast<Word>(i);
}

class StlTextReader
{
public:
  StlTextReader(const std::string& path, CoordinateCollector& points)
    : Path(path)
    , Lines(path)
    , Points(points)
  {
  }

  void Run()
  {
    while (this->HasWord())
    {
      std::string word = this->TakeLower();
      if (word == "end" && this->HasWord())
      {
        word += this->TakeLower(); // "end facet"
      }
      this->Read(WordOf(word), word);
    }
    if (this->Before != Word::EndSolid)
    {
      Reject(this->Path, "it does not end with 'endsolid'; the file is cut off");
    }
  }

  std::string Frame;

private:
  /// Whether there is another word, on this line or a later one.
  bool HasWord()
  {
    while (this->Next >= this->Lines.GetWords().size())
    {
      if (!this->Lines.Next())
      {
        return false;
      }
      this->Next = 0;
    }
    return true;
  }

  std::string TakeLower() { return LowerCase(std::string(this->Lines.GetWords()[this->Next++])); }

  void SkipLine() { this->Next = this->Lines.GetWords().size(); }

  void Read(Word word, const std::string& text)
  {
    this->RequireOrder(word, text);
    switch (word)
    {
      case Word::Solid:
        this->Frame = this->Frame.empty() ? FrameIn(this->Lines.GetLine()) : this->Frame;
        this->SkipLine(); // the name
        break;
      case Word::EndSolid:
        this->SkipLine();
        break;
      case Word::Facet:
        this->SkipNormal();
        break;
      case Word::Outer:
        this->Require("loop");
        break;
      case Word::Vertex:
        this->ReadVertex();
        break;
      default:
        break;
    }
  }

  void Require(const char* expected)
  {
    const std::string word = this->HasWord() ? this->TakeLower() : std::string();
    if (word != expected)
    {
      Reject(this->Path,
        this->Lines.Prefix() + "'" + word.substr(0, 40) + "' is where '" + expected +
          "' is expected");
    }
  }

  /// Normals are not read: the order of the vertices tells the orientation.
  void SkipNormal()
  {
    for (int i = 0; i < 4 && this->HasWord(); ++i) // "normal" and three numbers
    {
      if (LowerCase(std::string(this->Lines.GetWords()[this->Next])) == "outer")
      {
        return;
      }
      ++this->Next;
    }
  }

  void ReadVertex()
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::optional<double> coordinate =
        this->HasWord() ? ParseNumber<double>(this->Lines.GetWords()[this->Next++]) : std::nullopt;
      if (!coordinate)
      {
        Reject(this->Path, this->Lines.Prefix() + "a vertex is not three numbers");
      }
      this->Points.Add(*coordinate);
    }
  }

  /// A triangle is three vertices between "outer loop" and "endloop", nothing else is one.
  void RequireOrder(Word word, const std::string& text)
  {
    const Word before = this->Before;
    const bool isBetween = before == Word::Solid || before == Word::EndFacet;
    bool isInOrder = false;
    switch (word)
    {
      case Word::Solid:
        isInOrder = before == Word::EndSolid;
        break;
      case Word::Facet:
      case Word::EndSolid:
        isInOrder = isBetween;
        break;
      case Word::Vertex:
        isInOrder = (before == Word::Outer || before == Word::Vertex) && this->Vertices < 3;
        break;
      case Word::EndLoop:
        isInOrder = before == Word::Vertex && this->Vertices == 3;
        break;
      case Word::Other:
        Reject(this->Path,
          this->Lines.Prefix() + "'" + text.substr(0, 40) + "' is not a word of STL files");
      default:
        isInOrder = static_cast<int>(before) + 1 == static_cast<int>(word);
    }
    if (!isInOrder)
    {
      Reject(this->Path,
        this->Lines.Prefix() + "'" + text +
          "' is out of place: a facet is one loop of three vertices");
    }
    this->Vertices = word == Word::Vertex ? this->Vertices + 1 : 0;
    this->Before = word;
  }

  const std::string& Path;
  LineReader Lines;
  CoordinateCollector& Points;
  std::size_t Next = 0; // word of the line
  Word Before = Word::EndSolid;
  int Vertices = 0; // of the loop
};
}

bool IsStlWord(std::string_view word)
{
  return WordOf(LowerCase(std::string(word))) != Word::Other;
}

//------------------------------------------------------------------------------
std::string ReadStlText(const std::string& path, CoordinateCollector& points)
{
  StlTextReader reader(path, points);
  reader.Run();
  return reader.Frame;
}
}
