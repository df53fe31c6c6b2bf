#pragma once

#include <cstddef>
#include <string_view>

namespace mirrorball {

/// How often a text has this word in it.
inline std::size_t occurrences(std::string_view text, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at < text.size(); at = text.find(word, at + word.size())) ++count;
  return count;
}

/// Reads white-space separated words from a text, and knows in which line it stands.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : text_(text) {}

  /// The line of the word read last, from 1.
  std::size_t line() const { return line_; }

  /// The next word; empty at the end of the text.
  std::string_view word() {
    peek();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isSpace(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  /// The first letter of the next word; 0 at the end of the text.
  char peek() {
    while (at_ < text_.size() && isSpace(text_[at_])) advance();
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  /// The rest of the line, which LF, CR LF or CR ends, without that, and steps past it.
  std::string_view restOfLine() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    const std::string_view rest = text_.substr(begin, at_ - begin);
    if (at_ < text_.size()) advance();
    return rest;
  }

  /// Whether nothing follows what was read last, not even white space.
  bool isAtEnd() const { return at_ == text_.size(); }

  /// How many bytes are read.
  std::size_t position() const { return at_; }

 private:
  static bool isSpace(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r' || letter == '\v' || letter == '\f';
  }
  void advance() {
    // Of "\r\n" the second ends the line.
    const bool is_end = text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_ + 1, 1) != "\n");
    if (is_end) ++line_;
    ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace mirrorball
