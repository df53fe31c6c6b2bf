#include "mirrorball/base/content_hash.h"

#include <cstdio>

#include <xxhash.h>

namespace mirrorball {

void ContentHash::Free::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

ContentHash::ContentHash(std::uint64_t seed) : state_(XXH3_createState()) {
  XXH3_128bits_reset_withSeed(state_.get(), seed);
}

void ContentHash::addBytes(std::span<const std::byte> bytes) {
  XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
}

std::string ContentHash::digits() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
  char digits[kDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return digits;
}

}  // namespace mirrorball
