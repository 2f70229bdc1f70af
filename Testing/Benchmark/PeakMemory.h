// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BoneDecimate_Testing_PeakMemory_h
#define BoneDecimate_Testing_PeakMemory_h

/// The most memory this process held since the object was made, beyond what it held then. Linux only; else 0.
class PeakMemory
{
public:
  PeakMemory();
  double Megabytes() const;

private:
  double AtFirst = 0.0;
};

#endif
