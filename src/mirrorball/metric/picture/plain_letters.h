#pragma once

#include <string>
#include <string_view>

namespace mirrorball {

/// A text in the letters that lettering.h draws, printable ASCII: Latin letters (Unicode's Latin-1 Supplement and Latin
/// Extended-A) without their marks, marks that stand apart left out, dashes and quotes of typography as ASCII has them.
/// Each other code point, and each byte that is not UTF-8, is '?'.
///
/// text     UTF-8: "Zürich – Œuvre", which becomes "Zurich - OEuvre"
std::string plainLetters(std::string_view text);

/// Whether plainLetters has a letter for all of a text.
bool hasPlainLetters(std::string_view text);

}  // namespace mirrorball
