// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeEvaluator.h
 * @brief Positions and costs of up to eight edges by the policies of a sweep: by a vector kernel if
 * there is one for these policies, otherwise one edge after the other.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_EdgeEvaluator_h
#define BoneDecimate_Core_Decimate_Kernels_EdgeEvaluator_h

#include "Kernels.h"
#include "Options/Modes.h"

namespace bonedecimate
{
class EdgeEvaluator
{
public:
  explicit EdgeEvaluator(const SweepPolicies& policies);

  void operator()(const EdgeBatch& batch, EdgeResults& results) const;
  bool HasKernel() const { return this->Kernel != nullptr; }

private:
  SweepPolicies Policies;
  void (*Kernel)(const EdgeBatch& batch, EdgeResults& results) = nullptr;
};
}

#endif
