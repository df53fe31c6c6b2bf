#include "cli/convert_files.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/files.h"
#include "cli/interruption.h"
#include "cli/map_inputs.h"
#include "cli/terminal.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/convert/convert_rows.h"

namespace mirrorball::cli {
namespace {

namespace fs = std::filesystem;

/// Panoramas that take more memory than this are read by rows.
constexpr std::uint64_t kLargePanorama_bytes = std::uint64_t{512} << 20;

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
  if (output.takesPieces()) return output.writePieces(size, convert_to);
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
      return fail(ErrorCode::non_finite, name + ": " + textOf(bad), Remedy::repair);
    }
    MIRRORBALL_TRY_VOID(copyTexels(texels, Projection::equirect, 0, y, take));
    if (!progress(std::size_t(y + texels.height()), std::size_t(height)))
      return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  }
  return {};
}

Result<void> convertByRows(const std::string& input, std::optional<PanoramaRows> panorama,
                           const ConvertRequest& request, const MapFile& output, const ProgressFunction& progress) {
  const Projection to = output.form().projection;
  const RowReader::Description picture = panorama->rows->description();
  const int size = request.size > 0 ? request.size : equivalentSize(Projection::equirect, picture.height, to);
  Resampling resampling = request.resampling;
  resampling.source_from_target = panorama->picture_from_world * resampling.source_from_target;
  const bool is_copy = keepsTexels({Projection::equirect, picture.height, picture.channels}, to, size, resampling);
  const std::uint64_t target = output.takesPieces() ? 0 : bytesOfMap(to, size);
  const std::uint64_t window = memoryLimit() > target ? memoryLimit() - target : 0;
  return writeConverted(output, size, 0, [&](const TakeTexels& take) -> Result<void> {
    // A second time the file is read from its beginning once more.
    if (!panorama) {
      MIRRORBALL_TRY(again, openPanorama(input, request.load));
      panorama = std::move(again);
    }
    const PanoramaRows once = *std::exchange(panorama, std::nullopt);
    if (is_copy) return copyRows(*once.rows, input, take, progress);
    return convertRows(*once.rows, window, to, size, resampling, take, progress);
  });
}

bool isLarge(const PanoramaRows& panorama) {
  const RowReader::Description& picture = panorama.rows->description();
  const std::uint64_t bytes = bytesOf({picture.width, picture.height}, picture.channels);
  return bytes > std::min(kLargePanorama_bytes, memoryLimit() / 2);
}

/// Where an input goes.
///
/// errors   usage: as MapFile::resolve's, or it would overwrite the input
Result<MapFile> outputOf(const std::string& input, const MapOutputOptions& options, const std::string& path,
                         Projection projection) {
  MIRRORBALL_TRY(output, mapFileFor(options, path, projection));
  MIRRORBALL_TRY_VOID(refuseOverwriting({&input, 1}, output.paths()));
  return output;
}

/// Refuses, before anything is read, what can be refused by then.
Result<void> checkOutput(const std::string& input, const ConvertRequest& request, const std::string& path) {
  if (!request.to) return checkMapOutput(request.output, path);
  MIRRORBALL_TRY_VOID(outputOf(input, request.output, path, *request.to));
  return {};
}

/// The output of an input that is loaded, which may have to keep its projection.
Result<MapFile> outputOf(const LoadedEnvironment& loaded, const std::string& input, const ConvertRequest& request,
                         const std::string& path) {
  if (request.to) return outputOf(input, request.output, path, *request.to);
  if (!loaded.recognition)
    return fail(ErrorCode::usage,
                input + ": is light from every direction, in no projection yet; say which it gets: --to " +
                    join(projectionNames(), "|"));
  const MapForm& form = loaded.recognition->form;
  MapOutputOptions options = request.output;
  // A texture's cube has no layout of its own.
  const bool has_layout = faceCount(form.projection) == 6 && !isTexturePath(input) && !isTexturePath(path);
  if (has_layout && !options.file.layout && options.file.program.empty()) options.file.layout = form.layout;
  return outputOf(input, options, path, form.projection);
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
Result<bool> writeOwnLevels(const LoadedEnvironment& loaded, bool is_copy, const ConvertRequest& request,
                            const MapFile& output) {
  if (loaded.levels == 1 || !output.takesOwnLevels()) return false;
  if (is_copy) {
    MIRRORBALL_TRY(levels, loadLevels(loaded, output.form(), request.load));
    if (levels) {
      MIRRORBALL_TRY_VOID(output.write(std::move(*levels)));
      return true;
    }
  }
  remark(loaded.name +
         ": the mip levels that it has are of the map as it is; those of the converted one are made anew");
  return false;
}

Result<void> convertInput(const std::string& input, const ConvertRequest& request, const std::string& path,
                          const ProgressFunction& progress) {
  MIRRORBALL_TRY(panorama, openPanorama(input, request.load));
  if (panorama && isLarge(*panorama)) {
    MIRRORBALL_TRY(output, outputOf(input, request.output, path, request.to.value_or(Projection::equirect)));
    return convertByRows(input, std::move(panorama), request, output, progress);
  }
  MIRRORBALL_TRY(loaded, loadMap(input, request.load));
  MIRRORBALL_TRY(output, outputOf(loaded, input, request, path));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, output.paths()));
  tellClamped(input, loaded.lost);
  if (loaded.levels > 1 && output.leavesLevelsOut())
    remark(input + ": of its " + std::to_string(loaded.levels) +
           " mip levels only the first is taken; --mips takes all");
  const Projection to = output.form().projection;
  const int size = request.size > 0 ? request.size : loaded.environment.naturalSize(to);
  const EnvironmentMap* map = loaded.environment.map();
  const bool is_copy =
      map && keepsTexels({map->projection(), map->size(), map->face(0).channels()}, to, size, request.resampling);
  MIRRORBALL_TRY(is_written, writeOwnLevels(loaded, is_copy, request, output));
  if (is_written) return {};
  return writeConverted(output, size, loaded.environment.bytes(), [&](const TakeTexels& take) {
    if (is_copy) return copyMap(*map, take);
    return convertPiecewise(loaded.environment, to, size, request.resampling, take, progress);
  });
}

/// Every input's path in the folder; no two may be the same.
///
/// errors   usage: one has no extension that can be written, and none is named
Result<std::vector<std::string>> pathsFor(const std::vector<std::string>& inputs, const std::string& folder,
                                          const std::string& extension) {
  return namesInFolder(inputs, folder, [&](const fs::path& name) -> Result<std::string> {
    const std::string ending = extension.empty() ? name.extension().string() : "." + withoutDot(extension);
    const std::string path = (fs::path(folder) / (name.stem().string() + ending)).string();
    if (isTexturePath(path) || checkWritable(path)) return ending;
    return fail(ErrorCode::usage, " would become " + path +
                                      ", which is not a format that Mirrorball writes; --extension names one: " +
                                      writtenExtensions(" or "));
  });
}

}  // namespace

Result<void> convertFile(const std::string& input, const ConvertRequest& request) {
  MIRRORBALL_TRY_VOID(checkFolder(request.output.output));
  MIRRORBALL_TRY_VOID(checkOutput(input, request, request.output.output));
  return convertInput(input, request, request.output.output, progressBar("convert"));
}

Result<void> convertMany(const std::vector<std::string>& inputs, const std::string& extension,
                         const ConvertRequest& request) {
  const std::string& folder = request.output.output;
  if (!isFolder(folder) && fs::path(folder).has_extension())
    return tl::unexpected<Error>(manyForOneFile(folder, inputs));
  MIRRORBALL_TRY(paths, pathsFor(inputs, folder, extension));
  for (std::size_t index = 0; index < inputs.size(); ++index)
    MIRRORBALL_TRY_VOID(checkOutput(inputs[index], request, paths[index]));
  MIRRORBALL_TRY_VOID(makeFolder(folder));
  const ProgressFunction bar = progressBar("convert");
  if (inputs.size() == 1) return convertInput(inputs.front(), request, paths.front(), bar);

  whenInterrupted(interruptedAmongMany(folder));
  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> failed = 0;
  // Each file's own loops run on all cores too, which keeps them busy while another file is read or written.
  parallelFor(inputs.size(), 1, [&](std::size_t index, std::size_t) {
    if (interrupted()) return;
    const auto converted =
        convertInput(inputs[index], request, paths[index], [](std::size_t, std::size_t) { return !interrupted(); });
    if (!converted && converted.error().code != ErrorCode::interrupted) {
      ++failed;
      complain(converted.error());
    }
    bar(++done, inputs.size());
  });
  return outcomeOfMany(failed, inputs.size(), "converted", folder);
}

}  // namespace mirrorball::cli
