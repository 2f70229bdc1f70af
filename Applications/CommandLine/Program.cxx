// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "Arguments.h"
#include "Batch.h"
#include "Certify.h"
#include "ErrorCommands.h"
#include "Inspect.h"
#include "Interruption.h"
#include "LevelsCommand.h"
#include "RunOne.h"
#include "SlicerModule.h"
#include "VtkMessages.h"
#include "Words.h"

#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>
#include <system_error>

namespace bonedecimate
{
namespace
{
/// Without allocating: it also tells of a lack of memory.
ExitCode Fail(ExitCode code, const char* message)
{
  std::fputs("bonedecimate: ", stderr);
  for (const char* c = message; *c != '\0'; ++c)
  {
    std::fputc(*c == '\n' ? ' ' : *c, stderr);
  }
  std::fputc('\n', stderr);
  return code;
}

/// What one word asks for: reads the rest of them, does it.
struct Command
{
  const char* Word;
  ExitCode (*Run)(int argc, char* argv[]);
};

template <typename Wanted, std::optional<Wanted> Parse(int, char**), ExitCode Do(const Wanted&)>
ExitCode ParseAndDo(int argc, char* argv[])
{
  const std::optional<Wanted> arguments = Parse(argc, argv);
  return arguments ? Do(*arguments) : ExitCode::Done;
}

constexpr Command Commands[] = {
  { "certify", ParseAndDo<CertifyArguments, ParseCertifyArguments, RunCertify> },
  { "check", ParseAndDo<InspectArguments, ParseInspectArguments, RunInspect> },
  { "levels", ParseAndDo<LevelsArguments, ParseLevelsArguments, RunLevels> },
  { "tolerance", ParseAndDo<ErrorArguments, ParseErrorArguments, RunErrorCommand> },
  { "curve", ParseAndDo<ErrorArguments, ParseErrorArguments, RunErrorCommand> },
};

ExitCode Run(int argc, char* argv[])
{
  for (const Command& command : Commands)
  {
    if (argc > 1 && std::strcmp(argv[1], command.Word) == 0)
    {
      return command.Run(argc, argv);
    }
  }
  if (IsSlicerCall(argc, argv))
  {
    return RunSlicerCall(argc, argv);
  }
  if (argc > 1 && std::strcmp(argv[1], "thesis") != 0)
  {
    RequireCommandOrFile(argv[1]); // before options of a misspelled command are called unknown
  }
  const std::optional<Arguments> arguments = ParseArguments(argc, argv);
  if (!arguments)
  {
    return ExitCode::Done;
  }
  CheckArguments(*arguments);
  if (IsBatch(*arguments))
  {
    return RunBatch(*arguments, argv[0]);
  }
  RunOne(*arguments);
  return ExitCode::Done;
}
}

ExitCode RunProgram(int argc, char* argv[])
{
  CatchSignals();
  CollectVtkMessages();
  try
  {
    const ExitCode code = Run(argc, argv);
    const bool told = static_cast<bool>(std::cout.flush());
    return told ? code : Fail(ExitCode::CouldNotWrite, "could not write to the standard output");
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
}
}
