// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Meter.h
 * @brief Seconds and memory of one call, printed as the JSON that every contestant's process
 * prints.
 */
#ifndef BoneDecimate_Testing_Meter_h
#define BoneDecimate_Testing_Meter_h

#include <chrono>
#include <cstdint>
#include <ctime>

class Meter
{
public:
  /// Before the input is read: what the program itself holds.
  Meter();
  /// The input is in the contestant's own structure; the call comes next.
  void Start();
  /// The call has returned.
  void Stop();

  /// "seconds": ..., without braces. cpu_seconds sums over all threads; input_bytes is what holding
  /// the input costs, peak_bytes the most beyond that while the call ran.
  void Print() const;

private:
  std::int64_t Program;
  std::int64_t WithInput = 0;
  std::int64_t Most = 0;
  std::chrono::steady_clock::time_point Begin;
  std::clock_t ProcessorBegin = 0;
  double Seconds = 0.0;
  double ProcessorSeconds = 0.0;
};

#endif
