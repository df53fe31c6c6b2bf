# cmake -DOUTPUT=embedded_text.cpp -DHEADER=shaders/embedded_text.h -DFUNCTION=embeddedText -DFILES="a.glsl|b.frag"
#       -P EmbedText.cmake
#
# Writes the C++ file that holds the text of all FILES, for mirrorball::FUNCTION(name), which HEADER declares. A name is
# that of the file without its folders, so no two may share one.
cmake_minimum_required(VERSION 3.25)

string(REPLACE "|" ";" files "${FILES}")

set(entries "")
set(names "")
foreach(file IN LISTS files)
  get_filename_component(name "${file}" NAME)
  if(name IN_LIST names)
    message(FATAL_ERROR "two texts are named ${name}: rename ${file}")
  endif()
  list(APPEND names "${name}")
  file(READ "${file}" text)
  string(APPEND entries "    {\"${name}\", R\"mirrorball(${text})mirrorball\"sv},\n")
endforeach()

string(CONFIGURE [=[
// Written by cmake/EmbedText.cmake.
#include "@HEADER@"

namespace mirrorball {
namespace {

// Compilers would count the letters of the texts, and some give up.
using std::string_view_literals::operator""sv;

struct EmbeddedText {
  std::string_view name;
  std::string_view text;
};

constexpr EmbeddedText kTexts[] = {
@entries@};

}  // namespace

std::optional<std::string_view> @FUNCTION@(std::string_view name) {
  for (const EmbeddedText& file : kTexts) {
    if (file.name == name) return file.text;
  }
  return std::nullopt;
}

}  // namespace mirrorball
]=] source @ONLY)
file(WRITE "${OUTPUT}" "${source}")
