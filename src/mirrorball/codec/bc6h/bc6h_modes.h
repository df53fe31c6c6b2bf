#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mirrorball/codec/half_blocks/block_bits.h"

namespace mirrorball {

/// The tables of BC6H. From: Khronos Data Format Specification 1.3, section "BC6H" (the chapter on BPTC); the same in
/// Microsoft, "BC6H Format". bc6h_parity_test holds all of them to an OpenGL driver.

/// So many bits in a row of one of an endpoint's channels.
struct Bc6hRun {
  std::uint8_t channel = 0;  ///< 3 · endpoint + channel
  std::uint8_t low = 0;      ///< the lowest of the bits
  std::uint8_t count = 0;
};

/// How the bits of a block are shared out, the lowest first: code, endpoints, partition (5 bits where there are two
/// subsets), indices.
struct Bc6hMode {
  int code;
  int code_bits;
  int subsets;
  int bits;                   ///< of the first endpoint's channels, and the precision of all of them
  std::array<int, 3> deltas;  ///< bits of the other endpoints' channels
  bool is_delta;              ///< these are signed and relative to the first endpoint
  std::array<Bc6hRun, 26> runs{};
  std::size_t run_count = 0;

  /// layout  channels r g b of the endpoints w x (first subset) y z (second): "rw0-9" are the bits 0 to 9 of red of the
  ///         first endpoint, "rw11-10" two of them with the upper one first
  constexpr Bc6hMode(int mode_code, int mode_code_bits, int subset_count, int endpoint_bits,
                     std::array<int, 3> delta_bits, bool has_deltas, std::string_view layout)
      : code(mode_code),
        code_bits(mode_code_bits),
        subsets(subset_count),
        bits(endpoint_bits),
        deltas(delta_bits),
        is_delta(has_deltas) {
    while (!layout.empty()) {
      const std::size_t space = layout.find(' ');
      addRuns(layout.substr(0, space));
      layout = space == std::string_view::npos ? "" : layout.substr(space + 1);
    }
  }

  /// Bits of a channel (3 · endpoint + channel) as it stands in a block.
  constexpr int bitsOf(std::size_t channel) const { return channel < 3 ? bits : deltas[channel % 3]; }

 private:
  constexpr void addRuns(std::string_view word) {
    const auto channel =
        static_cast<std::uint8_t>(3 * std::string_view("wxyz").find(word[1]) + std::string_view("rgb").find(word[0]));
    const std::size_t dash = word.find('-');
    const int first = numberIn(word.substr(2, dash - 2));
    const int last = dash == std::string_view::npos ? first : numberIn(word.substr(dash + 1));
    if (first <= last)
      runs[run_count++] = {channel, static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(last - first + 1)};
    else
      for (int bit = first; bit >= last; --bit) runs[run_count++] = {channel, static_cast<std::uint8_t>(bit), 1};
  }
  static constexpr int numberIn(std::string_view digits) {
    int number = 0;
    for (const char digit : digits) number = 10 * number + (digit - '0');
    return number;
  }
};

/// The specification's modes 1 to 14.
inline constexpr std::array<Bc6hMode, 14> kBc6hModes{{
    {0x00,
     2,
     2,
     10,
     {5, 5, 5},
     true,
     "gy4 by4 bz4 rw0-9 gw0-9 bw0-9 rx0-4 gz4 gy0-3 gx0-4 bz0 gz0-3 bx0-4 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {0x01,
     2,
     2,
     7,
     {6, 6, 6},
     true,
     "gy5 gz4 gz5 rw0-6 bz0 bz1 by4 gw0-6 by5 bz2 gy4 bw0-6 bz3 bz5 bz4 rx0-5 gy0-3 gx0-5 gz0-3 bx0-5 by0-3 ry0-5 "
     "rz0-5"},
    {0x02,
     5,
     2,
     11,
     {5, 4, 4},
     true,
     "rw0-9 gw0-9 bw0-9 rx0-4 rw10 gy0-3 gx0-3 gw10 bz0 gz0-3 bx0-3 bw10 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {0x06,
     5,
     2,
     11,
     {4, 5, 4},
     true,
     "rw0-9 gw0-9 bw0-9 rx0-3 rw10 gz4 gy0-3 gx0-4 gw10 gz0-3 bx0-3 bw10 bz1 by0-3 ry0-3 bz0 bz2 rz0-3 gy4 bz3"},
    {0x0a,
     5,
     2,
     11,
     {4, 4, 5},
     true,
     "rw0-9 gw0-9 bw0-9 rx0-3 rw10 by4 gy0-3 gx0-3 gw10 bz0 gz0-3 bx0-4 bw10 by0-3 ry0-3 bz1 bz2 rz0-3 bz4 bz3"},
    {0x0e,
     5,
     2,
     9,
     {5, 5, 5},
     true,
     "rw0-8 by4 gw0-8 gy4 bw0-8 bz4 rx0-4 gz4 gy0-3 gx0-4 bz0 gz0-3 bx0-4 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {0x12,
     5,
     2,
     8,
     {6, 5, 5},
     true,
     "rw0-7 gz4 by4 gw0-7 bz2 gy4 bw0-7 bz3 bz4 rx0-5 gy0-3 gx0-4 bz0 gz0-3 bx0-4 bz1 by0-3 ry0-5 rz0-5"},
    {0x16,
     5,
     2,
     8,
     {5, 6, 5},
     true,
     "rw0-7 bz0 by4 gw0-7 gy5 gy4 bw0-7 gz5 bz4 rx0-4 gz4 gy0-3 gx0-5 gz0-3 bx0-4 bz1 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {0x1a,
     5,
     2,
     8,
     {5, 5, 6},
     true,
     "rw0-7 bz1 by4 gw0-7 by5 gy4 bw0-7 bz5 bz4 rx0-4 gz4 gy0-3 gx0-4 bz0 gz0-3 bx0-5 by0-3 ry0-4 bz2 rz0-4 bz3"},
    {0x1e,
     5,
     2,
     6,
     {6, 6, 6},
     false,
     "rw0-5 gz4 bz0 bz1 by4 gw0-5 gy5 by5 bz2 gy4 bw0-5 gz5 bz3 bz5 bz4 rx0-5 gy0-3 gx0-5 gz0-3 bx0-5 by0-3 ry0-5 "
     "rz0-5"},
    {0x03, 5, 1, 10, {10, 10, 10}, false, "rw0-9 gw0-9 bw0-9 rx0-9 gx0-9 bx0-9"},
    {0x07, 5, 1, 11, {9, 9, 9}, true, "rw0-9 gw0-9 bw0-9 rx0-8 rw10 gx0-8 gw10 bx0-8 bw10"},
    {0x0b, 5, 1, 12, {8, 8, 8}, true, "rw0-9 gw0-9 bw0-9 rx0-7 rw11-10 gx0-7 gw11-10 bx0-7 bw11-10"},
    {0x0f, 5, 1, 16, {4, 4, 4}, true, "rw0-9 gw0-9 bw0-9 rx0-3 rw15-10 gx0-3 gw15-10 bx0-3 bw15-10"},
}};

/// Every mode's runs hold each bit of each channel once.
constexpr bool bc6hLayoutsAreWhole() {
  for (const Bc6hMode& mode : kBc6hModes) {
    std::array<std::uint32_t, 12> seen{};
    for (std::size_t i = 0; i < mode.run_count; ++i)
      for (int bit = mode.runs[i].low; bit < mode.runs[i].low + mode.runs[i].count; ++bit) {
        if (seen[mode.runs[i].channel] >> bit & 1u) return false;
        seen[mode.runs[i].channel] |= 1u << bit;
      }
    for (std::size_t channel = 0; channel < 12; ++channel)
      if (seen[channel] != (channel < 6 * std::size_t(mode.subsets) ? (1u << mode.bitsOf(channel)) - 1u : 0u))
        return false;
  }
  return true;
}
static_assert(bc6hLayoutsAreWhole());

/// Which texels of a block belong to the second subset: bit x + 4 y.
inline constexpr std::array<std::uint16_t, 32> kBc6hPartitions{
    0xcccc, 0x8888, 0xeeee, 0xecc8, 0xc880, 0xfeec, 0xfec8, 0xec80, 0xc800, 0xffec, 0xfe80,
    0xe800, 0xffe8, 0xff00, 0xfff0, 0xf000, 0xf710, 0x008e, 0x7100, 0x08ce, 0x008c, 0x7310,
    0x3100, 0x8cce, 0x088c, 0x3110, 0x6666, 0x366c, 0x17e8, 0x0ff0, 0x718e, 0x399c};

/// The texel of the second subset whose index has one bit less; in the first subset, and where there is only one, it is
/// texel 0.
inline constexpr std::array<std::uint8_t, 32> kBc6hAnchors{
    15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 2, 8, 2, 2, 8, 8, 15, 2, 8, 2, 2, 8, 8, 2, 2};

/// The share of the second end in 64ths, of an index of 3 or 4 bits.
constexpr int bc6hWeight(int index, int index_bits) {
  const int last = (1 << index_bits) - 1;
  return (128 * index + last) / (2 * last);  // 64 · index / last, rounded: the specification's two tables
}
constexpr int bc6hIndexBits(int subsets) { return subsets == 2 ? 3 : 4; }

inline constexpr std::size_t kBc6hBlockSize = kHalfBlockSize;

}  // namespace mirrorball
