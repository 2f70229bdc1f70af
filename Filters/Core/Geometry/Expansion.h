// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Expansion.h
 * @brief A real number as a sum of nonoverlapping nonzero doubles, smallest first. Additions are
 * exact.
 *
 *     a + b = head + tail     two doubles, exact (Knuth)
 *     a * b = head + tail     the same, by halves of 26 bits (Dekker, Veltkamp)
 *
 * The sign of the number is the sign of its largest part.
 */
#ifndef BoneDecimate_Core_Geometry_Expansion_h
#define BoneDecimate_Core_Geometry_Expansion_h

#include <array>
#include <cstddef>

namespace bonedecimate
{
/// A rounded result and its rounding error.
struct ExactPair
{
  double Head;
  double Tail;
};

inline ExactPair ExactSum(double a, double b)
{
  const double sum = a + b;
  const double ofB = sum - a;
  const double ofA = sum - ofB;
  return { sum, (a - ofA) + (b - ofB) };
}

inline ExactPair ExactDifference(double a, double b)
{
  return ExactSum(a, -b);
}

inline ExactPair ExactHalves(double a)
{
  const double shifted = 134217729.0 * a; // 2^27 + 1
  const double high = shifted - (shifted - a);
  return { high, a - high };
}

inline ExactPair ExactProduct(double a, double b)
{
  const double product = a * b;
  const ExactPair x = ExactHalves(a);
  const ExactPair y = ExactHalves(b);
  const double missing = ((product - x.Head * y.Head) - x.Tail * y.Head) - x.Head * y.Tail;
  return { product, x.Tail * y.Tail - missing };
}

/// @tparam Capacity Maximum number of parts.
template <std::size_t Capacity>
class Expansion
{
public:
  /// Shewchuk's Grow-Expansion with elimination of zeros.
  void Add(double term)
  {
    double carried = term;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const ExactPair sum = ExactSum(carried, this->Parts[i]);
      carried = sum.Head;
      this->Parts[kept] = sum.Tail;
      kept += sum.Tail != 0.0 ? 1 : 0;
    }
    this->Count = kept;
    if (carried != 0.0)
    {
      this->Parts[this->Count++] = carried;
    }
  }

  void AddProduct(double a, double b)
  {
    const ExactPair product = ExactProduct(a, b);
    if (product.Tail != 0.0)
    {
      this->Add(product.Tail);
    }
    if (product.Head != 0.0)
    {
      this->Add(product.Head);
    }
  }

  int Sign() const { return this->Count == 0 ? 0 : this->Parts[this->Count - 1] > 0.0 ? 1 : -1; }

private:
  std::array<double, Capacity> Parts; // not initialized: only the first Count are read
  std::size_t Count = 0;
};
}

#endif
