#include "mirrorball/codec/ldr/pnm.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/ldr/pnm_header.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

/// How samples stand in the file.
enum class Coding {
  text,
  bits,   ///< eight to a byte, rows padded
  bytes,  ///< one or two a sample, the high one first
};

struct PnmHeader {
  char version = '0';  ///< the digit behind the P
  Coding coding = Coding::bytes;
  int width = 0;
  int height = 0;
  int channels = 0;  ///< stored ones: 1, 2 (grey and alpha), 3 or 4
  std::uint32_t max = 1;
  std::size_t samples_at = 0;
  bool ends_with_cr_lf = false;

  bool isBitmap() const { return version == '1' || version == '4'; }
  /// A share of 15 or 85 is one of 255 too; others need more than 8 bits.
  bool fitsEightBits() const { return 255 % max == 0; }
  std::size_t rowSamples() const { return std::size_t(width) * std::size_t(channels); }
  std::size_t rowBytes() const {
    return coding == Coding::bits ? (rowSamples() + 7) / 8 : rowSamples() * (max > 255 ? 2 : 1);
  }
};

constexpr std::uint32_t kMaxSide = std::numeric_limits<int>::max();
constexpr std::uint32_t kMaxCode = 65535;

/// The lines of a PAM's header: a word and its value.
Result<void> readPamHeader(PnmWords& words, PnmHeader& header) {
  std::string kind;
  while (true) {
    const std::string_view key = words.word();
    if (key == "ENDHDR") break;
    if (key == "TUPLTYPE") {
      kind = words.restOfLine();
    } else if (key == "WIDTH" || key == "HEIGHT") {
      MIRRORBALL_TRY(side, words.number("a side", kMaxSide));
      (key == "WIDTH" ? header.width : header.height) = static_cast<int>(side);
    } else if (key == "DEPTH") {
      MIRRORBALL_TRY(depth, words.number("DEPTH", kMaxCode));
      header.channels = static_cast<int>(depth);
    } else if (key == "MAXVAL") {
      MIRRORBALL_TRY(max, words.number("MAXVAL", kMaxCode));
      header.max = max;
    } else {
      return words.failure("a line of the header should begin with WIDTH, HEIGHT, DEPTH, MAXVAL, TUPLTYPE or ENDHDR",
                           key);
    }
  }
  constexpr std::string_view kKinds[]{"",    "BLACKANDWHITE", "BLACKANDWHITE_ALPHA", "GRAYSCALE", "GRAYSCALE_ALPHA",
                                      "RGB", "RGB_ALPHA"};
  if (header.channels < 1 || header.channels > 4 || !contains(kKinds, kind))
    return fail(ErrorCode::unsupported, "is a PAM of the kind '" + excerpt(kind) + "' with " +
                                            counted(std::size_t(header.channels), "sample") +
                                            " a texel; grey and RGB, with or without alpha, are read");
  return {};
}

Result<PnmHeader> readPnmHeader(Span bytes) {
  PnmWords words(bytes);
  words.skip(2);
  PnmHeader header{.version = static_cast<char>(bytes[1])};
  if (header.version == '7') {
    MIRRORBALL_TRY_VOID(readPamHeader(words, header));
  } else {
    header.coding = header.version <= '3' ? Coding::text : header.version == '4' ? Coding::bits : Coding::bytes;
    header.channels = header.version == '3' || header.version == '6' ? 3 : 1;
    MIRRORBALL_TRY(width, words.number("the width", kMaxSide));
    MIRRORBALL_TRY(height, words.number("the height", kMaxSide));
    header.width = static_cast<int>(width);
    header.height = static_cast<int>(height);
    if (!header.isBitmap()) {
      MIRRORBALL_TRY(max, words.number("the greatest sample", kMaxCode));
      header.max = max;
    }
  }
  if (header.max == 0) return fail(ErrorCode::bad_file, "says that its greatest sample is 0");
  MIRRORBALL_TRY_VOID(checkDimensions(header.width, header.height));
  const bool is_text = header.coding == Coding::text;
  MIRRORBALL_TRY(has_cr_lf, words.endHeader(is_text ? 0 : std::uint64_t(header.rowBytes()) * header.height));
  header.ends_with_cr_lf = has_cr_lf && !is_text;
  header.samples_at = words.position();
  return header;
}

/// Before memory is taken. A sample of a text has at least one byte.
Result<void> checkSize(const PnmHeader& header, Span bytes) {
  MIRRORBALL_TRY_VOID(checkPictureMemory(header.width, header.height, header.channels == 2 ? 4 : header.channels,
                                         header.fitsEightBits() ? 1 : 2));
  const std::size_t row = header.coding == Coding::text ? header.rowSamples() : header.rowBytes();
  if (!mayBeLeftOf(std::uint64_t{row} * std::uint64_t(header.height), bytes.size() - header.samples_at))
    return cannotHold(header.width, header.height, bytes.size());
  return {};
}

/// Reads row after row, from the top.
class PnmRows {
 public:
  PnmRows(const PnmHeader& header, Span bytes)
      : header_(header), bytes_(bytes.subspan(header.samples_at)), words_(bytes) {
    words_.skip(header.samples_at);
  }

  /// The codes of a row; in a bitmap 1 is black.
  ///
  /// returns  whether the file holds the row; one in which it ends is not held
  Result<bool> read(int y, std::vector<std::uint32_t>& row) {
    if (header_.coding == Coding::text) {
      const Result<void> whole = readText(row);
      // With the file a number may end before its last digit, but for the picture's last.
      const bool is_last = whole && (y + 1 == header_.height || header_.isBitmap());
      if (words_.isAtEnd() && !is_last) return false;
      if (!whole) return tl::unexpected<Error>(whole.error());
    } else {
      if (bytes_.size() / header_.rowBytes() <= std::size_t(y)) return false;
      readBytes(bytes_.data() + std::size_t(y) * header_.rowBytes(), row);
    }
    const std::uint32_t max = *std::max_element(row.begin(), row.end());
    if (max > header_.max)
      return fail(ErrorCode::bad_file, "a sample in row " + std::to_string(y) + " is " + std::to_string(max) +
                                           ", above the greatest that the header names, " +
                                           std::to_string(header_.max));
    if (header_.isBitmap())
      for (std::uint32_t& code : row) code = 1 - code;
    return true;
  }

 private:
  Result<void> readText(std::vector<std::uint32_t>& row) {
    for (std::uint32_t& code : row) {
      MIRRORBALL_TRY(number, header_.isBitmap() ? words_.bit() : words_.number("a sample", kMaxCode));
      code = number;
    }
    return {};
  }

  void readBytes(const std::uint8_t* stored, std::vector<std::uint32_t>& row) const {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (header_.coding == Coding::bits)
        row[i] = stored[i / 8] >> (7 - i % 8) & 1u;
      else
        row[i] = header_.max > 255 ? bigU16(stored + 2 * i) : stored[i];
    }
  }

  const PnmHeader& header_;
  Span bytes_;
  PnmWords words_;
};

/// oddities   receives the remark on rows that are missing
template <typename Sample>
Result<CodedPicture> readSamples(const PnmHeader& header, Span bytes, std::vector<std::string>& oddities) {
  constexpr std::uint32_t kMax = std::numeric_limits<Sample>::max();
  const bool is_grey_with_alpha = header.channels == 2;
  auto image = ImageOf<Sample>::withoutValues(header.width, header.height, is_grey_with_alpha ? 4 : header.channels);
  PnmRows reader(header, bytes);
  std::vector<std::uint32_t> row(header.rowSamples());
  int y = 0;
  for (; y < header.height; ++y) {
    MIRRORBALL_TRY(is_there, reader.read(y, row));
    if (!is_there) break;
    Sample* to = image.row(y).data();
    for (std::size_t i = 0; i < row.size(); ++i) {
      *to++ = static_cast<Sample>(rescaledCode(row[i], header.max, kMax));
      if (is_grey_with_alpha && i % 2 == 0) to = std::fill_n(to, 2, to[-1]);
    }
  }
  if (y == 0) return endsInFirstRow(bytes.size());
  blackenMissingRows(image, y, /*from_top=*/true, oddities);
  return CodedPicture(std::move(image));
}

}  // namespace

bool isPnm(Span bytes) {
  if (bytes.size() < 3 || bytes[0] != 'P' || bytes[1] < '1' || bytes[1] > '7') return false;
  return bytes[2] == '#' || bytes[2] == ' ' || (bytes[2] >= '\t' && bytes[2] <= '\r');
}

Result<CodedFile> decodePnm(Span bytes, CodeForm) {
  MIRRORBALL_TRY(header, readPnmHeader(bytes));
  MIRRORBALL_TRY_VOID(checkSize(header, bytes));
  std::vector<std::string> oddities;
  if (header.ends_with_cr_lf) oddities.push_back(PnmWords::crLfText());
  MIRRORBALL_TRY(codes, header.fitsEightBits() ? readSamples<std::uint8_t>(header, bytes, oddities)
                                               : readSamples<std::uint16_t>(header, bytes, oddities));
  constexpr std::string_view kNames[]{"PBM, text", "PGM, text", "PPM, text", "PBM", "PGM", "PPM", "PAM"};
  std::string format(kNames[header.version - '1']);
  if (!header.isBitmap()) format += ", 0 to " + std::to_string(header.max);
  return CodedFile{.codes = std::move(codes), .format = std::move(format), .oddities = std::move(oddities)};
}

}  // namespace mirrorball
