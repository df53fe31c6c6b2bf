#include "cli/map_output.h"

#include <array>
#include <cstdio>
#include <mutex>
#include <utility>

#include "cli/files.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/environment/file/recognize.h"

namespace mirrorball::cli {
namespace {

/// The names of formats, of those that a picture in .exr has or of all.
std::vector<std::string_view> formatNames(bool only_of_exr) {
  std::vector<std::string_view> names;
  for (const TexelFormatName& format : kTexelFormatNames)
    if (format.is_in_exr || !only_of_exr) names.push_back(format.name);
  return names;
}

/// "float16=half|fp16=half": the other names.
std::string formatAliases() {
  std::string aliases;
  for (const TexelFormatName& format : kTexelFormatNames)
    for (const std::string& also : split(format.also, ' '))
      aliases += (aliases.empty() ? "" : "|") + also + "=" + std::string(format.name);
  return aliases;
}

const std::string kFormatChoices = "auto|" + join(formatNames(false), "|");
const std::string kFormatAliases = formatAliases();
const std::string kFormatHelp = "of texels: " + join(formatNames(true), ", ", " or ") + " in .exr; " +
                                join(formatNames(false), ", ", " or ") + " in " +
                                writtenExtensions(Holds::texture, " and ") +
                                "; auto is float32 in .exr, in textures half where it holds all values; bc6h is "
                                "compressed to a byte a texel";

constexpr ChoiceField<MapOutputOptions> kFormatField{
    [](const MapOutputOptions& options) { return options.format ? static_cast<int>(*options.format) + 1 : 0; },
    [](MapOutputOptions& options, int index) {
      options.format = index > 0 ? std::optional(static_cast<TexelFormat>(index - 1)) : std::nullopt;
    }};

const std::string kProgramHelp = "as that program wants it: " + join(presetNames(), " ");
const std::string kLayoutHelp =
    "of a cube in pictures: " + join(cubeLayoutNames()) + " (faces are six files); else as --for has it, or hcross";

const std::string kMapHelp = "needed: " + writtenExtensions(Holds::light) + " (linear radiance), " +
                             writtenExtensions(Holds::texture) + " (textures; cubes as such), " +
                             writtenExtensions(Holds::picture) +
                             " (sRGB, clipped to [0, 1]); -.exr is standard output, in any of these formats";
const std::string kMipsHelp =
    "all mip levels: " + writtenExtensions(Holds::texture, " and ") +
    " hold them, a picture shows them on one sheet, the smaller ones beside or below the first";
// First those that any texture of a cube may be asked for.
constexpr std::size_t kTextureOptions = 9;
const std::array<Option<MapOutputOptions>, 13> kMapOutputOptions{{
    {{.name = "output", .value = "OUT", .help = kMapHelp, .letter = "o", .group = "Output", .takes_path = true},
     &MapOutputOptions::output},
    {{.name = "for", .value = "PROGRAM", .help = kProgramHelp, .group = "Output", .names = presetNames},
     &MapOutputOptions::program},
    {{.name = "as-seen",
      .help = "cube faces as pictures seen from inside, not by OpenGL's left-handed table",
      .group = "Output"},
     &MapOutputOptions::as_seen},
    {{.name = "flip",
      .value = "none|horizontal|vertical|both",
      .help = "turns each cube face over, after --for and --as-seen",
      .group = "Output",
      .names = flipNames},
     &MapOutputOptions::flip},
    {{.name = "face-order",
      .value = "ORDER",
      .help = "which face is the first, second, … sixth: +x,-x,+y,-y,+z,-z is the usual order",
      .group = "Output"},
     &MapOutputOptions::face_order},
    {{.name = "format",
      .value = "FORMAT",
      .choices = kFormatChoices,
      .aliases = kFormatAliases,
      .help = kFormatHelp,
      .group = "Output"},
     kFormatField},
    {{.name = "zstd",
      .value = "LEVEL",
      .minimum = 0,
      .maximum = 22,
      .help = "Zstandard compression of .ktx2: 1 fast … 22 small, 0 none",
      .group = "Output"},
     &MapOutputOptions::zstandard_level},
    {{.name = "scale-light",
      .value = "FACTOR",
      .minimum = 1e-30,
      .maximum = 1e30,
      .help = "takes all light times FACTOR, before anything else is done with it",
      .group = "Output"},
     &MapOutputOptions::scale_light},
    {{.name = "clamp-light",
      .value = "MAX",
      .unit = "radiance",
      .minimum = 0,
      .maximum = 1e38,
      .help = "then lowers texels that are brighter in any channel to MAX, their hue kept; 0: none",
      .group = "Output"},
     &MapOutputOptions::clamp_light},
    {{.name = "layout", .value = "LAYOUT", .help = kLayoutHelp, .group = "Output", .names = cubeLayoutNames},
     &MapOutputOptions::layout},
    {{.name = "mips", .help = kMipsHelp, .group = "Output"}, &MapOutputOptions::mips},
    {{.name = "level",
      .value = "N",
      .minimum = 0,
      .maximum = 30,
      .help = "one mip level instead of the map; 0 is the map itself, each next one half as large",
      .group = "Output"},
     &MapOutputOptions::level},
    {{.name = "mip",
      .choices = "auto|solid-angle|box",
      .help = "how a mip level's texels weigh: by their solid angle, or all alike (plain 2 x 2 boxes); auto is "
              "solid-angle, but keeps the levels of a texture whose map stays as it is",
      .group = "Output"},
     choiceField<&MapOutputOptions::mip_source>},
}};

/// The form that the options ask for beside a projection: a preset's, then changed by what is named.
Result<CubeArrangement> changedBy(const MapOutputOptions& options, CubeArrangement arrangement) {
  if (options.as_seen) arrangement = asSeen(arrangement);
  MIRRORBALL_TRY(flip, flipNamed(options.flip));
  arrangement = flipped(arrangement, flip);
  if (options.face_order.empty()) return arrangement;
  MIRRORBALL_TRY(order, faceOrderNamed(options.face_order));
  return reordered(arrangement, order);
}

/// What --from calls the form that the options ask for: "octahedral", "cube:for=unreal,flip=vertical".
std::string hintFor(const MapOutputOptions& options, Projection projection) {
  std::string words;
  const auto add = [&](const std::string& word) { words += (words.empty() ? ":" : ",") + word; };
  if (!options.program.empty()) add("for=" + options.program);
  if (options.as_seen) add("as-seen");
  if (options.flip != "none") add("flip=" + options.flip);
  if (!options.face_order.empty()) {
    std::string order = options.face_order;
    std::erase(order, ',');  // which separates words there
    add("order=" + order);
  }
  return textOf(projection) + words;
}

/// "14 %", "5.8 %" or "less than 0.01 %"
std::string percentOf(const LostLight& light) {
  const double percent = 100.0 * light.share();
  if (percent < 0.01) return "less than 0.01 %";
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), percent < 10.0 ? "%.2g %%" : "%.0f %%", percent);
  return text.data();
}

}  // namespace

std::span<const Option<MapOutputOptions>> mapOutputOptions() { return kMapOutputOptions; }

std::span<const Option<MapOutputOptions>> textureOutputOptions() {
  return mapOutputOptions().subspan(1, kTextureOptions - 1);
}

Result<Projection> projectionToWrite(const std::string& name) {
  const auto projection = projectionNamed(name);
  if (projection) return projection;
  if (const auto layout = cubeLayoutNamed(name))
    return fail(ErrorCode::usage,
                "--to " + name + ": that is a layout of cubes; say --to cube --layout " + std::string(nameOf(*layout)));
  return projection;
}

LightLimits lightLimits(const MapOutputOptions& options) {
  LightLimits limits{.scale = options.scale_light};
  if (options.clamp_light > 0.0f) limits.max = options.clamp_light;
  return limits;
}

void tellClamped(const std::string& name, const LostLight& light) {
  if (light.lost > 0.0) remark(name + ": --clamp-light takes " + percentOf(light) + " of the light");
}

Result<void> checkMapOutput(const MapOutputOptions& options, const std::string& output) {
  MIRRORBALL_TRY_VOID(formatToWrite(output, {Holds::light, Holds::texture, Holds::picture}));
  const bool has_levels = options.mips || options.level;
  if (!has_levels && options.mip_source != MipSource::automatic)
    return fail(ErrorCode::usage,
                "--mip says how mip levels are made, and there are none without --mips or --level; add one");
  if (options.mips && options.level)
    return fail(ErrorCode::usage, "--mips is for all mip levels and --level for one; leave one of them out");
  const float factor = options.display.exposure();
  return refusePictureOptions(
      options.given, output,
      factor == 1.0f ? "" : ", or scale the light: --scale-light " + formatNumber(double(factor)));
}

Result<void> MapOutput::setForm(const MapOutputOptions& options, Projection projection) {
  form_ = {projection};
  std::optional<CubeLayout> layout;
  if (!options.layout.empty()) {
    MIRRORBALL_TRY(named, cubeLayoutNamed(options.layout));
    layout = named;
  }
  if (!options.program.empty()) {
    MIRRORBALL_TRY(preset, presetNamed(options.program));
    MIRRORBALL_TRY(form, formFor(preset, projection, layout.value_or(preset.layout)));
    form_ = form;
    naming_ = preset.naming;
  } else {
    form_.layout = layout.value_or(CubeLayout::hcross);
  }
  const CubeArrangement before = form_.arrangement;
  MIRRORBALL_TRY(arrangement, changedBy(options, before));
  form_.arrangement = arrangement;
  hint_ = hintFor(options, projection);
  if (is_texture_) form_.layout = CubeLayout::faces;  // which is what its readers look for
  const bool is_cube = faceCount(projection) == 6;
  if (!is_cube && (layout || arrangement != before))
    return fail(ErrorCode::usage, "--layout, --as-seen, --flip and --face-order are for cubes, and " +
                                      std::string(nameOf(projection)) + " is none; leave them out");
  if (is_texture_ && layout)
    return fail(ErrorCode::usage,
                output_ + ": holds a cube as such, in no layout; leave --layout out, or write .exr, .hdr or .png");
  if (form_.has_texels_on_edges && extensionOf(output_) != "exr")
    return fail(ErrorCode::usage, output_ +
                                      ": only .exr says that its texels lie on OpenEXR's edges; use that for "
                                      "--for openexr");
  return {};
}

Result<void> MapOutput::setFormat(const MapOutputOptions& options) {
  format_ = options.format;
  half_ = format_ == TexelFormat::half;
  if (format_ && !is_texture_) {
    const TexelFormatName& format = kTexelFormatNames[static_cast<std::size_t>(*format_)];
    if (extensionOf(output_) != "exr" || !format.is_in_exr)
      return fail(ErrorCode::usage, output_ + ": cannot hold --format " + std::string(format.name) + "; .exr has " +
                                        join(formatNames(true), ", ", " and ") + ", " +
                                        writtenExtensions(Holds::texture, " and ") + " have all formats");
  }
  zstandard_level_ = options.zstandard_level;
  if (zstandard_level_ > 0 && extensionOf(output_) != "ktx2")
    return fail(ErrorCode::usage, output_ + ": has no Zstandard compression; --zstd is for .ktx2");
  return {};
}

Result<MapOutput> MapOutput::resolve(const MapOutputOptions& options, Projection projection) {
  MapOutput output;
  output.output_ = options.output;
  output.is_texture_ = isTexturePath(options.output);
  MIRRORBALL_TRY_VOID(checkMapOutput(options, options.output));
  output.display_ = options.display;
  MIRRORBALL_TRY_VOID(output.setForm(options, projection));
  MIRRORBALL_TRY_VOID(output.setFormat(options));
  MIRRORBALL_TRY_VOID(output.setLevels(options));
  if (isStandardOutputTaken() && output.paths().size() > 1)
    return fail(ErrorCode::usage, "standard output takes one file, and --layout faces writes six; name another layout");
  return output;
}

std::vector<std::string> MapOutput::paths() const {
  if (is_texture_ || faceCount(form_.projection) != 6 || form_.layout != CubeLayout::faces) return {output_};
  std::vector<std::string> paths;
  for (const std::string_view ending : endingsOf(naming_))
    paths.push_back(suffixed(output_, "_" + std::string(ending)));
  return paths;
}

bool MapOutput::takesPieces() const {
  return is_texture_ && !hasLevels() && zstandard_level_ == 0 && faceCount(form_.projection) != 2 &&
         form_.arrangement == CubeArrangement{} && form_.centre == SignedAxis::plus_z;
}

bool MapOutput::limitsLight() const { return format_ && *format_ != TexelFormat::float32; }

LostLight MapOutput::limitLevels(ImageSet& levels) const {
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

void MapOutput::tellLost(const LostLight& light) const {
  if (light.lost > 0.0)
    remark(output_ + ": " + rangeOf(*format_) + ", and what is brighter was lowered to that: " + percentOf(light) +
           " of the light is lost; --scale-light or --format float32 would keep it");
}

Result<TexelFormat> MapOutput::inFormat(const std::function<Result<void>(TexelFormat)>& write) const {
  const TexelFormat first = format_.value_or(TexelFormat::half);
  const Result<void> written = write(first);
  if (written) return first;
  if (format_ || written.error().code != ErrorCode::out_of_range) return tl::unexpected<Error>(written.error());
  remark(output_ + ": holds light that half floats do not; written in 32-bit floats");
  MIRRORBALL_TRY_VOID(write(TexelFormat::float32));
  return TexelFormat::float32;
}

void MapOutput::tellNegative(std::size_t negative) const {
  if (negative > 0)
    remark(output_ + ": " + countedAre(negative, "value") + " negative, which the format does not hold; taken as 0");
}

void MapOutput::remarkOnForm() const {
  if (extensionOf(output_) == "dds" && !isRecognizedUnsaid(form_))
    remark(output_ + ": a DDS does not say what map it holds; to read this one, add --from " + hint_);
}

std::string MapOutput::pictureFormat() const {
  if (extensionOf(output_) == "hdr") return "three channels of a shared exponent";
  return half_ ? "three channels of half floats" : "three channels of 32-bit floats";
}

void MapOutput::remarkOnLosses(std::size_t negative) const {
  if (!format_) return;
  tellNegative(negative);
  if (convertedChannels(form_.projection) == 4 && storedFormat(*format_).channels < 4)
    remark(output_ + ": the format holds no alpha; beside the disc is black");
}

Result<void> MapOutput::writePieces(int size, const std::function<Result<void>(const TakeTexels&)>& convert_to) const {
  const Projection projection = form_.projection;
  LostLight all_lost;
  std::size_t all_negative = 0;
  std::mutex lost_guard;
  const auto write = [&](TexelFormat format) -> Result<void> {
    MIRRORBALL_TRY(writer, TextureWriter::create(output_, imageSize(projection, size), faceCount(projection),
                                                 convertedChannels(projection),
                                                 {.format = format, .metadata = metadataOf(form_)}));
    MIRRORBALL_TRY_VOID(convert_to([&](int face, glm::ivec2 begin, const Image& texels) -> Result<void> {
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
    }));
    return writer.commit();
  };
  MIRRORBALL_TRY_VOID(inFormat(write));
  tellLost(all_lost);
  remarkOnLosses(all_negative);
  announce(output_);
  remarkOnForm();
  return {};
}

bool MapOutput::refusesNegative() const {
  return extensionOf(output_) == "hdr" || (format_ && refusesNegativeLight(*format_));
}

Result<TexelFormat> MapOutput::writeImages(const ImageSet& images, const Metadata& facts) const {
  Metadata metadata = metadataOf(form_);
  metadata.insert(facts.begin(), facts.end());
  MIRRORBALL_TRY(written, inFormat([&](TexelFormat format) {
                   return writeImageSet(output_, images,
                                        {.format = format,
                                         .zstandard_level = zstandard_level_,
                                         .metadata = metadata,
                                         .progress = progressBar("write")});
                 }));
  announce(output_);
  return written;
}

Result<TexelFormat> MapOutput::writeLevels(ImageSet levels, const Metadata& facts) const {
  tellLost(limitLevels(levels));
  return writeImages(arranged(std::move(levels), form_.arrangement), facts);
}

std::uint64_t MapOutput::memoryToWrite(int size) const {
  if (zstandard_level_ == 0) return 0;
  // Whole levels are compressed, into as much memory as they have.
  const StoredFormat format = storedFormat(format_.value_or(TexelFormat::float32));
  const std::uint64_t blocks = blocksAlong(format, std::uint64_t(size));
  return 2 * 6 * blocks * blocks * blockSize(format);
}

Result<void> MapOutput::write(EnvironmentMap map) const {
  if (limitsLight()) tellLost(limitLight(map, {.max = maxOf(*format_)}));
  const std::size_t negative = refusesNegative() ? raiseNegativeLight(map) : 0;
  if (!hasLevels()) return writeFiles(imagesOf(std::move(map), form_), negative);
  MIRRORBALL_TRY(levels, levelsOf(std::move(map)));
  return writeFiles(std::move(levels), negative);
}

Result<void> MapOutput::write(ImageSet levels) const {
  tellLost(limitLevels(levels));
  std::size_t negative = 0;
  if (refusesNegative()) forEachImage(levels, [&](Image& image) { negative += raiseNegativeLight(image); });
  MIRRORBALL_TRY(wanted, wantedOf(std::move(levels)));
  return writeFiles(std::move(wanted), negative);
}

Result<void> MapOutput::writeFiles(ImageSet images, std::size_t negative) const {
  if (!is_texture_) {
    tellNegative(negative);
    return writePictures(std::move(images));
  }
  if (images.faces() == 2) images = ImageSet(pictureOfImages(std::move(images), form_));
  MIRRORBALL_TRY_VOID(writeImages(images));
  remarkOnLosses(negative);
  remarkOnForm();
  return {};
}

}  // namespace mirrorball::cli
