#include "mirrorball/scene/mesh_file/obj_statements.h"

#include <algorithm>

#include "mirrorball/base/text.h"

namespace mirrorball {

StatementReader::StatementReader(std::string_view text) : text_(withoutByteOrderMark(text)) {}

std::string_view StatementReader::takeLine() {
  const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
  const std::string_view line = text_.substr(0, end);
  text_.remove_prefix(end);
  text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
  ++lines_taken_;
  return line;
}

bool StatementReader::next() {
  while (!text_.empty()) {
    std::string_view line = takeLine();
    line_ = lines_taken_;
    // A comment may end with the name of a folder.
    if (line.ends_with('\\') && !trimmed(line).starts_with('#')) {
      joined_.clear();
      while (line.ends_with('\\') && !text_.empty()) {
        joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
        line = takeLine();
      }
      line = joined_.append(line);
    }
    line = trimmed(line);
    if (line.empty()) continue;
    keyword_ = lowerCase(takeWord(line));
    rest_ = line;
    return true;
  }
  return false;
}

}  // namespace mirrorball
