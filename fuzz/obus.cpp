#include "obus.h"

#include <algorithm>
#include <utility>

#include "chance.h"

namespace mirrorball::fuzz {
namespace {

constexpr std::uint8_t kHasExtension = 4, kHasSize = 2;
constexpr unsigned kTileGroup = 4, kMetadata = 5, kFrame = 6, kPadding = 15;  // obu_type

/// A number of seven bits a byte, the lowest first: leb128() of the specification.
void appendLeb128(Bytes& bytes, std::size_t number) {
  for (; number >= 0x80; number >>= 7) bytes.push_back(static_cast<std::uint8_t>(number | 0x80));
  bytes.push_back(static_cast<std::uint8_t>(number));
}

/// Takes the number off the beginning of the bytes.
std::optional<std::size_t> takeLeb128(std::span<const std::uint8_t>& bytes) {
  std::size_t number = 0;
  for (unsigned i = 0; i < 8 && i < bytes.size(); ++i) {
    number |= std::size_t{bytes[i] & 0x7fu} << 7 * i;
    if (bytes[i] >= 0x80) continue;
    bytes = bytes.subspan(i + 1);
    return number;
  }
  return std::nullopt;
}

Obu madeObu(unsigned type, Bytes payload) {
  return {{static_cast<std::uint8_t>(type << 3 | kHasSize)}, std::move(payload)};
}

/// Metadata of one of the kinds that there are, of light levels, of the master's colours, of layers, ITU-T T.35, or of
/// a kind that there is not.
Obu anyMetadata(std::mt19937& random) {
  Bytes payload{static_cast<std::uint8_t>(below(7, random))};
  for (std::size_t i = below(30, random); i > 0; --i) payload.push_back(static_cast<std::uint8_t>(random()));
  return madeObu(kMetadata, std::move(payload));
}

void changeUnits(std::vector<Obu>& obus, std::mt19937& random) {
  const auto place = obus.begin() + static_cast<std::ptrdiff_t>(below(obus.size(), random));
  switch (below(6, random)) {
    case 0:
      obus.insert(place, anyMetadata(random));
      break;
    case 1:
      obus.insert(place, madeObu(kPadding, Bytes(below(20, random), 0x80)));
      break;
    case 2:
      obus.insert(place, Obu(*place));
      break;
    case 3:
      obus.erase(place);
      break;
    case 4:
      std::swap(*place, obus.front());
      break;
    default:
      place->header.front() ^= static_cast<std::uint8_t>(8u << below(4, random));  // another type
  }
}

/// Changes a frame's texels, which are behind a header of some ten bytes, or now and then the header.
void changeFrame(Bytes& payload, std::mt19937& random) {
  constexpr std::size_t kHeader = 12;
  const std::size_t texels = std::min(kHeader, payload.size() / 2);
  changeBytes(payload, onceIn(8, random) ? 0 : texels, random);
}

}  // namespace

std::optional<std::vector<Obu>> obusIn(std::span<const std::uint8_t> data) {
  std::vector<Obu> obus;
  while (!data.empty()) {
    const std::uint8_t flags = data.front();
    const std::size_t header = (flags & kHasExtension) != 0 ? 2 : 1;
    if (data.size() < header) return std::nullopt;
    Obu obu{Bytes(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(header)), {}};
    data = data.subspan(header);
    const auto size = (flags & kHasSize) != 0 ? takeLeb128(data) : data.size();
    if (!size || *size > data.size()) return std::nullopt;
    obu.payload.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(*size));
    obus.push_back(std::move(obu));
    data = data.subspan(*size);
  }
  return obus;
}

Bytes bytesOfObus(const std::vector<Obu>& obus) {
  Bytes bytes;
  for (const Obu& obu : obus) {
    bytes.insert(bytes.end(), obu.header.begin(), obu.header.end());
    if ((obu.header.front() & kHasSize) != 0) appendLeb128(bytes, obu.payload.size());
    bytes.insert(bytes.end(), obu.payload.begin(), obu.payload.end());
  }
  return bytes;
}

void changeAv1(Bytes& data, std::mt19937& random) {
  auto obus = obusIn(data);
  if (!obus || obus->empty()) {
    changeBytes(data, 0, random);
    return;
  }
  Obu& obu = oneIn(*obus, random);
  const bool has_texels = obu.type() == kFrame || obu.type() == kTileGroup;
  if (onceIn(8, random))
    changeUnits(*obus, random);
  else if (has_texels)
    changeFrame(obu.payload, random);
  else if (!obu.payload.empty() && onceIn(2, random))
    changeBytes(obu.payload, 0, random);
  else
    changeFrame(std::ranges::max_element(*obus, {}, [](const Obu& one) { return one.payload.size(); })->payload,
                random);
  data = bytesOfObus(*obus);
}

}  // namespace mirrorball::fuzz
