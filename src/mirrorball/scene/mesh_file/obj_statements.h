#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "mirrorball/base/text.h"

namespace mirrorball {

/// Reads the statements of a Wavefront .obj or .mtl: a keyword and what follows it, a line each. Lines end with LF, CR
/// LF or CR; a '\' at the end of one joins the next to it; a byte-order mark before the first is passed over.
class StatementReader {
 public:
  explicit StatementReader(std::string_view text);

  /// Steps to the next statement, over empty lines; false at the end.
  bool next();

  /// In small letters: programs disagree about them ("map_Kd", "map_kd", "Map_KD").
  const std::string& keyword() const { return keyword_; }

  /// What follows the keyword, without blanks at its ends. Comments are part of it: a '#' may be one of a name. Valid
  /// until the next statement.
  std::string_view rest() const { return rest_; }

  /// The line in which the statement begins, from 1.
  std::size_t line() const { return line_; }

 private:
  std::string_view takeLine();

  std::string_view text_;
  std::string joined_;  // where a statement has several lines
  std::string keyword_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::size_t lines_taken_ = 0;
};

}  // namespace mirrorball
