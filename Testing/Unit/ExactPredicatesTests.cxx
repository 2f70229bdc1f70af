// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Signs of orientation determinants, held against integers of 1,024 bits: random points, and points
// made to lie in or next to the plane of others.
#include "Geometry/ExactPredicates.h"
#include "Geometry/Expansion.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// An integer of 1,024 bits in two's complement.
class Wide
{
public:
  Wide() = default;

  /// value * 2^Shift, which must be an integer.
  explicit Wide(double value)
  {
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent);
    auto digits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    int shift = exponent - 53 + Shift;
    for (; shift < 0 && digits != 0; ++shift)
    {
      EXPECT_EQ(digits & 1U, 0U) << value;
      digits >>= 1U;
    }
    for (std::size_t bit = 0; bit < 64; ++bit)
    {
      if (((digits >> bit) & 1U) != 0)
      {
        const std::size_t at = bit + static_cast<std::size_t>(shift);
        this->Limbs[at / 32] |= 1U << (at % 32);
      }
    }
    *this = value < 0.0 ? Wide() - *this : *this;
  }

  Wide operator+(const Wide& other) const
  {
    Wide sum;
    std::uint64_t carried = 0;
    for (std::size_t i = 0; i < Size; ++i)
    {
      carried += static_cast<std::uint64_t>(this->Limbs[i]) + other.Limbs[i];
      sum.Limbs[i] = static_cast<std::uint32_t>(carried);
      carried >>= 32U;
    }
    return sum;
  }

  Wide operator-(const Wide& other) const
  {
    Wide negative;
    for (std::size_t i = 0; i < Size; ++i)
    {
      negative.Limbs[i] = ~other.Limbs[i];
    }
    Wide one;
    one.Limbs[0] = 1;
    return *this + negative + one;
  }

  Wide operator*(const Wide& other) const
  {
    Wide product;
    for (std::size_t i = 0; i < Size; ++i)
    {
      std::uint64_t carried = 0;
      for (std::size_t j = 0; i + j < Size; ++j)
      {
        carried +=
          static_cast<std::uint64_t>(this->Limbs[i]) * other.Limbs[j] + product.Limbs[i + j];
        product.Limbs[i + j] = static_cast<std::uint32_t>(carried);
        carried >>= 32U;
      }
    }
    return product;
  }

  int Sign() const
  {
    if ((this->Limbs[Size - 1] >> 31U) != 0)
    {
      return -1;
    }
    return this->Limbs == Wide().Limbs ? 0 : 1;
  }

private:
  static constexpr std::size_t Size = 32;
  static constexpr int Shift = 200;
  std::array<std::uint32_t, Size> Limbs = {};
};

using WideVector = std::array<Wide, 3>;

WideVector Difference(const Vector3& a, const Vector3& b)
{
  return { Wide(a[0]) - Wide(b[0]), Wide(a[1]) - Wide(b[1]), Wide(a[2]) - Wide(b[2]) };
}

Wide CrossAlong(const WideVector& u, const WideVector& v, std::size_t axis)
{
  const std::size_t x = (axis + 1) % 3;
  const std::size_t y = (axis + 2) % 3;
  return u[x] * v[y] - u[y] * v[x];
}

int TrueOrientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const WideVector u = Difference(b, a);
  const WideVector v = Difference(c, a);
  const WideVector w = Difference(d, a);
  Wide sum;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    sum = sum + CrossAlong(u, v, axis) * w[axis];
  }
  return sum.Sign();
}

int TrueProjection(const Vector3& a, const Vector3& b, const Vector3& c, std::size_t axis)
{
  return CrossAlong(Difference(b, a), Difference(c, a), axis).Sign();
}

/// The next double upwards or downwards, so many times.
Vector3 Nudged(Vector3 p, Random& random, int most)
{
  for (double& x : p)
  {
    const int steps = random.Below(2 * most + 1) - most;
    for (int i = 0; i < std::abs(steps); ++i)
    {
      x = std::nextafter(x, steps < 0 ? -10.0 * std::abs(x) - 1.0 : 10.0 * std::abs(x) + 1.0);
    }
  }
  return p;
}

using Points = std::array<Vector3, 4>;

/// Random points, the last one moved into or next to the plane of the others.
Points NearOnePlane(Random& random)
{
  Points p;
  const double scale = std::ldexp(1.0, random.Below(40) - 20);
  const Vector3 offset = random.Below(2) == 0 ? Vector3::Zero() : random.InCube(1000.0 * scale);
  for (Vector3& point : p)
  {
    point = offset + random.InCube(scale);
  }
  p[3] =
    p[0] + random.Between(-1.0, 2.0) * (p[1] - p[0]) + random.Between(-1.0, 2.0) * (p[2] - p[0]);
  p[3] = Nudged(p[3], random, 2);
  return p;
}

/// Points of a small lattice, at any scale: often exactly in one plane, along all diagonals.
Points OnLattice(Random& random)
{
  Points p;
  const double scale = random.Below(2) == 0 ? 1.0 : 0.957031; // rounded when it is multiplied
  const Vector3 offset = random.Below(2) == 0 ? Vector3::Zero() : random.InCube(100.0);
  for (Vector3& point : p)
  {
    const Vector3 at(random.Below(5), random.Below(5), random.Below(5));
    point = offset + scale * at;
    if (random.Below(2) == 0)
    {
      point = point.unaryExpr([](double x) { return static_cast<double>(static_cast<float>(x)); });
    }
  }
  return p;
}

void ExpectTrueSigns(const Points& p, std::array<int, 3>& found)
{
  const int expected = TrueOrientation(p[0], p[1], p[2], p[3]);
  ASSERT_EQ(Orientation(p[0], p[1], p[2], p[3]), expected);
  ASSERT_EQ(Orientation(p[1], p[0], p[2], p[3]), -expected);
  ASSERT_EQ(Orientation(p[3], p[2], p[1], p[0]), expected);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int projected = TrueProjection(p[0], p[1], p[3], axis);
    ASSERT_EQ(ProjectedOrientation(p[0], p[1], p[3], static_cast<Eigen::Index>(axis)), projected);
  }
  ++found[static_cast<std::size_t>(expected + 1)];
}
}

TEST(Expansion, KeepsWhatRoundingTakes)
{
  Random random(5);
  for (int round = 0; round < 20000; ++round)
  {
    const double a = std::ldexp(random.Between(-1.0, 1.0), random.Below(60) - 30);
    const double b = std::ldexp(random.Between(-1.0, 1.0), random.Below(60) - 30);
    const ExactPair sum = ExactSum(a, b);
    const ExactPair product = ExactProduct(a, b);
    ASSERT_EQ((Wide(a) + Wide(b) - Wide(sum.Head) - Wide(sum.Tail)).Sign(), 0);
    ASSERT_EQ(
      (Wide(a) * Wide(b) - Wide(1.0) * (Wide(product.Head) + Wide(product.Tail))).Sign(), 0);
  }
}

TEST(Expansion, HasTheSignOfTheWholeSum)
{
  Random random(6);
  for (int round = 0; round < 5000; ++round)
  {
    Expansion<40> sum;
    Wide expected;
    std::array<double, 20> terms{};
    for (double& term : terms)
    {
      term = std::ldexp(random.Between(-1.0, 1.0), random.Below(120) - 60);
      sum.Add(term);
      expected = expected + Wide(term);
      ASSERT_EQ(sum.Sign(), expected.Sign());
    }
    for (std::size_t i = terms.size(); i > 0; --i)
    {
      sum.Add(-terms[i - 1]);
      expected = expected - Wide(terms[i - 1]);
      ASSERT_EQ(sum.Sign(), expected.Sign());
    }
    ASSERT_EQ(sum.Sign(), 0);
  }
}

TEST(ExactPredicates, HaveTheTrueSignNextToAPlane)
{
  Random random(7);
  std::array<int, 3> found{};
  for (int round = 0; round < 20000; ++round)
  {
    ASSERT_NO_FATAL_FAILURE(ExpectTrueSigns(NearOnePlane(random), found)) << round;
  }
  EXPECT_GT(found[0], 5000);
  EXPECT_GT(found[2], 5000);
}

TEST(ExactPredicates, HaveTheTrueSignOnALattice)
{
  Random random(8);
  std::array<int, 3> found{};
  for (int round = 0; round < 20000; ++round)
  {
    ASSERT_NO_FATAL_FAILURE(ExpectTrueSigns(OnLattice(random), found)) << round;
  }
  EXPECT_GT(found[1], 1000); // exactly in one plane
}

TEST(ExactPredicates, HaveTheTrueSignForPointsAtEveryScale)
{
  Random random(9);
  std::array<int, 3> found{};
  for (int round = 0; round < 20000; ++round)
  {
    Points p;
    for (Vector3& point : p)
    {
      for (double& x : point)
      {
        x =
          random.Below(4) == 0 ? 0.0 : std::ldexp(random.Between(-1.0, 1.0), random.Below(80) - 60);
      }
    }
    p[3] = random.Below(3) == 0 ? p[random.Below(3)] : p[3];
    ASSERT_NO_FATAL_FAILURE(ExpectTrueSigns(p, found)) << round;
  }
}

/// A point moved through a plane double by double, as in L. Kettner et al., Classroom examples of
/// robustness problems, 2008.
TEST(ExactPredicates, ChangeTheirSignWhereThePlaneIs)
{
  const Vector3 a(12.0, 12.0, 12.0);
  const Vector3 b(24.0, 24.0, 12.0);
  const Vector3 c(12.0, 12.0, 30.0);
  const double unit = std::numeric_limits<double>::epsilon() / 2.0;
  for (int i = 0; i < 64; ++i)
  {
    for (int j = 0; j < 64; ++j)
    {
      const Vector3 p(0.5 + i * unit, 0.5 + j * unit, 1.0 / 3.0);
      ASSERT_EQ(Orientation(a, b, c, p), i > j ? 1 : i < j ? -1 : 0);
      ASSERT_EQ(ProjectedOrientation(a, b, p, 2), i > j ? -1 : i < j ? 1 : 0);
    }
  }
}
