#include "mirrorball/output/map_file.h"

#include <mutex>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/environment/file/recognize.h"
#include "mirrorball/image/value_counts.h"

namespace mirrorball {
namespace {

/// The form that the options ask for beside a projection: a preset's, then changed by what is named.
CubeArrangement changedBy(const MapFileOptions& options, CubeArrangement arrangement) {
  if (options.as_seen) arrangement = asSeen(arrangement);
  arrangement = flipped(arrangement, options.flip);
  return options.face_order ? reordered(arrangement, *options.face_order) : arrangement;
}

/// FormHint's words for the form that the options ask for: "octahedral", "cube:for=unreal,flip=vertical".
std::string hintFor(const MapFileOptions& options, Projection projection) {
  std::string words;
  const auto add = [&](const std::string& word) { words += (words.empty() ? ":" : ",") + word; };
  if (!options.program.empty()) add("for=" + options.program);
  if (options.as_seen) add("as-seen");
  if (options.flip != Flip::none) add("flip=" + std::string(flipNames()[static_cast<std::size_t>(options.flip)]));
  if (options.face_order) {
    std::string order = textOf(*options.face_order);
    std::erase(order, ',');  // which separates words there
    add("order=" + order);
  }
  return textOf(projection) + words;
}

/// What the options say of how a cube lies: "layout vcross, as seen".
std::string wordsOfCubes(const MapFileOptions& options) {
  std::vector<std::string> words;
  if (options.layout) words.push_back("layout " + std::string(nameOf(*options.layout)));
  if (options.as_seen) words.emplace_back("as seen");
  if (options.flip != Flip::none)
    words.push_back("flip " + std::string(flipNames()[static_cast<std::size_t>(options.flip)]));
  if (options.face_order) words.push_back("face order " + textOf(*options.face_order));
  return join(words);
}

/// Of the first level.
ValueCounts countsOf(const ImageSet& images) {
  ValueCounts counts;
  for (int face = 0; face < images.faces(); ++face) counts.add(images.at(0, face));
  return counts;
}

}  // namespace

Result<void> MapFile::setForm(const MapFileOptions& options, Projection projection) {
  form_ = {projection};
  const std::optional<CubeLayout> layout = options.layout;
  if (!options.program.empty()) {
    MIRRORBALL_TRY(preset, presetNamed(options.program));
    MIRRORBALL_TRY(form, formFor(preset, projection, layout.value_or(preset.layout)));
    form_ = form;
    naming_ = preset.naming;
    not_imported_ = importedInstead(preset, projection, extensionOf(path_));
  } else {
    form_.layout = layout.value_or(CubeLayout::hcross);
  }
  const CubeArrangement before = form_.arrangement;
  form_.arrangement = changedBy(options, before);
  hint_ = hintFor(options, projection);
  if (is_texture_) form_.layout = CubeLayout::faces;  // which is what its readers look for
  const bool is_cube = faceCount(projection) == 6;
  if (const std::string words = wordsOfCubes(options); !is_cube && !words.empty())
    return fail(ErrorCode::usage, words + ": that is for cubes, and " + std::string(nameOf(projection)) + " is none");
  if (is_texture_ && layout)
    return fail(ErrorCode::usage,
                path_ + ": holds a cube as such, in no layout; name none, or write .exr, .hdr or .png");
  if (form_.has_texels_on_edges && extensionOf(path_) != "exr")
    return fail(ErrorCode::usage, path_ + ": only .exr says that its texels lie on OpenEXR's edges; write that");
  return {};
}

Result<void> MapFile::setFormat(const MapFileOptions& options) {
  format_ = options.format;
  half_ = format_ == TexelFormat::half;
  if (format_ && !is_texture_) {
    const TexelFormatName& format = kTexelFormatNames[static_cast<std::size_t>(*format_)];
    if (extensionOf(path_) != "exr" || !format.is_in_exr)
      return fail(ErrorCode::usage, path_ + ": cannot hold " + std::string(format.name) + " texels; .exr has " +
                                        join(texelFormatNames("exr"), ", ", " and ") + ", .ktx2 has all formats");
  }
  if (format_ && is_texture_ && !holdsFormat(extensionOf(path_), *format_))
    return fail(ErrorCode::usage, path_ + ": cannot hold " +
                                      std::string(kTexelFormatNames[static_cast<std::size_t>(*format_)].name) +
                                      " texels; .ktx2 has all formats");
  zstandard_level_ = options.zstandard_level;
  if (zstandard_level_ > 0 && extensionOf(path_) != "ktx2")
    return fail(ErrorCode::usage, path_ + ": has no Zstandard compression; .ktx2 has");
  return {};
}

Result<void> MapFile::setPrimaries(const MapFileOptions& options) {
  primaries_ = options.primaries;
  if (primaries_ == OutputPrimaries::rec709) return {};
  MIRRORBALL_TRY_VOID(checkStatesPrimaries(path_, primaries_, {Holds::light, Holds::texture, Holds::picture}));
  if (options.program.empty()) return {};
  MIRRORBALL_TRY(preset, presetNamed(options.program));
  if (preset.reads_primaries) return {};
  return fail(ErrorCode::usage, path_ + ": a file for " + std::string(preset.program) +
                                    " has Rec.709's primaries, since others would not be read there; leave the "
                                    "primaries as they are, or the program out");
}

Result<MapFile> MapFile::resolve(const std::string& path, const MapFileOptions& options, Projection projection,
                                 Observer observer) {
  MIRRORBALL_TRY_VOID(formatToWrite(path, {Holds::light, Holds::texture, Holds::picture}));
  MapFile file;
  file.path_ = path;
  file.observer_ = std::move(observer);
  file.is_texture_ = isTexturePath(path);
  file.display_ = options.display;
  file.gain_map_ = options.gain_map;
  if (options.gain_map) MIRRORBALL_TRY_VOID(checkHoldsGainMap(path));
  MIRRORBALL_TRY_VOID(file.setForm(options, projection));
  MIRRORBALL_TRY_VOID(file.setFormat(options));
  MIRRORBALL_TRY_VOID(file.setLevels(options));
  MIRRORBALL_TRY_VOID(file.setPrimaries(options));
  if (options.is_one_file && file.paths().size() > 1)
    return fail(ErrorCode::usage, path + ": takes one file, and the layout faces writes six; name another layout");
  return file;
}

std::vector<std::string> MapFile::paths() const {
  if (is_texture_ || faceCount(form_.projection) != 6 || form_.layout != CubeLayout::faces) return {path_};
  std::vector<std::string> paths;
  for (const std::string_view ending : endingsOf(naming_)) paths.push_back(suffixed(path_, "_" + std::string(ending)));
  return paths;
}

bool MapFile::takesStrips() const {
  return is_texture_ && !hasLevels() && zstandard_level_ == 0 && faceCount(form_.projection) != 2 &&
         form_.arrangement == CubeArrangement{} && form_.centre == SignedAxis::plus_z;
}

bool MapFile::limitsLight() const { return format_ && *format_ != TexelFormat::float32; }

LostLight MapFile::limitLevels(ImageSet& levels) const {
  LostLight lost;
  for (int level = 0; limitsLight() && level < levels.levels(); ++level)
    for (int face = 0; face < levels.faces(); ++face) {
      Image& image = levels.at(level, face);
      const glm::ivec2 extent(image.width(), image.height());
      const LostLight here = limitLight(form_.projection, extent, {0, 0}, maxOf(*format_), image);
      if (level == 0) lost.add(here);
    }
  return lost;
}

void MapFile::tellLost(const LostLight& light) const {
  if (light.lost > 0.0)
    observer_.tell(RemarkKind::light_lost, path_ + ": " + rangeOf(*format_) +
                                               ", and what is brighter was lowered to that: " + percentOf(light) +
                                               " of the light is lost");
}

void MapFile::tellIfNotImported() const {
  if (not_imported_) observer_.tell(RemarkKind::not_imported, path_ + ": " + *not_imported_);
}

void MapFile::tellDark(const ValueCounts& counts) const {
  if (counts.areTooDarkForHalves())
    observer_.tell(RemarkKind::digits_lost, path_ + ": is so dark that half floats hold few of its digits");
}

Result<TexelFormat> MapFile::inFormat(const std::function<Result<void>(TexelFormat)>& write) const {
  const TexelFormat first = format_.value_or(TexelFormat::half);
  const Result<void> written = write(first);
  if (written) return first;
  if (format_ || written.error().code != ErrorCode::out_of_range) return tl::unexpected<Error>(written.error());
  observer_.tell(RemarkKind::format_widened, path_ + ": holds light that half floats do not; written in 32-bit floats");
  MIRRORBALL_TRY_VOID(write(TexelFormat::float32));
  return TexelFormat::float32;
}

void MapFile::tellNegative(std::size_t negative) const {
  if (negative > 0)
    observer_.tell(RemarkKind::negative_raised, path_ + ": " + countedAre(negative, "value") +
                                                    " negative, which the format does not hold; taken as 0");
}

void MapFile::remarkOnForm() const {
  if (extensionOf(path_) == "dds" && !isRecognizedUnsaid(form_))
    observer_.tell(RemarkKind::form_unsaid, path_ + ": a DDS does not say what map it holds", hint_);
}

std::string MapFile::pictureFormat() const {
  if (extensionOf(path_) == "hdr") return "three channels of a shared exponent";
  return half_ ? "three channels of half floats" : "three channels of 32-bit floats";
}

void MapFile::remarkOnLosses(std::size_t negative) const {
  if (!format_) return;
  tellNegative(negative);
  if (convertedChannels(form_.projection) == 4 && storedFormat(*format_).channels < 4)
    observer_.tell(RemarkKind::alpha_lost, path_ + ": the format holds no alpha; beside the disc is black");
}

Result<void> MapFile::writeByStrips(int size, const std::function<Result<void>(const TakeTexels&)>& convert_to) const {
  const Projection projection = form_.projection;
  LostLight all_lost;
  std::size_t all_negative = 0;
  ValueCounts all_counts;
  std::mutex lost_guard;
  const auto write = [&](TexelFormat format) -> Result<void> {
    all_counts = {};
    MIRRORBALL_TRY(writer, TextureWriter::create(
                               path_, imageSize(projection, size), faceCount(projection), convertedChannels(projection),
                               {.format = format, .metadata = metadataOf(form_), .primaries = primaries_}));
    const auto write_strip = [&](int face, glm::ivec2 begin, const Image& texels) -> Result<void> {
      if (format == TexelFormat::half) {
        ValueCounts counts;
        counts.add(texels);
        const std::scoped_lock lock(lost_guard);
        all_counts.add(counts);
      }
      if (!limitsLight()) return writer.write(face, begin, texels);
      Image limited = texels;
      const LostLight lost = limitLight(projection, imageSize(projection, size), begin, maxOf(*format_), limited);
      const std::size_t negative = refusesNegativeLight(format) ? raiseNegativeLight(limited) : 0;
      {
        const std::scoped_lock lock(lost_guard);
        all_lost.add(lost);
        all_negative += negative;
      }
      return writer.write(face, begin, limited);
    };
    MIRRORBALL_TRY_VOID(convert_to([&](int face, glm::ivec2 begin, const Image& texels) {
      if (primaries_ == OutputPrimaries::rec709) return write_strip(face, begin, texels);
      Image converted = texels;
      convertFromRec709(converted, primaries_);
      return write_strip(face, begin, converted);
    }));
    return writer.commit();
  };
  MIRRORBALL_TRY_VOID(inFormat(write));
  tellDark(all_counts);
  tellLost(all_lost);
  remarkOnLosses(all_negative);
  observer_.tellWritten(path_);
  remarkOnForm();
  return {};
}

bool MapFile::refusesNegative() const {
  return extensionOf(path_) == "hdr" || (format_ && refusesNegativeLight(*format_));
}

Result<TexelFormat> MapFile::writeImages(const ImageSet& images, const Metadata& facts) const {
  Metadata metadata = metadataOf(form_);
  metadata.insert(facts.begin(), facts.end());
  MIRRORBALL_TRY(written, inFormat([&](TexelFormat format) {
                   return writeImageSet(path_, images,
                                        {.format = format,
                                         .zstandard_level = zstandard_level_,
                                         .metadata = metadata,
                                         .primaries = primaries_,
                                         .progress = observer_.progressOf("write")});
                 }));
  observer_.tellWritten(path_);
  return written;
}

void MapFile::convertLight(Image& image) const {
  if (is_texture_ || storesLinearLight(path_)) convertFromRec709(image, primaries_);
}

Result<TexelFormat> MapFile::writeLevels(ImageSet levels, const Metadata& facts) const {
  forEachImage(levels, [&](Image& image) { convertLight(image); });
  tellLost(limitLevels(levels));
  return writeImages(arranged(std::move(levels), form_.arrangement), facts);
}

std::uint64_t MapFile::memoryToWrite(int size) const {
  if (zstandard_level_ == 0) return 0;
  // Whole levels are compressed, into as much memory as they have.
  const StoredFormat format = storedFormat(format_.value_or(TexelFormat::float32));
  const std::uint64_t blocks = blocksAlong(format, std::uint64_t(size));
  return 2 * 6 * blocks * blocks * blockSize(format);
}

Result<void> MapFile::write(EnvironmentMap map) const {
  for (int face = 0; face < map.faces(); ++face) convertLight(map.face(face));
  if (limitsLight()) tellLost(limitLight(map, {.max = maxOf(*format_)}));
  const std::size_t negative = refusesNegative() ? raiseNegativeLight(map) : 0;
  if (!hasLevels()) return writeFiles(imagesOf(std::move(map), form_), negative);
  MIRRORBALL_TRY(levels, levelsOf(std::move(map)));
  return writeFiles(std::move(levels), negative);
}

Result<void> MapFile::write(ImageSet levels) const {
  forEachImage(levels, [&](Image& image) { convertLight(image); });
  tellLost(limitLevels(levels));
  std::size_t negative = 0;
  if (refusesNegative()) forEachImage(levels, [&](Image& image) { negative += raiseNegativeLight(image); });
  MIRRORBALL_TRY(wanted, wantedOf(std::move(levels)));
  return writeFiles(std::move(wanted), negative);
}

Result<void> MapFile::writeFiles(ImageSet images, std::size_t negative) const {
  if (!is_texture_) {
    if (half_) tellDark(countsOf(images));
    tellNegative(negative);
    return writePictures(std::move(images));
  }
  if (images.faces() == 2) images = ImageSet(pictureOfImages(std::move(images), form_));
  MIRRORBALL_TRY(written, writeImages(images));
  if (written == TexelFormat::half) tellDark(countsOf(images));
  remarkOnLosses(negative);
  remarkOnForm();
  return {};
}

}  // namespace mirrorball
