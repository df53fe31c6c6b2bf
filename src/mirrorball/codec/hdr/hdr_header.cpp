#include "mirrorball/codec/hdr/hdr_header.h"

#include <cmath>
#include <string_view>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball {
namespace {

/// Walks over the header's lines; knows where it is, for messages.
class LineReader {
 public:
  explicit LineReader(std::span<const std::uint8_t> bytes)
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  /// The next line without its end; nothing when the file ends before the line does.
  std::optional<std::string_view> next() {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) return {};
    std::string_view line = text_.substr(at_, end - at_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at_ = end + 1;
    ++number_;
    return line;
  }

  std::size_t position() const { return at_; }

  tl::unexpected<Error> failure(ErrorCode code, const std::string& what) const {
    return fail(code, "line " + std::to_string(number_) + " " + what);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  int number_ = 0;
};

/// Numbers between blanks, exactly `count` of them.
std::optional<std::vector<double>> parseNumbers(std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : split(text, ' ')) {
    if (word.empty()) continue;
    const std::optional<double> number = parseNumber(word);
    if (!number) return {};
    numbers.push_back(*number);
  }
  if (numbers.size() != count) return {};
  return numbers;
}

/// EXPOSURE= and COLORCORR= tell what the texels have been multiplied by; several lines add up.
Result<void> applyExposure(std::string_view value, std::size_t count, const LineReader& reader, HdrHeader& header) {
  const auto numbers = parseNumbers(value, count);
  if (!numbers)
    return reader.failure(ErrorCode::bad_file, "should have " + counted(count, "number") + " behind its '='");
  for (int c = 0; c < 3; ++c) {
    const double factor = (*numbers)[count == 1 ? 0 : std::size_t(c)];
    const double product = static_cast<double>(header.exposure[c]) * factor;
    if (!(product > 1e-30 && product < 1e30))
      return reader.failure(ErrorCode::bad_file,
                            "makes the exposure " + formatNumber(product) + ", which cannot be divided out");
    header.exposure[c] = static_cast<float>(product);
  }
  return {};
}

Result<void> readVariable(std::string_view line, const LineReader& reader, HdrHeader& header) {
  const auto valueOf = [&](std::string_view key) -> std::optional<std::string_view> {
    if (!line.starts_with(key)) return {};
    return line.substr(key.size());
  };
  if (const auto comment = valueOf("# ")) {
    readMetadataLine(*comment, header.metadata);
  } else if (const auto format = valueOf("FORMAT=")) {
    header.xyz = *format == "32-bit_rle_xyze";
    if (!header.xyz && *format != "32-bit_rle_rgbe")
      return reader.failure(ErrorCode::unsupported, "names the format '" + excerpt(*format) +
                                                        "'; 32-bit_rle_rgbe and 32-bit_rle_xyze are read");
  } else if (const auto exposure = valueOf("EXPOSURE=")) {
    MIRRORBALL_TRY_VOID(applyExposure(*exposure, 1, reader, header));
  } else if (const auto correction = valueOf("COLORCORR=")) {
    MIRRORBALL_TRY_VOID(applyExposure(*correction, 3, reader, header));
  } else if (const auto primaries = valueOf("PRIMARIES=")) {
    const auto xy = parseNumbers(*primaries, 8);
    if (!xy) return reader.failure(ErrorCode::bad_file, "should have 8 numbers behind its '='");
    const auto at = [&](std::size_t i) { return glm::dvec2((*xy)[i], (*xy)[i + 1]); };
    header.primaries = Primaries{at(0), at(2), at(4), at(6)};
  }
  return {};
}

/// One half of the resolution line: "-Y" and "1024".
struct Axis {
  char name;
  bool descends;
  long long length;
};

std::optional<Axis> parseAxis(const std::string& sign_and_name, const std::string& length) {
  if (sign_and_name.size() != 2) return {};
  const char sign = sign_and_name[0];
  const char name = sign_and_name[1];
  if ((sign != '+' && sign != '-') || (name != 'X' && name != 'Y')) return {};
  const std::optional<double> number = parseNumber(length);
  // 2^53: above it a double no longer tells whole numbers apart, and no image is near it.
  if (!number || std::abs(*number) > 0x1p53 || *number != std::floor(*number)) return {};
  return Axis{name, sign == '-', static_cast<long long>(*number)};
}

/// "-Y 1024 +X 2048": the axis named first is the one from scan line to scan line, and its sign
/// tells whether the coordinate grows, Y upwards (Radiance's file formats, "resolution string").
Result<void> readResolution(std::string_view line, const LineReader& reader, HdrHeader& header) {
  const std::vector<std::string> words = split(line, ' ');
  std::optional<Axis> slow;
  std::optional<Axis> fast;
  if (words.size() == 4) {
    slow = parseAxis(words[0], words[1]);
    fast = parseAxis(words[2], words[3]);
  }
  if (!slow || !fast || slow->name == fast->name)
    return reader.failure(ErrorCode::bad_file, "should be the resolution, such as '-Y 1024 +X 2048'");
  header.columns = slow->name == 'X';
  const Axis& x = header.columns ? *slow : *fast;
  const Axis& y = header.columns ? *fast : *slow;
  MIRRORBALL_TRY_VOID(checkDimensions(x.length, y.length));
  header.width = static_cast<int>(x.length);
  header.height = static_cast<int>(y.length);
  header.x_descends = x.descends;
  header.y_ascends = !y.descends;
  return {};
}

}  // namespace

std::string primariesLine(const Primaries& primaries) {
  std::string line = "PRIMARIES=";
  for (const glm::dvec2 xy : {primaries.red, primaries.green, primaries.blue, primaries.white})
    line += (line.back() == '=' ? "" : " ") + formatNumber(xy.x) + " " + formatNumber(xy.y);
  return line;
}

Result<HdrHeader> parseHdrHeader(std::span<const std::uint8_t> bytes) {
  LineReader reader(bytes);
  HdrHeader header;
  const auto ends_early = [&] {
    return fail(ErrorCode::bad_file,
                "the header ends early, at byte " + std::to_string(bytes.size()) + "; the file is truncated");
  };
  while (true) {
    const auto line = reader.next();
    if (!line) return ends_early();
    if (line->empty()) break;
    MIRRORBALL_TRY_VOID(readVariable(*line, reader, header));
  }
  const auto line = reader.next();
  if (!line) return ends_early();
  MIRRORBALL_TRY_VOID(readResolution(*line, reader, header));
  header.size = reader.position();
  return header;
}

}  // namespace mirrorball
