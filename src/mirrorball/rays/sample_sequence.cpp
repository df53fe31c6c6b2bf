#include "mirrorball/rays/sample_sequence.h"

namespace mirrorball {
namespace {

std::uint32_t reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

/// A number that looks random, from two (the finalizer of MurmurHash3 by A. Appleby).
std::uint32_t hashed(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a ^ (b * 0x9e3779b9u + 0x7f4a7c15u);
  x = (x ^ (x >> 16)) * 0x85ebca6bu;
  x = (x ^ (x >> 13)) * 0xc2b2ae35u;
  return x ^ (x >> 16);
}

/// Owen's scrambling of a number whose digits are reversed: each digit is flipped or not as all digits that are above
/// it in the number, and the seed, say. The permutation of Laine & Karras 2011, in which a digit changes only those
/// above it, with the constants of Vegdahl 2021 ("Building a better LK hash").
std::uint32_t scrambledReversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// The second dimension of Sobol's sequence, its digits reversed; the first one is the index itself. Its matrix is
/// Pascal's triangle modulo 2: digit i is the sum of the index's digits j for which C(j, i) is odd, which are those
/// whose number j has all bits of i (Lucas); and sums over such sets are made bit by bit.
std::uint32_t sobolSecondReversed(std::uint32_t index) {
  std::uint32_t x = index;
  x ^= x >> 16;
  x ^= (x >> 8) & 0x00ff00ffu;
  x ^= (x >> 4) & 0x0f0f0f0fu;
  x ^= (x >> 2) & 0x33333333u;
  x ^= (x >> 1) & 0x55555555u;
  return x;
}

/// Below 1, also where rounding would make it 1.
float unitFloat(std::uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24f; }

}  // namespace

SampleSequence::SampleSequence(std::uint32_t pixel, std::uint32_t index)
    : seed_(pixel), index_(index), reversed_index_(reversed(index)) {}

glm::vec2 SampleSequence::next() {
  const std::uint32_t seed = hashed(seed_, pair_++);
  // Scrambled as a number, the first 2ⁿ indices become a block of 2ⁿ that follow each other, in another order.
  const std::uint32_t index = reversed(scrambledReversed(reversed_index_, seed));
  const std::uint32_t x = scrambledReversed(index, hashed(seed, 1));
  const std::uint32_t y = scrambledReversed(sobolSecondReversed(index), hashed(seed, 2));
  return {unitFloat(reversed(x)), unitFloat(reversed(y))};
}

float SampleSequence::nextIndependent() {
  if (random_ == 0) random_ = std::uint64_t(hashed(seed_, 0x51ed270bu)) << 32 | hashed(index_, seed_);
  // SplitMix64 (Steele, Lea & Flood 2014).
  std::uint64_t z = random_ += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return unitFloat(static_cast<std::uint32_t>((z ^ (z >> 31)) >> 32));
}

}  // namespace mirrorball
