#include "golden/made_picture.h"

#include <filesystem>
#include <utility>

#include "cli/program.h"
#include "fresh_folder.h"
#include "golden/golden_picture.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/metric/comparison.h"

namespace mirrorball::golden {

namespace fs = std::filesystem;

Result<Bytes> pictureMadeBy(const std::string& command) {
  const FreshFolder folder;
  // Dithering would add one code here and there to every comparison.
  const std::string undithered = command.starts_with("render ") ? command + " --dither none" : command;
  fs::create_directory_symlink(fs::path(goldenPath("any")).parent_path(), folder.path() / "pictures");
  fs::create_directory_symlink(fs::path(MIRRORBALL_SOURCE_DIR) / "docs/heights", folder.path() / "heights");
  const testing::Outcome outcome =
      testing::Program({.arguments = split(undithered + " -o picture.png", ' '), .folder = folder.path()}).wait();
  if (outcome.exit_code != 0)
    return fail(ErrorCode::io, "mirrorball " + command + ": ended with exit code " + std::to_string(outcome.exit_code) +
                                   ", signal " + std::to_string(outcome.signal) + ": " + outcome.err);
  return readFile(folder.path() / "picture.png");
}

Result<Image> imageMadeBy(const std::string& command) {
  MIRRORBALL_TRY(file, pictureMadeBy(command));
  MIRRORBALL_TRY(decoded, decodeImage(file));
  return std::move(decoded.image);
}

double psnrOf_db(const Image& drawn, const Image& traced) {
  Result<ComparedImage> test = comparedImage(drawn, ImageKind::picture);
  Result<ComparedImage> truth = comparedImage(traced, ImageKind::picture);
  const Result<Comparison> compared = compareImages(*std::move(test), *std::move(truth), ImageKind::picture);
  return compared->value(Metric::psnr).value();
}

}  // namespace mirrorball::golden
