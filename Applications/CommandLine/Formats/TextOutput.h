// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TextOutput.h
 * @brief A file of text, and why a file could not be written.
 */
#ifndef BoneDecimate_Applications_TextOutput_h
#define BoneDecimate_Applications_TextOutput_h

#include <fstream>
#include <string>
#include <string_view>

namespace bonedecimate
{
/// What the system says of the last failure: "No space left on device"; without that "the file
/// could not be written".
std::string WriteProblem();

class TextOutput
{
public:
  explicit TextOutput(const std::string& path);

  void Add(std::string_view text);

  /// A blank and the shortest decimal that is read as the same number, of single or double
  /// precision.
  void AddNumber(double number, bool isSingle);

  /// @throws Failure(ExitCode::CouldNotWrite) if not everything was written.
  void Close();

private:
  std::ofstream Stream;
};
}

#endif
