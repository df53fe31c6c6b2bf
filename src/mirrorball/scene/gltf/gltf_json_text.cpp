#include "mirrorball/scene/gltf/gltf_json_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/base/unicode.h"
#include "mirrorball/scene/mesh_file/number_text.h"

namespace mirrorball::gltf {
namespace {

constexpr std::string_view kNull = "null";
constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kDigits = "0123456789";

/// The kinds of what is mended, and the remark on each.
enum Oddity { kNoValue, kNumber, kComment, kLetter, kString, kBehind, kOddityCount };
constexpr std::array<std::string_view, kOddityCount> kConsequences = {
    "numbers that are missing, NaN or infinite, and commas too many, are read as no value",
    "numbers written as '+1', '.5' or '01' are read as 1, 0.5 and 1",
    "comments are passed over",
    "letters that are not of UTF-8 are read as Latin-1",
    "control characters and '\\' in its strings are read as letters",
    "what lies behind its end is left out"};

bool isOfWord(char letter) {
  const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
  return is_letter || kDigits.find(letter) != std::string_view::npos ||
         std::string_view("+-.#_()").find(letter) != std::string_view::npos;
}

/// Takes the digits off the begin of a text.
std::string_view takeDigits(std::string_view& text) {
  const std::string_view digits = text.substr(0, text.find_first_not_of(kDigits));
  text.remove_prefix(digits.size());
  return digits;
}

/// A decimal number as JSON has it.
std::string plainNumber(std::string_view word) {
  std::string text(word.starts_with('-') ? "-" : "");
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  std::string_view whole = takeDigits(word);
  whole.remove_prefix(std::min(whole.find_first_not_of('0'), whole.size()));
  text.append(whole.empty() ? "0" : whole);
  if (word.starts_with('.')) {
    word.remove_prefix(1);
    if (const std::string_view behind_point = takeDigits(word); !behind_point.empty())
      text.append(".").append(behind_point);
  }
  return text.append(word);
}

/// The four digits of "\uD83D"; nothing where there are not so many.
std::optional<unsigned> escapedUnit(std::string_view text) {
  if (text.size() < 6 || !text.starts_with("\\u")) return {};
  unsigned unit = 0;
  for (const char letter : lowerCase(text.substr(2, 4))) {
    const std::size_t digit = std::string_view("0123456789abcdef").find(letter);
    if (digit == std::string_view::npos) return {};
    unit = 16 * unit + static_cast<unsigned>(digit);
  }
  return unit;
}

/// How long the escape is with which a text begins; 0: it is none of JSON's.
std::size_t escapeSize(std::string_view text) {
  if (text.size() > 1 && std::string_view("\"\\/bfnrt").find(text[1]) != std::string_view::npos) return 2;
  const std::optional<unsigned> unit = escapedUnit(text);
  if (!unit || isSecondOfPair(*unit)) return 0;
  if (!isFirstOfPair(*unit)) return 6;
  const std::optional<unsigned> second = escapedUnit(text.substr(6));
  return second && isSecondOfPair(*second) ? 12 : 0;
}

/// Copies a text, piece by piece, or counts what that takes.
class JsonMending {
 public:
  /// text   gets the copy; nullptr: it is counted alone
  JsonMending(std::string_view json, std::string* text) : json_(json), text_(text) {
    while (at_ < json_.size()) step();
    add(json_.substr(copied_));
  }

  std::uint64_t size() const { return size_; }

  /// What was done to it; nothing: it needs no mending.
  std::vector<std::string_view> how() const {
    std::vector<std::string_view> how;
    for (std::size_t i = 0; i < found_.size(); ++i)
      if (found_[i]) how.push_back(kConsequences[i]);
    return how;
  }

 private:
  void step() {
    const char next = json_[at_];
    if (next == '"') return mendString();
    if (const std::size_t size = commentSize(at_); size > 0) {
      put(kComment, at_, {}, at_ + size);
      at_ += size;
      return;
    }
    if (isOfWord(next)) return mendWord();
    if (next == ',') mendComma();
    if (kBlanks.find(next) == std::string_view::npos) before_ = next;
    ++at_;
    if (next == '[' || next == '{') ++depth_;
    if ((next == ']' || next == '}') && depth_ > 0 && --depth_ == 0) end();
  }

  /// Passes over what lies behind the last bracket.
  void end() {
    if (json_.find_first_not_of(kBlanks, at_) < json_.size()) put(kBehind, at_, {}, json_.size());
    at_ = json_.size();
  }

  /// How long the comment is that begins there; 0: none does.
  std::size_t commentSize(std::size_t at) const {
    const std::string_view rest = json_.substr(at);
    if (!rest.starts_with("//") && !rest.starts_with("/*")) return 0;
    const bool is_line = rest[1] == '/';
    const std::size_t end = is_line ? rest.find_first_of("\r\n") : rest.find("*/", 2);
    return end >= rest.size() ? rest.size() : end + (is_line ? 0 : 2);
  }

  void mendComma() {
    if (before_ == '[' || before_ == ',' || before_ == ':') put(kNoValue, at_, kNull, at_);
    std::size_t behind = at_ + 1;
    for (std::size_t size = 1; size > 0; behind += size) {
      behind = std::min(json_.find_first_not_of(kBlanks, behind), json_.size());
      size = commentSize(behind);
    }
    const bool is_last = behind < json_.size() && (json_[behind] == ']' || json_[behind] == '}');
    if (is_last) put(kNoValue, at_, {}, at_ + 1);
  }

  void mendWord() {
    std::size_t end = at_;
    while (end < json_.size() && isOfWord(json_[end])) ++end;
    const std::string_view word = json_.substr(at_, end - at_);
    const NumberText number = readNumber(word);
    if (number.kind == NumberText::Kind::not_finite) put(kNoValue, at_, kNull, end);
    if (number.kind == NumberText::Kind::plain)
      if (const std::string plain = plainNumber(word); plain != word) put(kNumber, at_, plain, end);
    before_ = 'x';
    at_ = end;
  }

  void mendString() {
    const std::size_t begin = ++at_;
    bool is_escaped = true;
    while (at_ < json_.size() && json_[at_] != '"') {
      const std::size_t size = json_[at_] == '\\' ? escapeSize(json_.substr(at_)) : 1;
      is_escaped = is_escaped && size > 0;
      // A quotation mark behind a '\' does not end a string, whatever the '\' is.
      at_ += size > 0 ? size : 1;
    }
    const std::size_t end = std::min(at_, json_.size());
    for (std::size_t i = begin; i < end;) i += mendLetter(i, is_escaped);
    at_ = end + 1;
    before_ = 'x';
  }

  /// Mends one letter or escape of a string, and returns how long it is.
  std::size_t mendLetter(std::size_t at, bool is_escaped) {
    const std::string_view rest = json_.substr(at);
    if (rest[0] == '\\') {
      const bool stays = is_escaped || rest.starts_with("\\\\") || rest.starts_with("\\\"");
      if (!stays) put(kString, at, "\\\\", at + 1);
      return stays ? escapeSize(rest) : 1;
    }
    const CodePoint point = firstCodePoint(rest);
    if (!point.is_valid) {
      std::string letter;
      appendUtf8(letter, static_cast<unsigned char>(rest[0]));
      put(kLetter, at, letter, at + 1);
    } else if (point.value < 0x20) {
      constexpr std::string_view kNibbles = "0123456789abcdef";
      put(kString, at, std::string("\\u00") + kNibbles[point.value >> 4] + kNibbles[point.value & 15], at + 1);
    }
    return point.bytes;
  }

  /// Puts a word in place of what is from `begin` to `end`.
  void put(Oddity oddity, std::size_t begin, std::string_view word, std::size_t end) {
    add(json_.substr(copied_, begin - copied_));
    add(word);
    copied_ = end;
    found_[oddity] = true;
  }

  void add(std::string_view piece) {
    size_ += piece.size();
    if (text_ != nullptr) text_->append(piece);
  }

  std::string_view json_;
  std::string* text_;
  std::uint64_t size_ = 0;  // of the copy
  std::size_t at_ = 0;
  std::size_t copied_ = 0;  // up to where
  std::size_t depth_ = 0;   // brackets that are open
  char before_ = 0;         // the last character but blanks; 'x' of a value
  std::array<bool, kOddityCount> found_{};
};

}  // namespace

std::optional<MendedJson> mendJson(std::string_view json) {
  const JsonMending count(json, nullptr);
  const std::vector<std::string_view> how = count.how();
  if (how.empty()) return {};
  MendedJson mended{{}, join(how, "; ")};
  mended.text.reserve(static_cast<std::size_t>(count.size()));
  JsonMending(json, &mended.text);
  return mended;
}

}  // namespace mirrorball::gltf
