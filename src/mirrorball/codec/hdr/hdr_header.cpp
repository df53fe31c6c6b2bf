#include "mirrorball/codec/hdr/hdr_header.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/decimal_comma.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball {
namespace {

constexpr std::string_view kHdrSignature = "#?";
constexpr std::string_view kFormatKey = "FORMAT";
constexpr std::string_view kHeaderBlanks = " \t\r";

/// Walks over the header's lines; knows where it is, for messages.
class LineReader {
 public:
  LineReader(std::string_view text, std::size_t at) : text_(text), at_(at) {}

  /// The next line without the blanks at its end; nothing when the file ends before the line does.
  std::optional<std::string_view> next() {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) return {};
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++number_;
    return line.substr(0, line.find_last_not_of(kHeaderBlanks) + 1);
  }

  std::size_t position() const { return at_; }
  std::string place() const { return "line " + std::to_string(number_); }

  tl::unexpected<Error> failure(ErrorCode code, const std::string& what) const {
    return fail(code, place() + " " + what);
  }

 private:
  std::string_view text_;
  std::size_t at_;
  int number_ = 0;
};

/// "EXPOSURE" and "1.5" of "EXPOSURE= 1.5". A line with blanks before its name is one of a picture from which this one
/// was made, and says nothing of this one (Radiance's "File formats").
struct Variable {
  std::string_view name;
  std::string_view value;
};

Variable variableIn(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return {};
  std::string_view name = line.substr(0, equals);
  name = name.substr(0, name.find_last_not_of(kHeaderBlanks) + 1);
  return {name, trimmed(line.substr(equals + 1))};
}

/// Reads the lines before the empty one, in their order.
class VariableReader {
 public:
  VariableReader(HdrHeader& header, const LineReader& lines) : header_(header), lines_(lines) {}

  Result<void> read(std::string_view line) {
    constexpr std::string_view kComment = "# ";
    if (line.starts_with(kComment)) {
      readMetadataLine(line.substr(kComment.size()), header_.metadata);
      return {};
    }
    const Variable variable = variableIn(line);
    if (variable.name == kFormatKey) return readFormat(variable.value);
    if (variable.name == "EXPOSURE") applyExposure(variable, 1);
    if (variable.name == "COLORCORR") applyExposure(variable, 3);
    if (variable.name == "PRIMARIES") return readPrimaries(variable.value);
    if (variable.name == "PIXASPECT") pixel_aspect_ *= numberIn(variable.value).value_or(1.0);
    if (variable.name == "GAMMA") gamma_ = numberIn(variable.value).value_or(1.0);
    return {};
  }

  /// Tells what of all lines together is unusual.
  void finish() {
    if (undivided_ > 0)
      tell(first_undivided_ + (undivided_ > 1 ? ", and " + std::to_string(undivided_ - 1) + " more such lines" : "") +
           ", which cannot be divided out: taken as 1");
    if (!has_format_) tell("does not say its FORMAT: read as 32-bit_rle_rgbe");
    if (has_decimal_comma_) tell("has numbers with decimal commas: read as points");
    // Written by programs after B. Walter's rgbe.c, where it speaks of codes of a display; 1 by nearly all of them.
    // stb_image, FreeImage, three.js and Radiance itself apply none.
    if (gamma_ != 1.0) tell("says GAMMA=" + formatNumber(gamma_) + ", which Radiance does not define: not applied");
    // Factors of the pictures that a program made of one another multiply; those of 1 are written with rounding.
    if (std::abs(pixel_aspect_ - 1.0) > 0.01)
      tell("says PIXASPECT=" + formatNumber(pixel_aspect_) + ": its pixels are taken as square");
  }

 private:
  void tell(std::string oddity) { header_.oddities.push_back(std::move(oddity)); }

  /// A number, also as "1,5", which programs write whose locale has decimal commas.
  std::optional<double> numberIn(std::string_view word) {
    if (const auto number = parseNumber(word)) return number;
    const auto number = parseDecimalComma(word);
    has_decimal_comma_ = has_decimal_comma_ || number;
    return number;
  }

  /// Numbers between blanks, exactly `count` of them.
  std::optional<std::vector<double>> numbersIn(std::string_view text, std::size_t count) {
    std::vector<double> numbers;
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
      const std::optional<double> number = numberIn(word);
      if (!number) return {};
      numbers.push_back(*number);
    }
    if (numbers.size() != count) return {};
    return numbers;
  }

  Result<void> readFormat(std::string_view format) {
    has_format_ = true;
    header_.xyz = format == "32-bit_rle_xyze";
    if (header_.xyz || format == "32-bit_rle_rgbe") return {};
    return lines_.failure(ErrorCode::unsupported,
                          "names the format '" + excerpt(format) + "'; 32-bit_rle_rgbe and 32-bit_rle_xyze are read");
  }

  /// EXPOSURE= and COLORCORR= tell what the texels have been multiplied by; several lines multiply. A line that cannot
  /// be divided out, such as FreeImage's EXPOSURE=0 (opencv/opencv#5185), is passed over, as most readers do with all.
  void applyExposure(const Variable& variable, std::size_t count) {
    const auto factors = numbersIn(variable.value, count);
    const auto product = [&](int c) {
      return static_cast<double>(header_.exposure[c]) * (*factors)[count == 1 ? 0 : std::size_t(c)];
    };
    const auto can_divide = [](double number) { return number > 1e-30 && number < 1e30; };
    if (!factors || !can_divide(product(0)) || !can_divide(product(1)) || !can_divide(product(2))) {
      if (undivided_++ == 0)
        first_undivided_ = lines_.place() + " says " + std::string(variable.name) + "=" + excerpt(variable.value, 32);
      return;
    }
    header_.exposure = glm::vec3(product(0), product(1), product(2));
  }

  Result<void> readPrimaries(std::string_view value) {
    const auto xy = numbersIn(value, 8);
    if (!xy) return lines_.failure(ErrorCode::bad_file, "should have 8 numbers behind its '='");
    const auto at = [&](std::size_t i) { return glm::dvec2((*xy)[i], (*xy)[i + 1]); };
    header_.primaries = Primaries{at(0), at(2), at(4), at(6)};
    return {};
  }

  HdrHeader& header_;
  const LineReader& lines_;
  bool has_format_ = false;
  bool has_decimal_comma_ = false;
  std::size_t undivided_ = 0;  // lines of exposures that cannot be divided out
  std::string first_undivided_;
  double gamma_ = 1.0;
  double pixel_aspect_ = 1.0;
};

/// One half of the resolution line: "-Y" and "1024".
struct Axis {
  char name;
  bool descends;
  long long length;
};

std::optional<Axis> parseAxis(std::string_view sign_and_name, std::string_view length) {
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
  const auto takeAxis = [&] {
    const std::string_view name = takeWord(line);
    return parseAxis(name, takeWord(line));
  };
  const std::optional<Axis> slow = takeAxis();
  const std::optional<Axis> fast = takeAxis();
  if (!slow || !fast || slow->name == fast->name || !line.empty())
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

bool beginsWithHdrHeader(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLongestSearch = 4096;  // a FORMAT line stands before it in any real header
  const std::string_view text =
      withoutByteOrderMark({reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), kLongestSearch)});
  if (text.starts_with(kHdrSignature)) return true;
  const auto is_text = [](unsigned char c) { return c >= 0x20 || c == '\t' || c == '\r'; };
  LineReader lines(text, 0);
  for (auto line = lines.next(); line && !line->empty(); line = lines.next()) {
    if (!std::all_of(line->begin(), line->end(), is_text)) return false;
    const Variable variable = variableIn(*line);
    if (variable.name == kFormatKey && variable.value.starts_with("32-bit_rle_")) return true;
  }
  return false;
}

Result<HdrHeader> parseHdrHeader(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t mark = text.size() - withoutByteOrderMark(text).size();
  LineReader lines(text, mark);
  HdrHeader header;
  if (mark > 0) header.oddities.emplace_back("begins with a byte-order mark: left out");
  if (!text.substr(lines.position()).starts_with(kHdrSignature))
    header.oddities.emplace_back("lacks the signature '#?RADIANCE': read as what its FORMAT says");
  VariableReader variables(header, lines);
  const auto ends_early = [&] {
    return fail(ErrorCode::bad_file,
                "the header ends early, at byte " + std::to_string(bytes.size()) + "; the file is truncated");
  };
  while (true) {
    const auto line = lines.next();
    if (!line) return ends_early();
    if (line->empty()) break;
    MIRRORBALL_TRY_VOID(variables.read(*line));
  }
  variables.finish();
  auto line = lines.next();
  // Some end the header with two empty lines.
  if (line && line->empty()) line = lines.next();
  if (!line) return ends_early();
  MIRRORBALL_TRY_VOID(readResolution(*line, lines, header));
  header.size = lines.position();
  return header;
}

}  // namespace mirrorball
