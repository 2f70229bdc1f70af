// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Listener.h
 * @brief A run that lets other Python threads go on, tells a Python function its progress and hears
 * Ctrl-C.
 *
 *     without the interpreter's lock:  run(monitor)
 *     monitor, with the lock:  a signal came, the function raised, or it returned False -> stop
 *     afterwards, with the lock:  what was raised is raised on
 *
 * Nothing is thrown through the core, which throws only std::bad_alloc.
 */
#ifndef BoneDecimate_Wheel_Listener_h
#define BoneDecimate_Wheel_Listener_h

#include "Base/Monitor.h"

#include <nanobind/nanobind.h>

#include <exception>

namespace bonedecimate
{
class Listener
{
public:
  /// @param function f(fraction), or None.
  explicit Listener(nanobind::object function)
    : Function(std::move(function))
  {
  }

  /// What run(monitor) returns. Calls the function on this thread only.
  template <typename Run>
  auto Hear(const Run& run)
  {
    const auto unlocked = [&]
    {
      const nanobind::gil_scoped_release release;
      return run(Monitor([this](double fraction) { return this->ShouldContinue(fraction); }));
    };
    auto result = unlocked();
    if (this->Raised)
    {
      std::rethrow_exception(this->Raised);
    }
    return result;
  }

private:
  bool ShouldContinue(double fraction)
  {
    const nanobind::gil_scoped_acquire acquire;
    if (this->Raised)
    {
      return false;
    }
    try
    {
      if (PyErr_CheckSignals() != 0)
      {
        throw nanobind::python_error();
      }
      return this->Function.is_none() || !this->Function(fraction).is(nanobind::handle(Py_False));
    }
    catch (const std::exception&)
    {
      this->Raised = std::current_exception();
      return false;
    }
  }

  nanobind::object Function;
  std::exception_ptr Raised;
};
}

#endif
