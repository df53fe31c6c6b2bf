#pragma once

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "mirrorball/base/file.h"

namespace mirrorball::testing {

/// A file of a few rows that early_end_test.cpp cuts at every byte. The tests of a format add theirs by
/// INSTANTIATE_TEST_SUITE_P.
struct CutFile {
  const char* name;
  std::function<Bytes()> bytes;
  bool from_top = true;     ///< the upper rows come first
  bool is_by_rows = false;  ///< openRows opens it
  int rows_together = 1;    ///< that are there or missing at once
};

class EarlyEnd : public ::testing::TestWithParam<CutFile> {};

inline std::string nameOfCut(const ::testing::TestParamInfo<CutFile>& file) { return file.param.name; }

}  // namespace mirrorball::testing
