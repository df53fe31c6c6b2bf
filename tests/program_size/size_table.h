#pragma once

#include <map>
#include <string>

#include "mirrorball/base/result.h"
#include "program_size/program_size.h"

namespace mirrorball::testing {

/// sizes.txt: the tools that counted, and the sizes by the program's name.
struct SizeTable {
  std::string tools;  ///< findSizeTools()
  std::map<std::string, ProgramSize> programs;
};

/// errors   bad_file: a line that has none of these
Result<SizeTable> parseSizeTable(const std::string& text);

/// `text` with other sizes and tools; comments, among which the reasons are, stay.
std::string withSizes(const std::string& text, const SizeTable& sizes);

}  // namespace mirrorball::testing
