// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Specimen.h
 * @brief Bones of any size for the growth of time and memory: bumpy walls, spongy inside, several
 * pieces.
 *
 * The resolution is that of a scan and the specimen grows, as when more of the body is scanned; a
 * finer grid over the same shape would only make it smoother. The same bytes on every system.
 */
#ifndef BoneDecimate_Testing_Specimen_h
#define BoneDecimate_Testing_Specimen_h

constexpr double SpecimenSpacing = 0.5; ///< mm between voxels.

/// Writes size^3 values, x fastest: negative in the bone, about a voxel per unit near its surface.
void FillSpecimen(int size, float* values);

#endif
