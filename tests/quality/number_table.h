#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball::quality {

/// All of a text file.
///
/// errors   not_found, io
Result<std::string> readText(const std::filesystem::path& file);

/// errors   io
Result<void> writeText(const std::filesystem::path& file, const std::string& text);

/// Rows of numbers, each with a name, as a text file has them: a line each, its cells divided by tabs. Lines that begin
/// with # are comments.
using NumberTable = std::map<std::string, std::vector<double>>;

/// columns  the numbers of a row
/// errors   not_found, io; bad_file: a line that is neither a comment nor such a row
Result<NumberTable> readNumberTable(const std::filesystem::path& file, std::size_t columns);

/// Writes a table with four decimals into a file that keeps its comments.
///
/// errors   not_found, io
Result<void> writeNumberTable(const std::filesystem::path& file, const NumberTable& table);

}  // namespace mirrorball::quality
