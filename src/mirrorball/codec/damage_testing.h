#pragma once

#include <functional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/base/file.h"

namespace mirrorball::testing {

/// A small file that damage_test.cpp damages in every way. The tests of a format add theirs by
/// INSTANTIATE_TEST_SUITE_P.
struct DamagedFile {
  const char* name;
  std::function<Bytes()> bytes;
  bool is_read_in_part = false;  ///< as far as it goes, with a remark, where it ends early
};

/// One of those that are read in part.
inline DamagedFile inPart(const char* name, std::function<Bytes()> bytes) { return {name, std::move(bytes), true}; }

class Damage : public ::testing::TestWithParam<DamagedFile> {};

inline std::string nameOfDamaged(const ::testing::TestParamInfo<DamagedFile>& file) { return file.param.name; }

}  // namespace mirrorball::testing
