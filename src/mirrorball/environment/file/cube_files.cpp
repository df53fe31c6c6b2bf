#include "mirrorball/environment/file/cube_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/cube/face_reading.h"
#include "mirrorball/environment/file/cube_images.h"
#include "mirrorball/image/resize.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

Result<void> checkIsSquare(const Image& face) {
  if (face.width() == face.height()) return {};
  return fail(ErrorCode::bad_shape, "is " + std::to_string(face.width()) + "x" + std::to_string(face.height()) +
                                        ", and the six faces of a cube are squares");
}

/// Brings six squares to the largest side among them: skies for Quake have a small bottom of one colour
/// (DaemonEngine/Daemon#179). Where some have fewer channels than others, all become three.
///
/// errors   too_large
Result<void> equalizeFaces(const FaceFiles& files, ImageSet& images, std::vector<std::string>& oddities) {
  int side = 0;
  bool has_equal_channels = true;
  forEachImage(images, [&](const Image& image) {
    side = std::max(side, image.width());
    has_equal_channels = has_equal_channels && image.channels() == images.at(0, 0).channels();
  });
  const std::uint64_t texels = 6 * std::uint64_t(side) * std::uint64_t(side);
  const int channels = has_equal_channels ? images.at(0, 0).channels() : 3;
  MIRRORBALL_TRY_VOID(checkMemory(texels * std::uint64_t(channels) * sizeof(float)));
  for (int slot = 0; slot < 6; ++slot) {
    Image& image = images.at(0, slot);
    if (!has_equal_channels) image = rgbOf(image);
    if (image.width() == side) continue;
    const std::string own = std::to_string(image.width());
    const std::string others = std::to_string(side);
    oddities.push_back(files.paths[static_cast<std::size_t>(slot)].filename().string() + " is " + own + "x" + own +
                       ", and the largest of the six faces is " + others + "x" + others + ": enlarged");
    image = resized(image, glm::ivec2(side));
  }
  return {};
}

/// The remark on six files that do not state that they are a cube, nor how they lie.
///
/// name     that of one of them, or of their folder
FormDoubt makeFacesDoubt(const std::string& name, const FaceFiles& files, const CubeArrangement& arrangement) {
  const auto mirrored = mirrorReading(arrangement);
  const std::string others = listFaces(files, true, name);
  const bool is_one = std::find(files.paths.begin(), files.paths.end(), fs::path(name)) != files.paths.end();
  FormDoubt doubt;
  doubt.message =
      is_one ? "is read as one of the six faces of a cube, with " + others : "holds the six faces of a cube, " + others;
  doubt.message +=
      arrangement == CubeArrangement{} ? ", by OpenGL's table" : ", as " + hintForFaces(arrangement) + " has them";
  if (mirrored) {
    doubt.message += "; their edges meet in the mirrored world, too";
    doubt.other_forms.push_back(hintForFaces(*mirrored));
  }
  if (is_one) doubt.other_forms.emplace_back("sphere");
  return doubt;
}

}  // namespace

bool mayBeCube(const FormHint& from) { return !from.projection || faceCount(*from.projection) == 6; }

std::optional<FaceFiles> cubeFilesOf(const std::string& path, const FormHint& from) {
  const auto files = faceFilesBeside(path);
  if (!files || from.layout == CubeLayout::faces) return files;
  // A name that only happens to end like a face's, such as the left of two pictures, stands for itself.
  const bool has_siblings = files->present > 3;
  return has_siblings && mayBeCube(from) && !from.layout ? files : std::nullopt;
}

Result<LoadedEnvironment> loadFaces(const std::string& name, const FaceFiles& files,
                                    const EnvironmentLoadOptions& options) {
  ImageSet images(1, 6);
  Recognition recognition;
  std::string format;
  std::string color;
  Metadata metadata;
  NonFinite bad;
  bool lacks_gain_map = false;
  std::vector<std::string> oddities;
  for (int slot = 0; slot < 6; ++slot) {
    const std::string path = files.paths[static_cast<std::size_t>(slot)].string();
    MIRRORBALL_TRY(decoded, readImage(path, {.layer = options.from.layer}));
    MIRRORBALL_TRY(bad_here, withName(path, checkNonFinite(decoded.image, options)));
    if (slot == 0) {
      metadata = std::move(decoded.metadata);
      recognition = recognizeFaces(metadata, options.from, "its name, one of six faces " + textOf(files.naming));
      if (recognition.is_guess) {
        MIRRORBALL_TRY(by_name, formHintNamed(usualReading(files.naming)));
        recognition.form.arrangement = by_name.arrangement;
      }
    }
    add(bad_here, bad);
    MIRRORBALL_TRY_VOID(withName(path, checkIsSquare(decoded.image)));
    images.at(0, slot) = std::move(decoded.image);
    format = decoded.format;
    color = decoded.color;
    lacks_gain_map = lacks_gain_map || decoded.gain_map == GainMapUse::lost;
    for (const std::string& oddity : decoded.oddities)
      oddities.push_back(fs::path(path).filename().string() + " " + oddity);
  }
  MIRRORBALL_TRY_VOID(withName(name, equalizeFaces(files, images, oddities)));
  MIRRORBALL_TRY(
      loaded, withName(name, cubeFromImages(std::move(images), std::move(format), std::move(color), std::move(metadata),
                                            std::move(recognition), bad, options, isCommon(files.naming))));
  if (loaded.recognition->is_guess && loaded.doubt.message.empty())
    loaded.doubt = makeFacesDoubt(name, files, loaded.recognition->form.arrangement);
  loaded.lacks_gain_map = lacks_gain_map;
  loaded.oddities = std::move(oddities);
  // Without another form to name, it is no doubt.
  if (loaded.doubt.other_forms.empty() && !loaded.doubt.message.empty())
    loaded.oddities.push_back(std::exchange(loaded.doubt.message, {}));
  loaded.files.assign(files.paths.begin(), files.paths.end());
  return loaded;
}

Result<std::optional<LoadedEnvironment>> loadCubeAround(const std::string& path,
                                                        const EnvironmentLoadOptions& options) {
  const auto files = cubeFilesOf(path, options.from);
  if (!files) return std::nullopt;
  if (files->present < 6)
    return fail(
        ErrorCode::not_found,
        path + ": is one of the six faces of a cube, without " + listFaces(*files, false) + "; put all in one folder",
        FixHint::name_form);
  auto loaded = loadFaces(path, *files, options);
  if (isCommon(files->naming) && options.from.layout != CubeLayout::faces &&
      !(loaded && readByEdges(*loaded->environment.map(), possibleArrangements({})).is_proved))
    return std::nullopt;
  if (!loaded) return fail(std::move(loaded));
  return std::move(*loaded);
}

void tellOfOtherFaces(const std::string& path, LoadedEnvironment& loaded) {
  const Recognition& recognition = *loaded.recognition;
  if (recognition.form.projection != Projection::sphere || !recognition.told_by.starts_with("its shape")) return;
  const auto files = faceFilesBeside(path);
  if (!files) return;
  if (isCommon(files->naming))
    loaded.doubt = {
        "has a name like five pictures beside it, without a sign that the six are a cube: read alone, as a "
        "sphere map",
        {"faces"}};
  else
    loaded.oddities.push_back("is named like one of the six faces of a cube, of which " + listFaces(*files, false) +
                              (files->present == 5 ? " is" : " are") + " missing: read alone, as a sphere map");
}

}  // namespace mirrorball
