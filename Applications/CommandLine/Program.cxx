// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "Arguments/HelpFormatter.h"
#include "Arguments/HelpTopics.h"
#include "Commands/Cap.h"
#include "Commands/Certify.h"
#include "Commands/CommandLine.h"
#include "Commands/DecimateCommand.h"
#include "Commands/Demo.h"
#include "Commands/Diagnose.h"
#include "Commands/ErrorCommands.h"
#include "Commands/LevelsCommand.h"
#include "Commands/SlicerModule.h"
#include "Commands/SummaryCommand.h"
#include "Files/StandardOutput.h"
#include "IsolatedReader.h"
#include "PlainText.h"
#include "Terminal/Interruption.h"
#include "Terminal/PlainStream.h"
#include "Terminal/VtkMessages.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>
#include <string_view>
#include <system_error>

namespace bonedecimate
{
namespace
{
/// Without allocating: it also tells of a lack of memory.
ExitCode Fail(ExitCode code, const char* message)
{
  std::fputs("bonedecimate: ", stderr);
  for (std::string_view rest = message; !rest.empty();)
  {
    const std::size_t length = LengthOfPlainCharacter(rest);
    const char replacement = rest[0] == '\n' ? ' ' : '?';
    std::fwrite(
      length > 0 ? rest.data() : &replacement, 1, std::max<std::size_t>(length, 1), stderr);
    rest.remove_prefix(std::max<std::size_t>(length, 1));
  }
  std::fputc('\n', stderr);
  return code;
}

ExitCode Run(int argc, char* argv[])
{
  const std::vector<std::string> words(argv + 1, argv + std::max(argc, 1));
  const StandardOutputForFile forFile(words);
  if (IsSlicerCall(words))
  {
    return RunSlicerCall(words);
  }
  ExitCode code = ExitCode::Done;
  CLI::App program(ProgramDescription(), "bonedecimate");
  program.require_subcommand(1);
  program.allow_windows_style_options(false); // a path may begin with a slash
  AddDecimateCommand(program, argc > 0 ? argv[0] : "", code);
  AddThesisCommand(program, code);
  AddSmoothCommand(program, code);
  AddCertifyCommand(program, code);
  AddToleranceCommand(program, code);
  AddCurveCommand(program, code);
  AddLevelsCommand(program);
  AddDiagnoseCommand(program, code);
  AddCapCommand(program);
  AddSummaryCommand(program, code);
  AddDemoCommand(program);
  AddHelpCommand(program);
  RunCommandLine(program, WithOptionAsWord(words));
  return code;
}
}

ExitCode RunProgram(int argc, char* argv[])
{
  const PlainStream output(std::cout);
  const PlainStream errors(std::cerr);
  CatchSignals();
  volume::StopReadingBy(StopIfInterrupted);
  CollectVtkMessages();
  try
  {
    const ExitCode code = Run(argc, argv);
    const bool told = static_cast<bool>(std::cout.flush());
    return told || output.IsClosed()
      ? code
      : Fail(ExitCode::CouldNotWrite, "could not write to the standard output");
  }
  catch (const Failure& failure)
  {
    std::cout.flush();
    return Fail(failure.Code, failure.what());
  }
  catch (const std::bad_alloc&)
  {
    return Fail(ExitCode::OutOfMemory, "out of memory");
  }
  catch (const std::length_error&)
  {
    return Fail(ExitCode::OutOfMemory, "out of memory: more elements than an array can hold");
  }
  catch (const std::system_error& error)
  {
    const bool threads = error.code() == std::errc::resource_unavailable_try_again;
    return Fail(threads ? ExitCode::OutOfMemory : ExitCode::CouldNotWrite, error.what());
  }
  catch (const std::exception& error)
  {
    return Fail(ExitCode::InputRejected, error.what()); // of a library that reads
  }
}
}
