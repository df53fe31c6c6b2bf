#include "mirrorball/environment/file/cube_files.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <utility>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/cube/face_reading.h"
#include "mirrorball/environment/file/cube_images.h"
#include "mirrorball/environment/file/header_size.h"
#include "mirrorball/image/channel_order.h"
#include "mirrorball/image/resize.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

Result<void> checkIsSquare(const Image& face) {
  if (face.width() == face.height()) return {};
  return fail(ErrorCode::bad_shape,
              "is " + sizeText({face.width(), face.height()}) + ", and the six faces of a cube are squares");
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

/// What is read of six files.
struct FaceImages {
  ImageSet images{1, 6};
  std::string format = {};
  std::string color = {};
  Metadata metadata = {};  ///< of the first
  NonFinite bad = {};
  bool lacks_gain_map = false;
  std::vector<std::string> halves = {};  ///< names of files that hold the upper half of a face
  glm::ivec2 size_of_halves{0};
  std::vector<std::string> oddities = {};
};

/// One of six files.
struct FaceFile {
  std::size_t slot;
  std::string name;  ///< without its folder
  bool may_be_half;  ///< the upper half of a face
};

/// Whether an image is the upper half of one of a cube's sides, by its shape.
bool isUpperHalf(const Image& image, const FaceFrame& frame) {
  return image.width() == 2 * image.height() && frame.down == SignedAxis::minus_y;
}

/// A square whose upper half is a picture, below which its last row goes on: what a GPU shows there that clamps texture
/// coordinates, as programs with such skies have it.
///
/// errors   too_large
Result<Image> squareFromUpperHalf(const Image& half) {
  MIRRORBALL_TRY_VOID(checkImageMemory(half.width(), half.width(), half.channels()));
  Image square = Image::withoutValues(half.width(), half.width(), half.channels());
  for (int y = 0; y < square.height(); ++y) {
    const auto row = half.row(std::min(y, half.height() - 1));
    std::copy(row.begin(), row.end(), square.texel(0, y));
  }
  return square;
}

/// Takes the picture of a face in.
///
/// errors   non_finite; bad_shape; too_large
Result<void> takeFace(DecodedImage decoded, const FaceFile& file, const CubeArrangement& arrangement,
                      const EnvironmentLoadOptions& options, FaceImages& faces) {
  if (options.from.swaps_red_and_blue) swapRedAndBlue(decoded.image);
  MIRRORBALL_TRY(bad, checkNonFinite(decoded.image, options));
  add(bad, faces.bad);
  if (file.may_be_half && isUpperHalf(decoded.image, arrangement.slots[file.slot])) {
    faces.halves.push_back(file.name);
    faces.size_of_halves = {decoded.image.width(), decoded.image.height()};
    MIRRORBALL_TRY(square, squareFromUpperHalf(decoded.image));
    decoded.image = std::move(square);
  }
  MIRRORBALL_TRY_VOID(checkIsSquare(decoded.image));
  faces.images.at(0, static_cast<int>(file.slot)) = std::move(decoded.image);
  faces.format = std::move(decoded.format);
  faces.color = std::move(decoded.color);
  faces.lacks_gain_map = faces.lacks_gain_map || decoded.gain_map == GainMapUse::lost;
  for (const std::string& oddity : decoded.oddities) faces.oddities.push_back(file.name + " " + oddity);
  return {};
}

/// The remark on sides of half a height.
void remarkHalves(FaceImages& faces) {
  if (faces.halves.empty()) return;
  const bool is_one = faces.halves.size() == 1;
  faces.oddities.push_back(
      join(faces.halves, ", ", " and ") + (is_one ? " is " : " are ") + sizeText(faces.size_of_halves) +
      ": taken as the upper half of " +
      (is_one ? "a face, below which its last row goes on" : "faces, below which their last rows go on"));
}

/// Makes the missing lower face of one colour: the mean of the lowest rows of the sides.
///
/// errors   not_found: the arrangement has another face in its place; too_large
Result<void> fillBottom(const FaceFiles& files, const CubeArrangement& arrangement, FaceImages& faces) {
  const std::string missing = files.paths[kBottomFace].filename().string();
  if (arrangement.slots[kBottomFace].centre != SignedAxis::minus_y)
    return fail(ErrorCode::not_found, "holds five of the six faces of a cube, without " + missing);
  glm::dvec3 sum(0.0);
  int count = 0;
  for (std::size_t slot = 0; slot < files.paths.size(); ++slot) {
    const Image& side = faces.images.at(0, static_cast<int>(slot));
    if (slot == kBottomFace || arrangement.slots[slot].down != SignedAxis::minus_y) continue;
    for (int x = 0; x < side.width(); ++x) {
      const glm::dvec3 light(rgbAt(side, x, side.height() - 1));
      if (!std::isfinite(light.x + light.y + light.z)) continue;
      sum += light;
      ++count;
    }
  }
  const glm::vec3 mean(sum / double(std::max(count, 1)));
  const int side = faces.images.at(0, 0).width();
  MIRRORBALL_TRY_VOID(checkImageMemory(side, side, 3));
  Image& bottom = faces.images.at(0, static_cast<int>(kBottomFace)) = Image(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) std::copy_n(&mean.x, 3, bottom.texel(x, y));
  faces.oddities.push_back("is a cube without its lower face, " + missing +
                           ": filled with the mean light of the lowest rows of its sides");
  return {};
}

/// The form of six files by their metadata or their names.
Result<Recognition> recognizeNamedFaces(const FaceFiles& files, const Metadata& metadata, const FormHint& hint) {
  Recognition recognition = recognizeFaces(metadata, hint, "its name, one of six faces " + textOf(files.naming));
  if (recognition.is_guess) {
    MIRRORBALL_TRY(by_name, formHintNamed(usualReading(files.naming)));
    recognition.form.arrangement = by_name.arrangement;
  }
  return recognition;
}

/// Whether no header among those of six files states that its picture is not square.
bool areSquaresByHeader(const FaceFiles& files) {
  return std::none_of(files.paths.begin(), files.paths.end(), [](const fs::path& path) {
    const auto size = sizeInHeader(path);
    return size && size->x != size->y;
  });
}

}  // namespace

std::optional<FaceFiles> cubeFilesOf(const std::string& path, const FormHint& from) {
  const auto files = faceFilesBeside(path);
  if (!files || from.layout == CubeLayout::faces) return files;
  // A name that only happens to end like a face's, such as the left of two pictures, stands for itself.
  const bool has_siblings = files->present > 3;
  return has_siblings && from.allowsCube() && !from.layout ? files : std::nullopt;
}

Result<LoadedEnvironment> loadFaces(const std::string& name, const FaceFiles& files,
                                    const EnvironmentLoadOptions& options) {
  FaceImages faces;
  Recognition recognition;
  const bool lacks_bottom = lacksBottomAlone(files);
  for (std::size_t slot = 0; slot < files.paths.size(); ++slot) {
    if (lacks_bottom && slot == kBottomFace) continue;
    const std::string path = files.paths[slot].string();
    MIRRORBALL_TRY(decoded, readImage(path, {.layer = options.from.layer}));
    if (slot == 0) {
      faces.metadata = std::move(decoded.metadata);
      MIRRORBALL_TRY(named, recognizeNamedFaces(files, faces.metadata, options.from));
      recognition = std::move(named);
    }
    MIRRORBALL_TRY_VOID(
        withName(path, takeFace(std::move(decoded), {slot, fs::path(path).filename().string(), !isCommon(files.naming)},
                                recognition.form.arrangement, options, faces)));
  }
  remarkHalves(faces);
  if (lacks_bottom) MIRRORBALL_TRY_VOID(withName(name, fillBottom(files, recognition.form.arrangement, faces)));
  MIRRORBALL_TRY_VOID(withName(name, equalizeFaces(files, faces.images, faces.oddities)));
  MIRRORBALL_TRY(loaded,
                 withName(name, cubeFromImages(std::move(faces.images), std::move(faces.format), std::move(faces.color),
                                               std::move(faces.metadata), std::move(recognition), faces.bad, options,
                                               isCommon(files.naming))));
  if (loaded.recognition->is_guess && loaded.doubt.message.empty())
    loaded.doubt = makeFacesDoubt(name, files, loaded.recognition->form.arrangement);
  loaded.lacks_gain_map = faces.lacks_gain_map;
  loaded.oddities = std::move(faces.oddities);
  // Without another form to name, it is no doubt.
  if (loaded.doubt.other_forms.empty() && !loaded.doubt.message.empty())
    loaded.oddities.push_back(std::exchange(loaded.doubt.message, {}));
  for (std::size_t slot = 0; slot < files.paths.size(); ++slot)
    if (!lacks_bottom || slot != kBottomFace) loaded.files.push_back(files.paths[slot].string());
  return loaded;
}

Result<std::optional<LoadedEnvironment>> loadCubeAround(const std::string& path,
                                                        const EnvironmentLoadOptions& options) {
  const auto files = cubeFilesOf(path, options.from);
  if (!files) return std::nullopt;
  std::error_code status;
  if (files->present < 6 && !(lacksBottomAlone(*files) && fs::exists(path, status)))
    return fail(
        ErrorCode::not_found,
        path + ": is one of the six faces of a cube, without " + listFaces(*files, false) + "; put all in one folder",
        FixHint::name_form);
  const bool may_be_others = isCommon(files->naming) && options.from.layout != CubeLayout::faces;
  // Six panoramas need not be decoded to see that.
  if (may_be_others && !areSquaresByHeader(*files)) return std::nullopt;
  auto loaded = loadFaces(path, *files, options);
  if (may_be_others && !(loaded && readByEdges(*loaded->environment.map(), possibleArrangements({})).is_proved))
    return std::nullopt;
  if (!loaded) return fail(std::move(loaded));
  return std::move(*loaded);
}

void remarkOtherFaces(const std::string& path, LoadedEnvironment& loaded) {
  const Recognition& recognition = *loaded.recognition;
  if (recognition.form.projection != Projection::sphere || !recognition.is_by_shape) return;
  const auto files = faceFilesBeside(path);
  if (!files) return;
  if (isCommon(files->naming))
    loaded.doubt = {
        "has a name like five pictures beside it, without a sign that the six are a cube: read alone, as a "
        "sphere map",
        {"faces"}};
  else
    loaded.doubt.message = "is named like one of the six faces of a cube, of which " + listFaces(*files, false) +
                           (files->present == 5 ? " is" : " are") + " missing: read alone, as a sphere map";
}

}  // namespace mirrorball
