# cmake -DFILE=sunset.exr -DOUTPUT=sunset_file.cpp -DHEADER=mirrorball/environment/builtin/sunset.h -DFUNCTION=sunsetFile
#       -P EmbedBytes.cmake
#
# Writes the C++ file that holds the bytes of FILE, for mirrorball::FUNCTION(), which HEADER declares.
cmake_minimum_required(VERSION 3.25)

file(READ "${FILE}" digits HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${digits}")

string(CONFIGURE [=[
// Written by cmake/EmbedBytes.cmake.
#include "@HEADER@"

namespace mirrorball {
namespace {

constexpr std::uint8_t kBytes[] = {@bytes@};

}  // namespace

std::span<const std::uint8_t> @FUNCTION@() { return kBytes; }

}  // namespace mirrorball
]=] source @ONLY)
file(WRITE "${OUTPUT}" "${source}")
