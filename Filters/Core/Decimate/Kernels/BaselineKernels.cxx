// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#define BONEDECIMATE_KERNELS BaselineKernels
#define BONEDECIMATE_KERNELS_NAME "baseline"
#include "KernelSet.h"
