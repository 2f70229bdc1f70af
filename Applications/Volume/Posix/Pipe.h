// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pipe.h
 * @brief From a child process to its parent.
 */
#ifndef BoneDecimate_Applications_Pipe_h
#define BoneDecimate_Applications_Pipe_h

#include <array>
#include <cstddef>
#include <string>

namespace bonedecimate::volume
{
/// Called several times a second while Receive() waits; what it throws ends the waiting. Null:
/// nothing is called.
void SetCheckWhileWaiting(void (*check)());
void CheckWhileWaiting();

/// After the fork each side closes what it does not use. All calls are false once the other side is
/// gone.
class Pipe
{
public:
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  bool IsOpen() const;
  void CloseSender();
  void CloseReceiver();

  bool Send(const void* bytes, std::size_t count);
  bool Receive(void* bytes, std::size_t count);
  bool SendText(const std::string& text);
  bool ReceiveText(std::string& text);

private:
  void Close(std::size_t end);

  std::array<int, 2> Ends{ { -1, -1 } }; ///< Receiver and sender.
};
}

#endif
