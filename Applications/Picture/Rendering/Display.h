// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Display.h
 * @brief Something to render on: the X display there is, or a virtual one of our own.
 */
#ifndef BoneDecimate_Applications_Display_h
#define BoneDecimate_Applications_Display_h

#include <memory>
#include <string>

namespace bonedecimate
{
/**
 * VTK before 9.4 renders through X alone and ends the whole program where it finds none, so this
 * has to be called first. If the environment's DISPLAY cannot be used, an Xvfb is started and
 * DISPLAY names it until the object goes. The Xvfb ends with the object, and also with the program
 * however that ends. Newer VTK chooses its window itself: there the object does nothing. Not to be
 * used by two threads at a time, for DISPLAY belongs to the process.
 */
class Display
{
public:
  enum class Choice
  {
    Any,        ///< The one there is, or a virtual one.
    VirtualOnly ///< Mesa renders the same picture on every machine: for image tests.
  };

  explicit Display(Choice choice = Choice::Any);
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// Why nothing can be rendered; empty if it can.
  const std::string& GetProblem() const { return this->Problem; }

private:
  struct Server;
  std::unique_ptr<Server> Used;
  std::string Problem;
};
}

#endif
