#include "golden/golden_picture.h"

#include <cstdlib>
#include <string_view>

#include "golden/comparison.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball::golden {
namespace {

namespace fs = std::filesystem;

/// Writes the picture to look at, and says where it is or why it is not.
std::string writtenTo(const fs::path& path, const Image8& picture) {
  std::error_code seen_when_writing;
  fs::create_directories(path.parent_path(), seen_when_writing);
  const Result<void> written = savePicture(path, picture);
  return written ? path.string() : written.error().message;
}

}  // namespace

bool isUpdating() {
  const char* value = std::getenv("MIRRORBALL_UPDATE_GOLDEN");
  return value != nullptr && std::string_view(value) == "1";
}

fs::path goldenPath(const std::string& name) {
  return fs::path(MIRRORBALL_SOURCE_DIR) / "tests/golden/pictures" / (name + ".png");
}

Result<Image8> readGolden(const fs::path& path) {
  const std::string label = path.parent_path().parent_path().filename();
  if (!fs::exists(path))
    return fail(ErrorCode::not_found, path.string() + ": there is no golden picture; to make it: " +
                                          "MIRRORBALL_UPDATE_GOLDEN=1 ./test --module " + label);
  MIRRORBALL_TRY(bytes, readFile(path));
  return withName(path.string(), decodeTexture(bytes));
}

::testing::AssertionResult matchesGolden(const fs::path& path, const Image8& now, const Tolerance& tolerance,
                                         const fs::path& failures) {
  const fs::path sheet = failures / path.filename();
  fs::remove(sheet);
  const Result<Image8> golden = readGolden(path);
  if (!golden)
    return ::testing::AssertionFailure() << golden.error().message << "\n  the picture now: " << writtenTo(sheet, now);
  if (golden->width() != now.width() || golden->height() != now.height())
    return ::testing::AssertionFailure() << "is " << now.width() << "x" << now.height() << ", its golden picture "
                                         << golden->width() << "x" << golden->height()
                                         << "\n  golden | now: " << writtenTo(sheet, contactSheet(*golden, now));
  const Difference difference = differenceOf(*golden, now);
  if (isWithin(difference, tolerance)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "differs from its golden picture by " << textOf(difference)
                                       << "\n  allowed: " << formatNumber(tolerance.maximum) << ", "
                                       << formatNumber(tolerance.mean) << " in the mean (" << tolerance.reason
                                       << ")\n  golden | now | difference x 8: "
                                       << writtenTo(sheet, contactSheet(*golden, now));
}

}  // namespace mirrorball::golden
