#pragma once

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/base/text.h"

namespace mirrorball {

/// Walks over the words at the beginning of one of Netpbm's files, and over the samples of those that are texts.
class PnmWords {
 public:
  explicit PnmWords(std::span<const std::uint8_t> bytes)
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  /// How many bytes were read.
  std::size_t position() const { return at_; }

  bool isAtEnd() const { return at_ >= text_.size(); }

  void skip(std::size_t count) { at_ += count; }

  /// The next word behind white space and comments, which run from '#' to the line's end; empty at the file's end.
  std::string_view word() {
    skipBlanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_]) && text_[at_] != '#') ++at_;
    return text_.substr(begin, at_ - begin);
  }

  /// What is left of the line, without blanks at its ends.
  std::string_view restOfLine() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    std::string_view rest = text_.substr(begin, at_ - begin);
    while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && isBlank(rest.back())) rest.remove_suffix(1);
    return rest;
  }

  /// A whole number from 0 to `max`, called `what` in messages.
  Result<std::uint32_t> number(const char* what, std::uint32_t max) {
    const std::string_view digits = word();
    const auto value = parseNumber(digits);
    if (value && *value >= 0 && *value <= max && digits.find_first_not_of("0123456789") == std::string_view::npos)
      return static_cast<std::uint32_t>(*value);
    return failure(std::string(what) + " should be a number up to " + std::to_string(max), digits);
  }

  /// A 0 or a 1, which need no blanks between them.
  Result<std::uint32_t> bit() {
    skipBlanks();
    const std::string_view digit = text_.substr(at_, 1);
    if (digit != "0" && digit != "1") return failure("a sample should be 0 or 1", digit);
    ++at_;
    return static_cast<std::uint32_t>(digit == "1");
  }

  /// Passes the one blank that ends a header. Programs on Windows end it with CR LF, of which the LF may as well be the
  /// first sample's byte: it is that where the bytes are then just as many as the samples have, and no other line of
  /// the header ends so.
  ///
  /// sample_bytes  how many the samples have
  /// returns       whether CR LF was passed
  Result<bool> endHeader(std::uint64_t sample_bytes) {
    if (at_ >= text_.size() || !isBlank(text_[at_]))
      return failure("a blank should end the header", text_.substr(at_, 1));
    const bool may_be_sample =
        text_.size() - at_ - 1 == sample_bytes && text_.substr(0, at_).find("\r\n") == std::string_view::npos;
    const bool has_two = text_.substr(at_, 2) == "\r\n" && !may_be_sample;
    at_ += has_two ? 2 : 1;
    return has_two;
  }

  /// The remark on a header that ends so.
  static std::string crLfText() { return "its header ends with CR LF: the samples begin behind both"; }

  tl::unexpected<Error> failure(const std::string& what, std::string_view found) const {
    const std::string there = found.empty() ? "the file ends there" : "it is '" + excerpt(found, 20) + "'";
    return fail(ErrorCode::bad_file, "at byte " + std::to_string(at_) + " " + what + ", and " + there);
  }

 private:
  static bool isBlank(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

  void skipBlanks() {
    while (at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#')
        restOfLine();
      else
        ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace mirrorball
