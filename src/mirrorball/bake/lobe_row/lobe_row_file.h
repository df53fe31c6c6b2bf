#pragma once

#include <cstdint>
#include <span>

namespace mirrorball {

/// The bytes of lobe_rows.ktx2: lobeRowTable() as half floats, written by bench/fit_lobe_rows.cpp, plain: a build may leave Zstandard out.
std::span<const std::uint8_t> lobeRowFile();

}  // namespace mirrorball
