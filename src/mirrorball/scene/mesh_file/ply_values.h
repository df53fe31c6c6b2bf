#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/scene/mesh_file/number_text.h"
#include "mirrorball/scene/mesh_file/ply_header.h"
#include "mirrorball/scene/mesh_file/text_scanner.h"

namespace mirrorball {

/// Reads the values after a PLY's header, one by one.
class PlyValues {
 public:
  /// file   lives longer than this
  PlyValues(std::span<const std::uint8_t> file, const PlyHeader& header);

  std::size_t remaining() const { return body_.size() - position(); }

  /// The fewest bytes that a value takes: in ascii a digit (its separator is not counted).
  std::size_t minSize(PlyType type) const { return encoding_ == PlyEncoding::ascii ? 1 : byteSize(type); }

  /// The next value; NaN or infinity where the file has such. Nothing at the end of the file, or where a word is not
  /// a number.
  std::optional<double> next(PlyType type);

  /// Whether the value that was asked for last is beyond the end of the file, or reaches it.
  bool isAtEnd() const { return encoding_ != PlyEncoding::ascii || remaining() == 0; }

  /// Whether a text ends with the word that was read last, without white space behind it.
  bool endsWithinWord() const { return encoding_ == PlyEncoding::ascii && remaining() == 0; }

  /// Passes over lines of comments where a row of a text may begin.
  void passComments();

  /// How many bytes follow the last value, without white space and zeros before and behind them.
  std::size_t bytesBehind() const;

  /// Where the value stands that was asked for last: "line 2 of its data", "byte 146".
  std::string place() const;

  /// As NumberReader's.
  std::vector<std::string> remarks() const { return numbers_.remarks(); }

 private:
  std::size_t position() const { return encoding_ == PlyEncoding::ascii ? scanner_.position() : at_; }

  std::span<const std::uint8_t> body_;
  PlyEncoding encoding_;
  std::size_t offset_;
  std::size_t at_ = 0;
  TextScanner scanner_;
  NumberReader numbers_;
};

}  // namespace mirrorball
