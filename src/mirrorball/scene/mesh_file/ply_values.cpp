#include "mirrorball/scene/mesh_file/ply_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>
#include <utility>

namespace mirrorball {
namespace {

template <typename Value>
double valueAs(const std::uint8_t* raw) {
  Value value;
  std::memcpy(&value, raw, sizeof value);
  return static_cast<double>(value);
}

double decodeValue(PlyType type, const std::uint8_t* raw) {
  switch (type) {
    case PlyType::int8:
      return valueAs<std::int8_t>(raw);
    case PlyType::uint8:
      return valueAs<std::uint8_t>(raw);
    case PlyType::int16:
      return valueAs<std::int16_t>(raw);
    case PlyType::uint16:
      return valueAs<std::uint16_t>(raw);
    case PlyType::int32:
      return valueAs<std::int32_t>(raw);
    case PlyType::uint32:
      return valueAs<std::uint32_t>(raw);
    case PlyType::float32:
      return valueAs<float>(raw);
    case PlyType::float64:
      return valueAs<double>(raw);
  }
  return 0.0;
}

}  // namespace

PlyValues::PlyValues(std::span<const std::uint8_t> file, const PlyHeader& header)
    : body_(file.subspan(header.size)),
      encoding_(header.encoding),
      offset_(header.size),
      scanner_({reinterpret_cast<const char*>(body_.data()), body_.size()}) {}

std::optional<double> PlyValues::next(PlyType type) {
  if (encoding_ == PlyEncoding::ascii) {
    const std::string_view word = scanner_.word();
    if (word.empty()) return {};
    const NumberText number = numbers_.read(word, scanner_.line());
    return number.kind == NumberText::Kind::none ? std::nullopt : std::optional(number.value);
  }
  const std::size_t size = byteSize(type);
  if (size > body_.size() - at_) return {};
  std::array<std::uint8_t, 8> raw{};
  std::memcpy(raw.data(), body_.data() + at_, size);
  if ((encoding_ == PlyEncoding::big_endian) == (std::endian::native == std::endian::little))
    for (std::size_t i = 0; i < size / 2; ++i) std::swap(raw[i], raw[size - 1 - i]);
  at_ += size;
  return decodeValue(type, raw.data());
}

void PlyValues::passComments() {
  if (encoding_ != PlyEncoding::ascii) return;
  while (scanner_.peek() == 'c' || scanner_.peek() == 'o') {
    TextScanner behind = scanner_;
    const std::string_view word = behind.word();
    if (word != "comment" && word != "obj_info") return;
    behind.restOfLine();
    scanner_ = behind;
  }
}

std::size_t PlyValues::bytesBehind() const {
  const auto rest = body_.subspan(position());
  const auto isContent = [](std::uint8_t byte) { return byte != 0 && byte != ' ' && (byte < '\t' || byte > '\r'); };
  const auto first = std::find_if(rest.begin(), rest.end(), isContent);
  const auto last = std::find_if(rest.rbegin(), rest.rend(), isContent).base();
  return first < last ? static_cast<std::size_t>(last - first) : 0;
}

std::string PlyValues::place() const {
  return encoding_ == PlyEncoding::ascii ? "line " + std::to_string(scanner_.line()) + " of its data"
                                         : "byte " + std::to_string(offset_ + at_);
}

}  // namespace mirrorball
