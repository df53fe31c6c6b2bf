#include "cli/convert_files.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>

#include "cli/files.h"
#include "cli/terminal.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
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
  return bytesOf(imageSize(projection, size), (hasDisc(projection) ? 4 : 3) * faceCount(projection));
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

Result<void> convertByRows(const std::string& input, const ConvertRequest& request, const MapOutput& output,
                           const ProgressFunction& progress) {
  const auto describe = [&](const PanoramaRows& panorama) { return panorama.rows->description(); };
  MIRRORBALL_TRY(panorama, openPanorama(input, request.load));
  const int height = describe(*panorama).height;
  const int size = request.size > 0 ? request.size : equivalentSize(Projection::equirect, height, request.to);
  Resampling resampling = request.resampling;
  resampling.source_from_target = panorama->picture_from_world * resampling.source_from_target;
  const std::uint64_t target = output.takesPieces() ? 0 : bytesOfMap(request.to, size);
  const std::uint64_t window = memoryLimit() > target ? memoryLimit() - target : 0;
  bool is_opened = true;
  return writeConverted(output, size, 0, [&](const TakeTexels& take) -> Result<void> {
    // A second time the file is read from its beginning once more.
    if (!is_opened) {
      MIRRORBALL_TRY(again, openPanorama(input, request.load));
      panorama = std::move(again);
    }
    is_opened = false;
    return convertRows(*panorama->rows, input, window, request.to, size, resampling, take, progress);
  });
}

Result<bool> isLargePanorama(const std::string& input, const EnvironmentLoadOptions& load) {
  MIRRORBALL_TRY(panorama, openPanorama(input, load));
  if (!panorama) return false;
  const RowReader::Description& picture = panorama->rows->description();
  const std::uint64_t bytes = bytesOf({picture.width, picture.height}, picture.channels);
  return bytes > std::min(kLargePanorama_bytes, memoryLimit() / 2);
}

Result<void> convertInput(const std::string& input, const ConvertRequest& request, const ProgressFunction& progress) {
  MIRRORBALL_TRY(output, MapOutput::resolve(request.output, request.to));
  MIRRORBALL_TRY_VOID(refuseOverwriting({&input, 1}, output.paths()));
  MIRRORBALL_TRY(is_large, isLargePanorama(input, request.load));
  if (is_large) return convertByRows(input, request, output, progress);
  MIRRORBALL_TRY(loaded, loadEnvironment(input, request.load));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, output.paths()));
  const int size = request.size > 0 ? request.size : loaded.environment.naturalSize(request.to);
  const EnvironmentMap* map = loaded.environment.map();
  const std::uint64_t source_bytes =
      map ? bytesOf(map->extent(), map->face(0).channels()) * std::uint64_t(map->faces()) : 0;
  return writeConverted(output, size, source_bytes, [&](const TakeTexels& take) {
    return convertPiecewise(loaded.environment, request.to, size, request.resampling, take, progress);
  });
}

/// The file in the folder that an input is converted to.
///
/// errors   usage: its extension, or the want of one, names nothing that is written
Result<std::string> outputFor(const std::string& input, const std::string& folder, const std::string& extension) {
  const fs::path path(isBuiltinEnvironment(input) ? input.substr(0, input.find(':')) : input);
  // "room/" is a folder with a cube's six files.
  const fs::path name = path.has_filename() ? path : path.parent_path();
  const std::string ending = extension.empty() ? name.extension().string() : "." + extension;
  const std::string output = (fs::path(folder) / (name.stem().string() + ending)).string();
  if (isTexturePath(output) || checkWritable(output)) return output;
  return fail(ErrorCode::usage, input + ": '" + ending +
                                    "' is nothing that is written; --extension names what is: exr, "
                                    "hdr, ktx2, dds, png or jpg");
}

/// Every input's output; no two may be the same.
Result<std::vector<std::string>> outputsFor(const std::vector<std::string>& inputs, const std::string& folder,
                                            const std::string& extension) {
  std::vector<std::string> outputs;
  std::map<std::string, std::string> input_of;
  for (const std::string& input : inputs) {
    MIRRORBALL_TRY(output, outputFor(input, folder, extension));
    const auto [place, is_new] = input_of.emplace(output, input);
    if (!is_new)
      return fail(ErrorCode::usage, place->second + " and " + input + " would both become " + output +
                                        "; convert them in two runs, to two folders");
    outputs.push_back(output);
  }
  return outputs;
}

}  // namespace

Result<void> convertFile(const std::string& input, const ConvertRequest& request) {
  return convertInput(input, request, progressBar("convert"));
}

bool isFolder(const std::string& output) {
  std::error_code status;
  return output.ends_with('/') || fs::is_directory(output, status);
}

Result<void> convertMany(const std::vector<std::string>& inputs, const std::string& extension,
                         const ConvertRequest& request) {
  const std::string& folder = request.output.output;
  if (!isFolder(folder) && fs::path(folder).has_extension())
    return fail(ErrorCode::usage,
                folder + ": is one file, and there are " + std::to_string(inputs.size()) + " inputs; give -o a folder");
  MIRRORBALL_TRY(outputs, outputsFor(inputs, folder, extension));
  std::error_code status;
  fs::create_directories(folder, status);
  if (status) return fail(ErrorCode::io, folder + ": cannot be made: " + status.message());

  const ProgressFunction bar = progressBar("convert");
  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> failed = 0;
  // Each file's own loops run on all cores too, which keeps them busy while another file is read or written.
  parallelFor(inputs.size(), 1, [&](std::size_t begin, std::size_t) {
    if (interrupted()) return;
    ConvertRequest one = request;
    one.output.output = outputs[begin];
    const auto converted = convertInput(inputs[begin], one, [](std::size_t, std::size_t) { return !interrupted(); });
    if (!converted && converted.error().code != ErrorCode::interrupted) {
      ++failed;
      remark(converted.error().message);
    }
    bar(++done, inputs.size());
  });
  if (interrupted()) return fail(ErrorCode::interrupted, "interrupted; what was finished stays in " + folder);
  if (failed == 0) return {};
  return fail(ErrorCode::bad_file, std::to_string(failed) + " of " + std::to_string(inputs.size()) +
                                       " inputs could not be converted; the others are in " + folder);
}

}  // namespace mirrorball::cli
