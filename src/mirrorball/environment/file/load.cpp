#include "mirrorball/environment/file/load.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/picture_layers.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/cube/cube_edges.h"
#include "mirrorball/environment/cube/face_reading.h"
#include "mirrorball/environment/file/compass_heading.h"
#include "mirrorball/environment/file/cube_files.h"
#include "mirrorball/environment/file/cube_images.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/environment/file/picture_content.h"
#include "mirrorball/environment/file/picture_meaning.h"
#include "mirrorball/image/channel_order.h"
#include "mirrorball/image/resize.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// Whatever a picture has beside its disc, no light comes from there.
void clearBesideDisc(Projection projection, Image& image) {
  if (!hasDisc(projection)) return;
  const glm::vec2 extent(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (!covers(projection, (glm::vec2(x, y) + 0.5f) / extent))
        std::fill_n(image.texel(x, y), image.channels(), 0.0f);
}

/// How six faces in one picture may lie, each in its own place: first by OpenGL's table. Mirrored, a whole cross goes
/// on across its edges as before; in strips each face may be mirrored by itself.
std::vector<CubeArrangement> arrangementsIn(CubeLayout layout) {
  constexpr std::array kPoles{SignedAxis::plus_y, SignedAxis::minus_y};
  constexpr std::array kBack{SignedAxis::minus_z};
  const CubeArrangement ours;
  if (layout == CubeLayout::vcross) return {ours, turned(ours, kBack)};
  if (layout == CubeLayout::hcross) return {ours, turned(ours, kBack), turned(ours, kPoles)};
  return {ours, asSeen(ours), turned(asSeen(ours), kPoles), turned(ours, kPoles)};
}

/// Takes a cube whose form is a guess as the form in which its faces meet.
///
/// other_map    of another form
/// returns      what to say where there is none
template <typename OtherMap>
Result<FormDoubt> decideByEdges(Recognition& recognition, EnvironmentMap& map, OtherMap&& other_map) {
  if (!recognition.is_guess || faceCount(recognition.form.projection) != 6) return FormDoubt{};
  const auto take = [&](const MapForm& form, EnvironmentMap other) {
    map = std::move(other);
    recognition = {form, recognition.told_by + ", and how its edges meet", true};
    return FormDoubt{};
  };
  MapForm form = recognition.form;
  const FaceReading reading = readByEdges(map, arrangementsIn(form.layout));
  form.arrangement = reading.arrangement;
  if (form.arrangement != recognition.form.arrangement) {
    MIRRORBALL_TRY(other, other_map(form));
    return take(form, std::move(other));
  }
  if (reading.fit.meets()) return FormDoubt{};
  if (form.layout == CubeLayout::hcross) {
    form.layout = CubeLayout::lecture;
    MIRRORBALL_TRY(other, other_map(form));
    if (edgeFit(other).meets()) return take(form, std::move(other));
  }
  return reading.fit.isUnlikely() ? makeCubeDoubt(recognition, kFacesJump) : FormDoubt{};
}

/// Takes one eye's half of a stereo picture. A window in the whole means nothing for it.
///
/// errors   bad_shape: the picture is too small; too_large
Result<void> takeHalf(PictureHalf half, bool is_squeezed, DecodedImage& decoded) {
  const glm::ivec2 size = sizeOfHalf({decoded.image.width(), decoded.image.height()}, half);
  if (size.x < 1 || size.y < 1) return fail(ErrorCode::bad_shape, "is too small to be a picture for two eyes");
  MIRRORBALL_TRY_VOID(checkImageMemory(size.x, size.y, decoded.image.channels()));
  decoded.image = cutHalf(decoded.image, half);
  if (is_squeezed) {
    const glm::ivec2 stretched = stretchedSize(size);
    MIRRORBALL_TRY_VOID(checkImageMemory(stretched.x, stretched.y, decoded.image.channels()));
    decoded.image = resized(decoded.image, stretched);
  }
  decoded.window.reset();
  return {};
}

/// The refusal of a picture of a cross's shape that is none.
Error photographError(glm::ivec2 size, const Recognition& recognition) {
  const std::string layout(nameOf(recognition.form.layout));
  return {ErrorCode::bad_shape,
          "is " + sizeText(size) +
              ", and not a cube: it fills the cells that a cross leaves "
              "empty, and its faces would not meet. A photograph does not show all directions: a part "
              "of a panorama is named by {option:from} equirect:fov=HxV, a mirror ball is cut out by "
              "`mirrorball photo`; {option:from} " +
              layout + " reads it as a cube all the same"};
}

/// sphere   the Photo Sphere that its file says it is
Result<LoadedEnvironment> loadPicture(DecodedImage decoded, const std::optional<PhotoSphere>& sphere,
                                      const EnvironmentLoadOptions& options) {
  const glm::ivec2 file_size(decoded.image.width(), decoded.image.height());
  StereoEye eye = chooseEye(decoded.image, decoded.metadata, sphere, options.from);
  if (eye.half) MIRRORBALL_TRY_VOID(takeHalf(*eye.half, eye.is_squeezed, decoded));
  const glm::ivec2 size(decoded.image.width(), decoded.image.height());
  MIRRORBALL_TRY(meaning, readMeaning(size, decoded.metadata, sphere, options.from));
  if (!eye.oddity.empty()) meaning.oddities.push_back(std::move(eye.oddity));
  Recognition& recognition = meaning.recognition;
  MIRRORBALL_TRY(doubt, settleByContent(decoded.image, recognition));
  const bool is_photograph = recognition.is_guess && fillsEmptyCells(decoded.image, recognition.form.layout);
  if (faceCount(recognition.form.projection) == 1) clearBesideDisc(recognition.form.projection, decoded.image);
  MIRRORBALL_TRY(bad, checkNonFinite(decoded.image, options));
  // Before its texels reach others. A map that keeps them is repaired image by image.
  if (options.repair && (meaning.changesPicture() || options.from.rest))
    MIRRORBALL_TRY_VOID(repairNonFinite(decoded.image));
  MIRRORBALL_TRY_VOID(completePanorama(meaning, options.from, decoded));
  const auto mapIn = [&](Image picture, const MapForm& form) -> Result<EnvironmentMap> {
    MIRRORBALL_TRY(images, imagesInPicture(std::move(picture), form));
    if (options.repair) MIRRORBALL_TRY_VOID(repairImages(images));
    return mapOfImages(std::move(images), form);
  };
  // The lecture's cross has faces in cells that are empty in the other.
  const bool is_kept = recognition.is_guess && recognition.form.layout == CubeLayout::hcross;
  MIRRORBALL_TRY(map, mapIn(is_kept ? decoded.image : std::move(decoded.image), recognition.form));
  MIRRORBALL_TRY(edge_doubt, decideByEdges(recognition, map, [&](const MapForm& form) -> Result<EnvironmentMap> {
                   if (form.layout != recognition.form.layout) return mapIn(decoded.image, form);
                   return mapOfImages(imagesOf(map, recognition.form), form);
                 }));
  if (is_photograph && !edge_doubt.message.empty()) return tl::unexpected<Error>(photographError(size, recognition));
  if (is_photograph) edge_doubt = makeCubeDoubt(recognition, kCellsAreFilled);
  if (doubt.message.empty()) doubt = std::move(edge_doubt);
  if (const auto& tilt = meaning.tilt) {
    MIRRORBALL_TRY(level, levelled(std::move(map), tilt->pitch_deg, tilt->roll_deg, recognition.form.centre));
    map = std::move(level);
  }
  decoded.oddities.insert(decoded.oddities.end(), meaning.oddities.begin(), meaning.oddities.end());
  return LoadedEnvironment{.environment = Environment(std::move(map)),
                           .format = decoded.format,
                           .color = decoded.color,
                           .recognition = recognition,
                           .file_size = file_size,
                           .bad_texels = bad,
                           .metadata = std::move(decoded.metadata),
                           .doubt = std::move(doubt),
                           .lacks_gain_map = decoded.gain_map == GainMapUse::lost,
                           .window = std::move(decoded.window),
                           .window_goes_round = meaning.part && meaning.part->crossesSeam(),
                           .is_levelled = meaning.tilt.has_value(),
                           .layers = std::move(decoded.layers),
                           .layer = std::move(decoded.layer),
                           .layer_guess = std::move(decoded.layer_guess),
                           .oddities = std::move(decoded.oddities)};
}

/// "9 mip levels, the first of 2 layers": what else a texture has.
std::string restOf(const ImageSet& texture) {
  std::string rest;
  if (texture.levels() > 1) rest += ", " + std::to_string(texture.levels()) + " mip levels";
  if (texture.layers() > 1) rest += ", the first of " + std::to_string(texture.layers()) + " layers";
  return rest;
}

/// A cube as a GPU has it.
Result<LoadedEnvironment> loadCubeTexture(DecodedImageSet texture, const EnvironmentLoadOptions& options) {
  ImageSet images(1, 6);
  NonFinite bad;
  for (int slot = 0; slot < 6; ++slot) {
    MIRRORBALL_TRY(bad_here, checkNonFinite(texture.images.at(0, slot), options));
    add(bad_here, bad);
    images.at(0, slot) = std::move(texture.images.at(0, slot));
  }
  Recognition recognition = recognizeFaces(texture.metadata, options.from, "its texture, a cube");
  MIRRORBALL_TRY(loaded, cubeFromImages(std::move(images), texture.format + restOf(texture.images), texture.color,
                                        std::move(texture.metadata), std::move(recognition), bad, options));
  loaded.oddities = std::move(texture.oddities);
  return loaded;
}

/// A texture of one face.
Result<LoadedEnvironment> loadPictureTexture(DecodedImageSet texture, const EnvironmentLoadOptions& options) {
  std::string format = texture.format + restOf(texture.images);
  return loadPicture({.image = std::move(texture.images.at(0, 0)),
                      .metadata = std::move(texture.metadata),
                      .format = std::move(format),
                      .color = std::move(texture.color),
                      .oddities = std::move(texture.oddities)},
                     std::nullopt, options);
}

/// Some writers store the faces of a cube as the layers of an array (SiegeEngine/ddsfile#10).
bool mayBeCubeInLayers(const DecodedImageSet& texture, const FormHint& from) {
  const Image& first = texture.images.at(0, 0);
  const auto says_more = [](const auto& entry) { return entry.first.starts_with("mirrorball:"); };
  return texture.images.faces() == 1 && texture.images.layers() == 6 && first.width() == first.height() &&
         from.allowsCube() && from.layout.value_or(CubeLayout::faces) == CubeLayout::faces &&
         std::none_of(texture.metadata.begin(), texture.metadata.end(), says_more);
}

/// The cube in six layers, if the caller names one or their edges meet.
Result<std::optional<LoadedEnvironment>> loadCubeInLayers(const DecodedImageSet& texture,
                                                          const EnvironmentLoadOptions& options) {
  ImageSet faces(1, 6);
  for (int slot = 0; slot < 6; ++slot) faces.at(0, slot) = texture.images.at(0, 0, slot);
  if (!options.from.namesForm()) {
    EnvironmentMap by_slots(Projection::cube, std::move(faces));
    if (!readByEdges(by_slots, possibleArrangements({})).is_proved) return std::nullopt;
    faces = std::move(by_slots).takeImages();
  }
  MIRRORBALL_TRY(loaded, loadCubeTexture({.images = std::move(faces),
                                          .metadata = texture.metadata,
                                          .format = texture.format,
                                          .color = texture.color,
                                          .oddities = texture.oddities},
                                         options));
  if (loaded.recognition->is_guess && loaded.doubt.message.empty())
    loaded.doubt = {"is an array of six pictures, whose edges meet as those of a cube: read as its faces", {"sphere"}};
  return loaded;
}

/// Exchanges red and blue where the caller says so; else names how, where the file leaves it open.
void settleRedAndBlue(const FormHint& from, DecodedImageSet& texture) {
  if (from.swaps_red_and_blue) forEachImage(texture.images, swapRedAndBlue);
  const auto guess = std::find(texture.oddities.begin(), texture.oddities.end(), texture.channel_guess);
  if (guess == texture.oddities.end()) return;
  if (from.swaps_red_and_blue)
    texture.oddities.erase(guess);
  else
    *guess += "; {option:from} swap=rb exchanges them back";
}

Result<LoadedEnvironment> decodeEnvironment(std::span<const std::uint8_t> bytes, const EnvironmentLoadOptions& options,
                                            const ProgressFunction& progress) {
  if (!isImageSet(bytes)) {
    MIRRORBALL_TRY(decoded, decodeImage(bytes, {.layer = options.from.layer, .progress = progress}));
    if (options.from.swaps_red_and_blue) swapRedAndBlue(decoded.image);
    return loadPicture(std::move(decoded), photoSphereIn(bytes), options);
  }
  if (!options.from.layer.empty())
    return fail(ErrorCode::not_found, "is a texture, and has no layer '" + excerpt(options.from.layer) + "'");
  MIRRORBALL_TRY(texture, decodeImageSet(bytes));
  settleRedAndBlue(options.from, texture);
  FormDoubt doubt;
  if (mayBeCubeInLayers(texture, options.from)) {
    doubt = {"is an array of six pictures, whose edges do not show that they are a cube: the first is read", {"cube"}};
    MIRRORBALL_TRY(cube, loadCubeInLayers(texture, options));
    if (cube) return std::move(*cube);
  }
  const int levels = texture.images.levels();
  auto loaded = texture.images.faces() == 6 ? loadCubeTexture(std::move(texture), options)
                                            : loadPictureTexture(std::move(texture), options);
  if (!loaded) return loaded;
  // The levels of two circles are none of the panorama's.
  if (!options.from.fisheye) loaded->levels = levels;
  if (!doubt.message.empty()) loaded->doubt = std::move(doubt);
  return loaded;
}

Result<LoadedEnvironment> loadFile(const std::string& path, const EnvironmentLoadOptions& options,
                                   const ProgressFunction& progress) {
  MIRRORBALL_TRY(bytes, readImageFile(path));
  MIRRORBALL_TRY(loaded, withName(path, decodeEnvironment(bytes, options, progress)));
  loaded.files = {path};
  return loaded;
}

void tellOddities(const std::string& name, const std::vector<std::string>& oddities, const std::string& layer_guess,
                  const Observer& observer) {
  for (const std::string& oddity : withOtherLayer(oddities, layer_guess, "{option:from} layer=NAME"))
    observer.tell(RemarkKind::file_odd, name + ": " + oddity);
}

void tellDoubt(const std::string& name, const FormDoubt& doubt, const Observer& observer) {
  if (!doubt.message.empty())
    observer.tell(RemarkKind::form_doubted, name + ": " + doubt.message, join(doubt.other_forms, "|"));
}

Result<LoadedEnvironment> loadAsItIs(const std::string& name_or_path, const EnvironmentLoadOptions& options,
                                     const ProgressFunction& progress) {
  std::error_code status;
  if (isUrl(name_or_path)) return tl::unexpected<Error>(downloadsNothing(name_or_path));
  const bool exists = fs::exists(name_or_path, status);
  // A folder that happens to be called "studio" is no map.
  if (isBuiltinEnvironment(name_or_path) && (!exists || fs::is_directory(name_or_path, status))) {
    MIRRORBALL_TRY(environment, builtinEnvironment(name_or_path));
    return LoadedEnvironment{.environment = std::move(environment), .format = "built in", .color = "linear, Rec.709"};
  }
  if (fs::is_directory(name_or_path, status)) {
    if (!options.from.allowsCube())
      return fail(ErrorCode::usage, name_or_path + ": is a folder; only a cube's six files may be named so");
    MIRRORBALL_TRY(files, faceFilesIn(fs::path(name_or_path)));
    return loadFaces(name_or_path, files, options);
  }
  MIRRORBALL_TRY(cube, loadCubeAround(name_or_path, options));
  if (cube) return std::move(*cube);
  if (options.from.layout == CubeLayout::faces)
    return fail(ErrorCode::usage, name_or_path +
                                      ": name one of the six faces, whose names end in _px _nx _py _ny _pz _nz "
                                      "or as docs/conventions.md says");
  if (!exists) return tl::unexpected<Error>(noSuchEnvironment(name_or_path));
  MIRRORBALL_TRY(loaded, loadFile(name_or_path, options, progress));
  remarkOtherFaces(name_or_path, loaded);
  return loaded;
}

}  // namespace

OptionText environmentText(std::string_view help) {
  return {.name = "env",
          .value = "ENV",
          .help = help,
          .letter = "e",
          .group = "Files",
          .takes_path = true,
          .is_daily = true,
          .names = builtinEnvironmentNames};
}

OptionText formText(std::string_view help, std::string_view group) {
  return {.name = "from", .value = "FORM", .help = help, .group = group, .names = readFormNames};
}

Result<LoadedEnvironment> loadEnvironment(const std::string& name_or_path, const EnvironmentLoadOptions& options,
                                          const ProgressFunction& progress) {
  MIRRORBALL_TRY(loaded, loadAsItIs(name_or_path, options, progress));
  loaded.name = name_or_path;
  loaded.lost = limitLight(loaded.environment, options.light);
  return loaded;
}

Result<std::optional<ImageSet>> loadLevels(const LoadedEnvironment& loaded, const MapForm& form,
                                           const EnvironmentLoadOptions& options) {
  if (loaded.levels == 1) return std::nullopt;
  const MapForm& own = loaded.recognition->form;
  MIRRORBALL_TRY(texture, readImageSet(loaded.name));
  settleRedAndBlue(options.from, texture);
  const int faces = texture.images.faces();
  if (faces != faceCount(own.projection) || hasDisc(own.projection) || own.has_texels_on_edges) return std::nullopt;
  const Image& largest = texture.images.at(0, 0);
  if (loaded.environment.map()->extent() != glm::ivec2(largest.width(), largest.height())) return std::nullopt;
  ImageSet levels(texture.images.levels(), faces);
  for (int level = 0; level < levels.levels(); ++level)
    for (int face = 0; face < faces; ++face) {
      const std::string name = loaded.name + ", level " + std::to_string(level);
      Image& image = levels.at(level, face) = rgbOf(texture.images.at(level, face));
      MIRRORBALL_TRY_VOID(withName(name, checkNonFinite(image, options)));
      if (options.repair) MIRRORBALL_TRY_VOID(withName(name, repairNonFinite(image)));
      limitLight(own.projection, options.light, image);
    }
  // Small levels of a panorama cannot be turned without being resampled.
  if (own.centre == form.centre && own.arrangement == form.arrangement) return levels;
  return imagesOf(levelsOfImages(std::move(levels), own), form);
}

Result<std::optional<PanoramaRows>> openPanorama(const std::string& name_or_path,
                                                 const EnvironmentLoadOptions& options) {
  std::error_code status;
  if (options.repair || options.from.swaps_red_and_blue || !options.light.areNone() ||
      !fs::is_regular_file(name_or_path, status) || cubeFilesOf(name_or_path, options.from))
    return std::nullopt;
  MIRRORBALL_TRY(rows, openRows(name_or_path, {.layer = options.from.layer}));
  if (!rows) return std::nullopt;
  const RowReader::Description& picture = rows->description();
  MIRRORBALL_TRY(ends, readEnds(name_or_path));
  const auto sphere = photoSphereIn(ends);
  const glm::ivec2 size(picture.width, picture.height);
  if (mayBeStereo(size, sphere, options.from)) return std::nullopt;
  MIRRORBALL_TRY(meaning, withName(name_or_path, readMeaning(size, picture.metadata, sphere, options.from)));
  const MapForm& form = meaning.recognition.form;
  if (!isPlainPanorama(form) || meaning.changesPicture() || options.from.rest) return std::nullopt;
  const glm::mat3 picture_from_world = glm::transpose(centredOn(vectorOf(form.centre)));
  return PanoramaRows{std::move(rows), picture_from_world, std::move(meaning.oddities), std::move(meaning.recognition)};
}

void tellAbout(const PanoramaRows& panorama, const std::string& name, const Observer& observer) {
  const RowReader::Description& picture = panorama.rows->description();
  std::vector<std::string> oddities = picture.oddities;
  if (picture.window) adviseOnRest(*picture.window, oddities);
  oddities.insert(oddities.end(), panorama.oddities.begin(), panorama.oddities.end());
  tellOddities(name, oddities, picture.layer_guess, observer);
  tellDoubt(name, panorama.doubt, observer);
}

void tellAbout(const LoadedEnvironment& loaded, const Observer& observer) {
  tellOddities(loaded.name, loaded.oddities, loaded.layer_guess, observer);
  tellDoubt(loaded.name, loaded.doubt, observer);
  if (loaded.lacks_gain_map)
    observer.tell(RemarkKind::gain_map_lost,
                  loaded.name +
                      ": says that it has a gain map, and has lost it: read as the picture alone, without "
                      "light brighter than white");
  tellLimited(loaded.name, loaded.lost, observer);
}

}  // namespace mirrorball
