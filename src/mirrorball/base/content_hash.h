#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

struct XXH3_state_s;

namespace mirrorball {

/// The 128 bits of XXH3 (Collet) for what it is given, one after the other: what has the same has the same content, but
/// for whoever makes two alike on purpose.
class ContentHash {
 public:
  static constexpr std::size_t kDigits = 32;

  /// seed     another one, another hash of the same
  explicit ContentHash(std::uint64_t seed = 0);

  /// values   whose types have no bytes between their members
  template <typename Value>
  void addAll(std::span<const Value> values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    addBytes(std::as_bytes(values));
  }
  template <typename Value>
  void add(const Value& value) {
    addAll(std::span<const Value>(&value, 1));
  }
  void addBytes(std::span<const std::byte> bytes);

  /// Of all so far: kDigits hexadecimal digits.
  std::string digits() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

}  // namespace mirrorball
