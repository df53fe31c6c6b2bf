#include "cli/files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/builtin/builtin.h"

namespace mirrorball::cli {

Result<void> checkFolder(const std::string& output) {
  if (isFolder(output)) return fail(ErrorCode::usage, output + ": is a folder; name a file in it");
  MIRRORBALL_TRY(target, withName(output, withoutLinks(output)));
  const std::filesystem::path folder = target.parent_path();
  std::error_code status;
  if (folder.empty() || std::filesystem::is_directory(folder, status)) return {};
  const bool exists = std::filesystem::exists(folder, status);
  const std::string link = target == output ? "" : "is a link to " + target.string() + ", and ";
  return fail(ErrorCode::io,
              output + ": " + link +
                  (exists ? "cannot be written, since " + folder.string() + " is no folder"
                          : "there is no folder " + folder.string() + "; make it (mkdir -p), or name another"));
}

Result<void> refuseSharedNames(std::span<const std::string> outputs) {
  for (const std::string& output : outputs)
    if (std::count(outputs.begin(), outputs.end(), output) > 1)
      return fail(ErrorCode::usage, output + ": is named for two outputs; each needs a name of its own");
  return {};
}

Result<void> refusePictureOptions(const GivenOptions& given, const std::string& output, const std::string& instead) {
  if (!formatToWrite(output, {Holds::light, Holds::texture})) return {};
  std::string options;
  for (const std::string_view name : {"exposure", "tone-map", "dither", "resolve"})
    if (given.contains(name)) options += (options.empty() ? "--" : " and --") + std::string(name);
  if (options.empty()) return {};
  return fail(ErrorCode::usage, output + ": holds light as it is; for " + options + " write " +
                                    writtenExtensions(Holds::picture, " or ") + instead);
}

Result<std::vector<std::string>> namesInFolder(
    const std::vector<std::string>& inputs, const std::string& folder,
    const std::function<Result<std::string>(const std::filesystem::path& name)>& ending) {
  std::vector<std::string> names;
  std::map<std::string, std::string> input_of;
  for (const std::string& input : inputs) {
    const std::filesystem::path whole(isBuiltinEnvironment(input) ? input.substr(0, input.find(':')) : input);
    // "room/" is a folder with a cube's six files.
    const std::filesystem::path own = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    auto end = ending(own);
    if (!end) return fail(end.error().code, input + end.error().message);
    const std::string name = (std::filesystem::path(folder) / (own.stem().string() + *end)).string();
    const auto [place, is_new] = input_of.emplace(name, input);
    if (!is_new)
      return fail(ErrorCode::usage, place->second + " and " + input + " would both become " + name +
                                        "; take them in two runs, to two folders");
    names.push_back(name);
  }
  return names;
}

Error manyForOneFile(const std::string& output, const std::vector<std::string>& inputs) {
  constexpr std::size_t kMaxNamed = 3;
  std::vector<std::string> named(inputs.begin(), inputs.begin() + std::ptrdiff_t(std::min(inputs.size(), kMaxNamed)));
  if (inputs.size() > kMaxNamed) named.emplace_back("…");
  return {ErrorCode::usage, output + ": is one file, and there are " + std::to_string(inputs.size()) + " inputs (" +
                                join(named) + "); give -o a folder"};
}

bool isOutputName(const std::string& name) { return isTexturePath(name) || checkWritable(name).has_value(); }

Result<void> refuseUnnamedOutput(const std::vector<std::string>& inputs,
                                 const std::function<bool(const std::string&)>& is_output) {
  std::error_code status;
  if (inputs.size() < 2 || std::filesystem::exists(inputs.back(), status) || !is_output(inputs.back())) return {};
  return fail(ErrorCode::usage, inputs.back() + ": there is no such file; to write it say -o " + inputs.back());
}

}  // namespace mirrorball::cli
