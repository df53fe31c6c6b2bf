#include "mirrorball/output/convert_file.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/convert/convert_rows.h"
#include "mirrorball/environment/file/large_panorama.h"
#include "mirrorball/output/north_mark.h"

namespace mirrorball {
namespace {

std::uint64_t bytesOf(glm::ivec2 size, int channels) {
  return std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(channels) * sizeof(float);
}

/// The memory of a map that is converted as a whole.
std::uint64_t bytesOfMap(Projection projection, int size) {
  return bytesOf(imageSize(projection, size), convertedChannels(projection) * faceCount(projection));
}

/// A map, as far as it decides whether its texels can stay as they are.
struct MapShape {
  Projection projection;
  int size;
  int channels;
};

/// Whether each texel would only be looked up at its own centre. On a disc alpha has to be there already.
bool keepsTexels(const MapShape& map, Projection to, int size, const Resampling& resampling) {
  const int channels = convertedChannels(to);
  return map.projection == to && map.size == size && (map.channels == channels || channels == 3) &&
         resampling.source_from_target == glm::mat3(1.0f);
}

/// Hands on an image's texels as they are, without alpha where the converted map has none.
Result<void> copyTexels(const Image& image, Projection to, int face, int row, const TakeTexels& take) {
  if (image.channels() == convertedChannels(to)) return take(face, {0, row}, image);
  return take(face, {0, row}, rgbOf(image));
}

/// Writes what `convert_to` converts, as it comes or as a whole.
Result<void> writeConverted(const MapFile& output, int size, std::uint64_t source_bytes,
                            const std::function<Result<void>(const TakeTexels&)>& convert_to) {
  const Projection to = output.form().projection;
  MIRRORBALL_TRY_VOID(output.checkLevelOfSize(size));
  if (output.takesStrips()) return output.writeByStrips(size, convert_to);
  MIRRORBALL_TRY_VOID(withName("the converted map", checkMemory(source_bytes + bytesOfMap(to, size))));
  MIRRORBALL_TRY(images, imagesFor(to, size));
  MIRRORBALL_TRY_VOID(convert_to(copyInto(images)));
  return output.write(EnvironmentMap(to, std::move(images)));
}

/// Hands on the rows of a panorama as they are.
Result<void> copyRows(RowReader& rows, const std::string& name, const TakeTexels& take,
                      const ProgressFunction& progress) {
  constexpr int kRowsAtATime = 64;
  const int height = rows.description().height;
  for (int y = 0; y < height; y += kRowsAtATime) {
    MIRRORBALL_TRY(texels, rows.read(std::min(kRowsAtATime, height - y)));
    if (NonFinite bad = findNonFinite(texels); bad.count > 0) {
      bad.first.y += y;
      return fail(ErrorCode::non_finite, name + ": " + textOf(bad), FixHint::repair);
    }
    MIRRORBALL_TRY_VOID(copyTexels(texels, Projection::equirect, 0, y, take));
    if (progress && !progress(std::size_t(y + texels.height()), std::size_t(height)))
      return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  }
  return {};
}

Result<void> convertByRows(const std::string& input, std::optional<PanoramaRows> panorama,
                           const FileConversion& conversion, const MapFile& output, const ProgressFunction& progress) {
  const Projection to = output.form().projection;
  const RowReader::Description picture = panorama->rows->description();
  const int size = conversion.size > 0 ? conversion.size : equivalentSize(Projection::equirect, picture.height, to);
  Resampling resampling = conversion.resampling;
  resampling.source_from_target = panorama->picture_from_world * resampling.source_from_target;
  const bool is_copy = keepsTexels({Projection::equirect, picture.height, picture.channels}, to, size, resampling);
  const std::uint64_t target = output.takesStrips() ? 0 : bytesOfMap(to, size);
  const std::uint64_t window = memoryLimit() > target ? memoryLimit() - target : 0;
  return writeConverted(output, size, 0, [&](const TakeTexels& take) -> Result<void> {
    // A second time the file is read from its beginning once more.
    if (!panorama) {
      MIRRORBALL_TRY(again, openPanorama(input, conversion.load));
      panorama = std::move(again);
    }
    const PanoramaRows once = *std::exchange(panorama, std::nullopt);
    if (is_copy) return copyRows(*once.rows, input, take, progress);
    return convertRows(*once.rows, window, to, size, resampling, take, progress);
  });
}

/// The output of an input whose projection is known.
///
/// errors   usage: as MapFile::resolve's, or it would overwrite the input
Result<MapFile> outputOf(const std::string& input, const std::string& path, const MapFileOptions& options,
                         Projection projection, const Observer& observer) {
  MIRRORBALL_TRY(output, MapFile::resolve(path, options, projection, observer));
  MIRRORBALL_TRY_VOID(refuseOverwriting({&input, 1}, output.paths()));
  output.tellIfNotImported();
  return output;
}

/// The output of an input that is loaded, which may have to keep its projection.
Result<MapFile> outputOf(const LoadedEnvironment& loaded, const std::string& path, const FileConversion& conversion,
                         const Observer& observer) {
  if (conversion.to) return outputOf(loaded.name, path, conversion.file, *conversion.to, observer);
  if (!loaded.recognition)
    return fail(ErrorCode::usage, loaded.name + ": is light from every direction, in no projection yet",
                FixHint::name_projection);
  return outputOf(loaded.name, path, keepingLayout(loaded, path, conversion.file), loaded.recognition->form.projection,
                  observer);
}

/// Hands on the texels of a map as they are.
Result<void> copyMap(const EnvironmentMap& map, const TakeTexels& take) {
  for (int face = 0; face < map.faces(); ++face)
    MIRRORBALL_TRY_VOID(copyTexels(map.face(face), map.projection(), face, 0, take));
  return {};
}

/// Writes the mip levels that a texture has, where they are those of the map that is asked for.
///
/// returns  whether that is so
Result<bool> writeOwnLevels(const LoadedEnvironment& loaded, bool is_copy, const EnvironmentLoadOptions& load,
                            const MapFile& output, const Observer& observer) {
  if (loaded.levels == 1 || !output.takesOwnLevels()) return false;
  if (is_copy) {
    MIRRORBALL_TRY(levels, loadLevels(loaded, output.form(), load));
    if (levels) {
      MIRRORBALL_TRY_VOID(output.write(std::move(*levels)));
      return true;
    }
  }
  observer.tell(
      RemarkKind::levels_remade,
      loaded.name + ": the mip levels that it has are of the map as it is; those of the converted one are made anew");
  return false;
}

/// returns  the files that were written
Result<std::vector<std::string>> convertLoaded(const LoadedEnvironment& loaded, const std::string& path,
                                               const FileConversion& conversion, const Observer& observer) {
  tellAbout(loaded, observer);
  MIRRORBALL_TRY(output, outputOf(loaded, path, conversion, observer));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, output.paths()));
  if (loaded.levels > 1 && output.leavesLevelsOut())
    observer.tell(RemarkKind::levels_left_out,
                  loaded.name + ": of its " + std::to_string(loaded.levels) + " mip levels only the first is taken");
  const Projection to = output.form().projection;
  const int size = conversion.size > 0 ? conversion.size : loaded.environment.naturalSize(to);
  const EnvironmentMap* map = loaded.environment.map();
  const bool is_copy =
      map && keepsTexels({map->projection(), map->size(), map->face(0).channels()}, to, size, conversion.resampling);
  MIRRORBALL_TRY(is_written, writeOwnLevels(loaded, is_copy, conversion.load, output, observer));
  if (is_written) return output.paths();
  const ProgressFunction progress = observer.progressOf("convert");
  MIRRORBALL_TRY_VOID(writeConverted(output, size, loaded.environment.bytes(), [&](const TakeTexels& take) {
    if (is_copy) return copyMap(*map, take);
    return convertByStrips(loaded.environment, to, size, conversion.resampling, take, progress);
  }));
  return output.paths();
}

/// Marks north in a panorama, of which smaller mip levels are then not those of its file.
///
/// errors   bad_shape: it is not a panorama
Result<void> markNorth(const CompassHeading& heading, LoadedEnvironment& loaded) {
  MIRRORBALL_TRY(north, withName(loaded.name, findNorth(heading, loaded)));
  drawNorth(north.axes, *loaded.environment.map());
  loaded.levels = 1;
  return {};
}

}  // namespace

MapFileOptions keepingLayout(const LoadedEnvironment& loaded, const std::string& path, MapFileOptions options) {
  if (!loaded.recognition) return options;
  const MapForm& form = loaded.recognition->form;
  // A texture's cube has no layout of its own.
  const bool has_layout = faceCount(form.projection) == 6 && !isTexturePath(loaded.name) && !isTexturePath(path);
  if (has_layout && !options.layout && options.program.empty()) options.layout = form.layout;
  return options;
}

Result<void> checkConversion(const std::string& input, const std::string& output, const FileConversion& conversion) {
  MIRRORBALL_TRY_VOID(formatToWrite(output, {Holds::light, Holds::texture, Holds::picture}));
  if (conversion.to) MIRRORBALL_TRY_VOID(outputOf(input, output, conversion.file, *conversion.to, {}));
  return {};
}

Result<SavedMap> convertFile(const std::string& input, const std::string& output, const FileConversion& conversion,
                             const Observer& observer) {
  SavedMap saved;
  const Observer keeping = observer.keeping(saved.remarks);
  MIRRORBALL_TRY_VOID(checkConversion(input, output, conversion));
  std::optional<PanoramaRows> panorama;
  if (!conversion.marked_north) {
    MIRRORBALL_TRY(opened, openLargePanorama(input, conversion.load));
    panorama = std::move(opened);
  }
  if (panorama) {
    tellAbout(*panorama, input, keeping);
    MIRRORBALL_TRY(file,
                   outputOf(input, output, conversion.file, conversion.to.value_or(Projection::equirect), keeping));
    MIRRORBALL_TRY_VOID(convertByRows(input, std::move(panorama), conversion, file, observer.progressOf("convert")));
    saved.paths = file.paths();
    return saved;
  }
  MIRRORBALL_TRY(loaded, loadEnvironment(input, conversion.load));
  if (conversion.marked_north) MIRRORBALL_TRY_VOID(markNorth(*conversion.marked_north, loaded));
  MIRRORBALL_TRY(paths, convertLoaded(loaded, output, conversion, keeping));
  saved.paths = std::move(paths);
  return saved;
}

}  // namespace mirrorball
