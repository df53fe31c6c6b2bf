#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

#include "mirrorball/base/file.h"

namespace mirrorball::fuzz {

/// From 0 on, below `end`; the same for every standard library, as its distributions are not.
inline std::size_t below(std::size_t end, std::mt19937& random) { return random() % end; }

/// One of these values, each as likely.
template <typename Value, std::size_t kCount>
const Value& pick(const Value (&values)[kCount], std::mt19937& random) {
  return values[below(kCount, random)];
}

/// One of a list that has some.
template <typename List>
auto& oneIn(List& list, std::mt19937& random) {
  return list[below(list.size(), random)];
}

/// True once in so many calls.
inline bool onceIn(std::size_t calls, std::mt19937& random) { return below(calls, random) == 0; }

/// Makes one change to the bytes behind the first `kept`: a bit or a byte is another one, some are inserted, taken out
/// or copied. Where there are none, one is appended.
inline void changeBytes(Bytes& bytes, std::size_t kept, std::mt19937& random) {
  if (bytes.size() <= kept) {
    bytes.push_back(static_cast<std::uint8_t>(random()));
    return;
  }
  constexpr std::size_t kMost = 4;  // bytes that come or go
  const std::size_t at = kept + below(bytes.size() - kept, random);
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  const auto count = static_cast<std::ptrdiff_t>(std::min(1 + below(kMost, random), bytes.size() - at));
  switch (below(8, random)) {
    case 0:
      *place = static_cast<std::uint8_t>(random());
      break;
    case 1:
      *place = pick<std::uint8_t>({0, 1, 0x7f, 0x80, 0xff}, random);
      break;
    case 2:
      bytes.insert(place, static_cast<std::size_t>(count), static_cast<std::uint8_t>(random()));
      break;
    case 3:
      bytes.erase(place, place + count);
      break;
    case 4: {
      const Bytes copy(place, place + count);
      const std::size_t to = kept + below(bytes.size() - kept, random);
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(to), copy.begin(), copy.end());
      break;
    }
    default:
      *place ^= static_cast<std::uint8_t>(1u << below(8, random));
  }
}

}  // namespace mirrorball::fuzz
