// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meter.h"

#include "PeakMemory.h"

#include <cstdio>

Meter::Meter()
  : Program(memory::Held())
{
}

void Meter::Start()
{
  this->WithInput = memory::Held();
  memory::ForgetPeak();
  this->ProcessorBegin = std::clock();
  this->Begin = std::chrono::steady_clock::now();
}

void Meter::Stop()
{
  const auto end = std::chrono::steady_clock::now();
  this->Seconds = std::chrono::duration<double>(end - this->Begin).count();
  this->ProcessorSeconds =
    static_cast<double>(std::clock() - this->ProcessorBegin) / CLOCKS_PER_SEC;
  this->Most = memory::Peak();
}

void Meter::Print() const
{
  std::printf(
    "\"seconds\": %.6f, \"cpu_seconds\": %.6f, \"input_bytes\": %lld, \"peak_bytes\": %lld",
    this->Seconds, this->ProcessorSeconds, static_cast<long long>(this->WithInput - this->Program),
    static_cast<long long>(this->Most - this->WithInput));
}
