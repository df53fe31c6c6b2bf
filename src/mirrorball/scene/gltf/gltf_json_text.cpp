#include "mirrorball/scene/gltf/gltf_json_text.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mirrorball::gltf {
namespace {

constexpr std::string_view kNull = "null";

/// Those that begin another word come behind it.
constexpr auto kWords = std::to_array<std::string_view>(
    {"-Infinity", "Infinity", "-NaN", "NaN", "-nan(ind)", "nan(ind)", "-nan", "nan", "-inf", "inf"});

/// Copies a text, piece by piece.
class JsonMending {
 public:
  explicit JsonMending(std::string_view json) : json_(json) {}

  std::optional<std::string> mended() {
    while (at_ < json_.size()) step();
    if (!is_changed_) return {};
    return text_.append(json_.substr(copied_));
  }

 private:
  void step() {
    const char next = json_[at_];
    if (next == '"') return skipString();
    const auto word = std::find_if(kWords.begin(), kWords.end(),
                                   [&](std::string_view each) { return json_.substr(at_).starts_with(each); });
    if (word != kWords.end()) {
      put(at_, kNull, at_ + word->size());
      before_ = 'x';
      at_ = copied_;
      return;
    }
    const bool misses_value = before_ == '[' || before_ == ',' || before_ == ':';
    if (next == ',' && misses_value) put(at_, kNull, at_);
    if ((next == ']' || next == '}') && before_ == ',') put(comma_, {}, comma_ + 1);
    if (next == ',') comma_ = at_;
    if (next != ' ' && next != '\t' && next != '\r' && next != '\n') before_ = next;
    ++at_;
  }

  void skipString() {
    for (++at_; at_ < json_.size() && json_[at_] != '"'; ++at_)
      if (json_[at_] == '\\') ++at_;
    ++at_;
    before_ = 'x';
  }

  /// Puts a word in place of what is from `begin` to `end`.
  void put(std::size_t begin, std::string_view word, std::size_t end) {
    text_.append(json_.substr(copied_, begin - copied_)).append(word);
    copied_ = end;
    is_changed_ = true;
  }

  std::string_view json_;
  std::string text_;
  std::size_t at_ = 0;
  std::size_t copied_ = 0;  // up to where
  std::size_t comma_ = 0;   // the last
  char before_ = 0;         // the last character but blanks; 'x' of a value
  bool is_changed_ = false;
};

}  // namespace

std::optional<std::string> mendedJson(std::string_view json) { return JsonMending(json).mended(); }

}  // namespace mirrorball::gltf
