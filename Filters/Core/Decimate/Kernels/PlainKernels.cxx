// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#define BONEDECIMATE_KERNELS PlainKernels
#define BONEDECIMATE_KERNELS_NAME "plain"
#define BONEDECIMATE_PLAIN_LANES
#include "KernelSet.h"
