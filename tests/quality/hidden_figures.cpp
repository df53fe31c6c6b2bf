#include "quality/hidden_figures.h"

#include <cstdlib>

#include "cli/program.h"
#include "fresh_folder.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/metric/comparison.h"
#include "quality/scene_parts.h"

namespace mirrorball::quality {
namespace {

namespace fs = std::filesystem;

fs::path sourceFolder() { return fs::path(MIRRORBALL_SOURCE_DIR) / "tests/quality"; }

Result<Image> readPicture(const fs::path& file) {
  MIRRORBALL_TRY(bytes, readFile(file));
  MIRRORBALL_TRY(decoded, decodeImage(bytes));
  return std::move(decoded.image);
}

}  // namespace

Result<MadePicture> makePicture(const HiddenScene& scene, const std::string& how) {
  const FreshFolder folder;
  MIRRORBALL_TRY(file, writeGlb(scene.make(), scene.name, folder.path()));
  const fs::path picture = folder.path() / "picture.png", log = folder.path() / "log";
  // By the shell and not testing::Program, which ends what takes longer than two minutes: many paths do.
  const std::string command = testing::programFile().string() + " render " + file.string() + " " + shownBy(scene, how) +
                              " --dither none -o " + picture.string() + " >" + log.string() + " 2>&1";
  const int status = std::system(command.c_str());
  MIRRORBALL_TRY(printed, readText(log));
  if (status != 0) return fail(ErrorCode::io, command + ": failed: " + printed);
  MIRRORBALL_TRY(image, readPicture(picture));
  return MadePicture{std::move(image), std::move(printed)};
}

Result<PictureError> findError(const Image& picture, const Image& reference) {
  MIRRORBALL_TRY(test, comparedImage(picture, ImageKind::picture));
  MIRRORBALL_TRY(right, comparedImage(reference, ImageKind::picture));
  MIRRORBALL_TRY(compared, compareImages(std::move(test), std::move(right), ImageKind::picture));
  return PictureError{*compared.value(Metric::flip), *compared.value(Metric::rmse)};
}

fs::path referencePath(const std::string& name) { return sourceFolder() / "references" / (name + ".png"); }

Result<Image> readReference(const std::string& name) { return readPicture(referencePath(name)); }

std::string tracedBy(int paths) { return "--reference --samples " + std::to_string(paths); }

Result<double> parseNoise(const std::string& printed) {
  constexpr std::string_view kBefore = "standard error at most ";
  const std::size_t at = printed.find(kBefore);
  if (at != std::string::npos) {
    const std::size_t begin = at + kBefore.size();
    if (const auto noise = parseNumber(printed.substr(begin, printed.find(' ', begin) - begin))) return *noise;
  }
  return fail(ErrorCode::bad_file, "the path tracer printed no standard error: " + printed);
}

fs::path referenceTablePath() { return sourceFolder() / "hidden_references.txt"; }

fs::path figureTablePath() { return sourceFolder() / "hidden_figures.txt"; }

fs::path firstFigureTablePath() { return sourceFolder() / "hidden_first_figures.txt"; }

}  // namespace mirrorball::quality
