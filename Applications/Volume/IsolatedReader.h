// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IsolatedReader.h
 * @brief Reading in a child process, for libraries that do not survive every damaged file.
 *
 * VTK's XML reader follows null pointers, Debian's GDCM stops on assertions, and ITK's libraries
 * trust what a header announces. All write to the terminal, at times with pieces of the header in
 * it.
 *
 * The child sends layer after layer through a pipe and waits while they are not taken. Windows has
 * no child that goes on where its parent is: there the process reads itself, and a file that a
 * library does not survive ends it.
 */
#ifndef BoneDecimate_Applications_IsolatedReader_h
#define BoneDecimate_Applications_IsolatedReader_h

#include "Layers/LayeredVolume.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace bonedecimate::volume
{
/**
 * From now on a child that keeps its reader waiting ends as soon as this function throws.
 * @param stopIfInterrupted Called several times a second; throws if the user or the system
 *   interrupted the program.
 */
void StopReadingBy(void (*stopIfInterrupted)());

class IsolatedReader
{
public:
  /**
   * Opens the volume in the child. If it does not return, the header says that the file is damaged.
   * Nothing it writes to the terminal is seen.
   * @throws std::bad_alloc if the child has too little memory.
   */
  explicit IsolatedReader(const std::function<LayeredVolume()>& open);

  /// Makes a reader without a child, for a file that is rejected before it is opened.
  explicit IsolatedReader(const std::string& problem);

  ~IsolatedReader();
  IsolatedReader(const IsolatedReader&) = delete;
  IsolatedReader& operator=(const IsolatedReader&) = delete;

  const VolumeHeader& GetHeader() const { return this->Header; }

  /**
   * Writes the next layers.
   * @return What went wrong, or an empty text.  @throws std::bad_alloc as the constructor.
   */
  std::string ReadLayers(std::int64_t count, void* values);

private:
  struct Source;
  std::unique_ptr<Source> From;
  VolumeHeader Header;
};
}

#endif
