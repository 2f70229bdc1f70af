// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#define BONEDECIMATE_KERNELS Avx2Kernels
#define BONEDECIMATE_KERNELS_NAME "AVX2"
#include "KernelSet.h"
