#pragma once

namespace mirrorball {

/// The value of another type that has the same bits: std::bit_cast, which the standard library of compilers for
/// browsers (libc++ 14) lacks. The compilers themselves have it.
template <typename To, typename From>
constexpr To bitCast(const From& value) {
  return __builtin_bit_cast(To, value);
}

}  // namespace mirrorball
