// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WorkspacePool.h
 * @brief Lends workspaces to workers. Returned workspaces are lent again, because each takes memory
 * in proportion to the mesh.
 */
#ifndef BoneDecimate_Core_Base_WorkspacePool_h
#define BoneDecimate_Core_Base_WorkspacePool_h

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace bonedecimate
{
template <typename Workspace>
class WorkspacePool
{
public:
  /// Lends a workspace to one worker; any thread may call this. The workspace returns to the pool
  /// when it is released, which must be before the pool is destroyed.
  /// @param make Returns a std::unique_ptr to a new workspace.
  template <typename Make>
  std::shared_ptr<Workspace> Borrow(const Make& make)
  {
    std::unique_ptr<Workspace> workspace = this->TakeIdle();
    if (workspace == nullptr)
    {
      workspace = make();
    }
    return std::shared_ptr<Workspace>(
      workspace.release(), [this](Workspace* returned) { this->Return(returned); });
  }

  /// Frees the workspaces that have been returned.
  void Clear()
  {
    const std::lock_guard<std::mutex> lock(this->Lending);
    this->Idle.clear();
  }

private:
  std::unique_ptr<Workspace> TakeIdle()
  {
    const std::lock_guard<std::mutex> lock(this->Lending);
    if (this->Idle.empty())
    {
      return nullptr;
    }
    std::unique_ptr<Workspace> workspace = std::move(this->Idle.back());
    this->Idle.pop_back();
    return workspace;
  }

  void Return(Workspace* returned)
  {
    const std::lock_guard<std::mutex> lock(this->Lending);
    this->Idle.emplace_back(returned);
  }

  std::mutex Lending;
  std::vector<std::unique_ptr<Workspace>> Idle;
};
}

#endif
