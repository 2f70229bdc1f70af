// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#define BONEDECIMATE_KERNELS Avx512Kernels
#define BONEDECIMATE_KERNELS_NAME "AVX-512"
#include "KernelSet.h"
