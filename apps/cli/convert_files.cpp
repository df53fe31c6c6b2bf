#include "cli/convert_files.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "cli/files.h"
#include "cli/terminal.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin.h"
#include "mirrorball/environment/convert_rows.h"

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

/// Writes what `convert_to` converts, as it comes or as a whole.
Result<void> writeConverted(const MapOutput& output, int size, std::uint64_t source_bytes,
                            const std::function<Result<void>(const TakeTexels&)>& convert_to) {
  const Projection to = output.form().projection;
  if (output.takesPieces()) return output.writePieces(size, convert_to);
  MIRRORBALL_TRY_VOID(checkMemory("the converted map", source_bytes + bytesOfMap(to, size)));
  MIRRORBALL_TRY(images, imagesFor(to, size));
  MIRRORBALL_TRY_VOID(convert_to(copyInto(images)));
  return output.write(EnvironmentMap(to, std::move(images)));
}

Result<void> convertByRows(const std::string& input, std::optional<PanoramaRows> panorama,
                           const ConvertRequest& request, const MapOutput& output, const ProgressFunction& progress) {
  const int height = panorama->rows->description().height;
  const int size = request.size > 0 ? request.size : equivalentSize(Projection::equirect, height, request.to);
  Resampling resampling = request.resampling;
  resampling.source_from_target = panorama->picture_from_world * resampling.source_from_target;
  const std::uint64_t target = output.takesPieces() ? 0 : bytesOfMap(request.to, size);
  const std::uint64_t window = memoryLimit() > target ? memoryLimit() - target : 0;
  return writeConverted(output, size, 0, [&](const TakeTexels& take) -> Result<void> {
    // A second time the file is read from its beginning once more.
    if (!panorama) {
      MIRRORBALL_TRY(again, openPanorama(input, request.load));
      panorama = std::move(again);
    }
    const PanoramaRows once = *std::exchange(panorama, std::nullopt);
    return convertRows(*once.rows, input, window, request.to, size, resampling, take, progress);
  });
}

bool isLarge(const PanoramaRows& panorama) {
  const RowReader::Description& picture = panorama.rows->description();
  const std::uint64_t bytes = bytesOf({picture.width, picture.height}, picture.channels);
  return bytes > std::min(kLargePanorama_bytes, memoryLimit() / 2);
}

/// Where an input goes.
///
/// errors   usage: as MapOutput::resolve's, or it would overwrite the input
Result<MapOutput> outputOf(const std::string& input, const ConvertRequest& request, const std::string& path) {
  MapOutputOptions options = request.output;
  options.output = path;
  MIRRORBALL_TRY(output, MapOutput::resolve(options, request.to));
  MIRRORBALL_TRY_VOID(refuseOverwriting({&input, 1}, output.paths()));
  return output;
}

Result<void> convertInput(const std::string& input, const ConvertRequest& request, const MapOutput& output,
                          const ProgressFunction& progress) {
  MIRRORBALL_TRY(panorama, openPanorama(input, request.load));
  if (panorama && isLarge(*panorama)) return convertByRows(input, std::move(panorama), request, output, progress);
  MIRRORBALL_TRY(loaded, loadEnvironment(input, request.load));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, output.paths()));
  const int size = request.size > 0 ? request.size : loaded.environment.naturalSize(request.to);
  return writeConverted(output, size, loaded.environment.bytes(), [&](const TakeTexels& take) {
    return convertPiecewise(loaded.environment, request.to, size, request.resampling, take, progress);
  });
}

/// "exr", also of ".exr".
std::string withoutDot(const std::string& extension) { return extension.substr(extension.starts_with('.') ? 1 : 0); }

/// The path in the folder that an input is converted to.
///
/// errors   usage: it has no extension, and none is named
Result<std::string> pathFor(const std::string& input, const std::string& folder, const std::string& extension) {
  const fs::path whole(isBuiltinEnvironment(input) ? input.substr(0, input.find(':')) : input);
  // "room/" is a folder with a cube's six files.
  const fs::path name = whole.has_filename() ? whole : whole.parent_path();
  const std::string ending = extension.empty() ? name.extension().string() : "." + withoutDot(extension);
  const std::string path = (fs::path(folder) / (name.stem().string() + ending)).string();
  if (isTexturePath(path) || checkWritable(path)) return path;
  return fail(ErrorCode::usage, input + " would become " + path +
                                    ", which is not a format that Mirrorball writes; --extension names one: " +
                                    writtenExtensions(" or "));
}

/// Every input's output; no two may be the same file.
///
/// errors   usage
Result<std::vector<MapOutput>> outputsFor(const std::vector<std::string>& inputs, const std::string& extension,
                                          const ConvertRequest& request) {
  std::vector<MapOutput> outputs;
  std::map<std::string, std::string> input_of;
  for (const std::string& input : inputs) {
    MIRRORBALL_TRY(path, pathFor(input, request.output.output, extension));
    const auto [place, is_new] = input_of.emplace(path, input);
    if (!is_new)
      return fail(ErrorCode::usage, place->second + " and " + input + " would both become " + path +
                                        "; convert them in two runs, to two folders");
    MIRRORBALL_TRY(output, outputOf(input, request, path));
    outputs.push_back(std::move(output));
  }
  return outputs;
}

/// What there is to say at the end of many.
Result<void> summary(std::size_t failed, std::size_t all, const std::string& folder) {
  if (interrupted()) return fail(ErrorCode::interrupted, "interrupted; what was finished stays in " + folder);
  if (failed == 0) return {};
  if (failed == all) return fail(ErrorCode::bad_file, "none of " + std::to_string(all) + " inputs could be converted");
  return fail(ErrorCode::bad_file, std::to_string(failed) + " of " + std::to_string(all) +
                                       " inputs could not be converted; the others are in " + folder);
}

}  // namespace

Result<void> convertFile(const std::string& input, const ConvertRequest& request) {
  MIRRORBALL_TRY_VOID(checkFolder(request.output.output));
  MIRRORBALL_TRY(output, outputOf(input, request, request.output.output));
  return convertInput(input, request, output, progressBar("convert"));
}

Result<void> convertMany(const std::vector<std::string>& inputs, const std::string& extension,
                         const ConvertRequest& request) {
  const std::string& folder = request.output.output;
  if (!isFolder(folder) && fs::path(folder).has_extension())
    return fail(ErrorCode::usage,
                folder + ": is one file, and there are " + std::to_string(inputs.size()) + " inputs; give -o a folder");
  MIRRORBALL_TRY(outputs, outputsFor(inputs, extension, request));
  MIRRORBALL_TRY_VOID(makeFolder(folder));
  const ProgressFunction bar = progressBar("convert");
  if (inputs.size() == 1) return convertInput(inputs.front(), request, outputs.front(), bar);

  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> failed = 0;
  // Each file's own loops run on all cores too, which keeps them busy while another file is read or written.
  parallelFor(inputs.size(), 1, [&](std::size_t index, std::size_t) {
    if (interrupted()) return;
    const auto converted =
        convertInput(inputs[index], request, outputs[index], [](std::size_t, std::size_t) { return !interrupted(); });
    if (!converted && converted.error().code != ErrorCode::interrupted) {
      ++failed;
      remark(converted.error().message);
    }
    bar(++done, inputs.size());
  });
  return summary(failed, inputs.size(), folder);
}

}  // namespace mirrorball::cli
