#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>

#include <gtest/gtest.h>

namespace mirrorball::golden {

/// How far a picture may be from the golden one, in codes of an 8-bit picture, and why no less.
struct Tolerance {
  double maximum;  ///< of one pixel
  double mean;     ///< over all pixels
  const char* reason;
};

/// How near a drawn picture is to the path-traced one of the same command, where light does what an environment map can
/// know of (`--bounces 1 --unoccluded`), or with relief all that it does. docs/truth/renderer.md shows what was
/// measured, and how much of the distance is noise.
struct Truth {
  double psnr_db;       ///< at least
  const char* reason;   ///< of the distance
  const char* mistake;  ///< an option of the drawn picture alone that must be found; empty: none is tried
  int samples;          ///< of a drawn pixel
  int paths;            ///< of a traced pixel
};

/// A picture that the program must make again.
struct Case {
  const char* name;     ///< of pictures/NAME.png and of the test
  const char* command;  ///< what follows `mirrorball`, without -o; single spaces between the words. It runs where
                        ///< pictures/ has the golden pictures and heights/ those of docs, which it may read
  const Tolerance* tolerance;  ///< one of a few, each with its reason, in cases.cpp
  const char* min_error;       ///< an option of the command, changed to the smallest mistake that the case must find
  std::optional<Truth> truth = {};  ///< nothing: a conversion, or a picture wrapped around a model
};

/// The table of them, each with inputs that are built in or golden themselves, so that it runs everywhere.
std::span<const Case> cases();

/// The case of that name, which must be in the table.
const Case& caseNamed(const std::string& name);

/// The whole command of a case.
///
/// changed  an option with its value, in the place of the one that the command may have: "--fov 100.1"; --set and
///          --light come on top
std::string commandOf(const Case& golden_case, const std::string& changed = {});

/// The command that draws the picture of a case for its truth: tone mapped after the mean of the samples, as the traced
/// one.
///
/// changed  as commandOf's
std::string drawnCommandOf(const Case& golden_case, const std::string& changed = {});

/// The command that traces the truth of a case: without what only the renderer has.
std::string tracedCommandOf(const Case& golden_case);

/// Whether the command wraps a picture around a model by generated coordinates, which light does not.
bool wrapsPicture(const Case& golden_case);

/// Whether the command draws with OpenGL. A conversion does not.
bool needsGl(const Case& golden_case);

/// How GoogleTest shows it.
inline void PrintTo(const Case& golden_case, std::ostream* out) { *out << "mirrorball " << commandOf(golden_case); }

/// Names the instances of a test that runs with each case.
inline std::string caseName(const ::testing::TestParamInfo<Case>& info) { return info.param.name; }

}  // namespace mirrorball::golden
