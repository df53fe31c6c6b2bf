#include "mirrorball/environment/file/face_files.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <system_error>
#include <vector>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::array<std::string_view, 6>, 5> kEndings{{
    {"px", "nx", "py", "ny", "pz", "nz"},
    {"posx", "negx", "posy", "negy", "posz", "negz"},
    {"right", "left", "top", "bottom", "front", "back"},
    {"right", "left", "up", "down", "front", "back"},
    {"+X", "-X", "+Y", "-Y", "+Z", "-Z"},
}};
constexpr std::array<FaceNaming, kEndings.size()> kNamings{FaceNaming::px, FaceNaming::posx, FaceNaming::top,
                                                           FaceNaming::up, FaceNaming::signs};
constexpr std::string_view kSeparators = "_-. ";

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

/// What stands before the ending that a stem has in a naming: "room_" of "room_PX".
std::optional<std::string> baseOf(const std::string& stem, FaceNaming naming) {
  for (const std::string_view ending : endingsOf(naming)) {
    if (!lowered(stem).ends_with(lowered(ending))) continue;
    const std::string base = stem.substr(0, stem.size() - ending.size());
    const bool is_apart = base.empty() || kSeparators.find(base.back()) != std::string_view::npos;
    if (is_apart || naming == FaceNaming::signs) return base;
  }
  return std::nullopt;
}

/// The files of a folder by their names in small letters.
using Listing = std::map<std::string, fs::path>;

Listing listingOf(const fs::path& folder) {
  Listing listing;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end; !error && entry != end;
       entry.increment(error))
    listing.emplace(lowered(entry->path().filename().string()), folder / entry->path().filename());
  return listing;
}

/// The six files of a naming: as they are spelled beside the named one, or however they are in the folder.
FaceFiles filesOf(const fs::path& file, const std::string& base, FaceNaming naming, const Listing& listing) {
  FaceFiles files{{}, naming, 0};
  for (std::size_t face = 0; face < files.paths.size(); ++face) {
    const std::string name = base + std::string(endingsOf(naming)[face]) + file.extension().string();
    files.paths[face] = file.parent_path() / name;
    std::error_code error;
    const auto listed = listing.find(lowered(name));
    if (!fs::exists(files.paths[face], error) && listed != listing.end()) files.paths[face] = listed->second;
    files.present += fs::exists(files.paths[face], error) ? 1 : 0;
  }
  return files;
}

std::optional<FaceFiles> filesNamedLike(const fs::path& file, const Listing& listing) {
  std::optional<FaceFiles> best;
  for (const FaceNaming naming : kNamings) {
    const auto base = baseOf(file.stem().string(), naming);
    if (!base) continue;
    FaceFiles files = filesOf(file, *base, naming, listing);
    if (!best || files.present > best->present) best = std::move(files);
  }
  return best;
}

/// "room_nz.exr"
std::string missingOf(const FaceFiles& files) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::path& path : files.paths)
    if (!fs::exists(path, error)) names.push_back(path.filename().string());
  return join(names, ", ", " and ");
}

}  // namespace

const std::array<std::string_view, 6>& endingsOf(FaceNaming naming) {
  return kEndings[static_cast<std::size_t>(naming)];
}

std::string textOf(FaceNaming naming) { return join(endingsOf(naming), " "); }

std::optional<FaceFiles> faceFilesBeside(const fs::path& file) {
  const bool ends_like_a_face = std::any_of(kNamings.begin(), kNamings.end(), [&](FaceNaming naming) {
    return baseOf(file.stem().string(), naming).has_value();
  });
  if (!ends_like_a_face) return std::nullopt;
  return filesNamedLike(file, listingOf(file.parent_path()));
}

Result<FaceFiles> faceFilesIn(const fs::path& folder) {
  const Listing listing = listingOf(folder);
  std::vector<FaceFiles> cubes;
  std::optional<FaceFiles> nearly;
  for (const auto& [name, path] : listing) {
    auto files = filesNamedLike(path, listing);
    const auto is_same = [&](const FaceFiles& other) { return other.paths == files->paths; };
    if (files && files->present == 6 && std::none_of(cubes.begin(), cubes.end(), is_same))
      cubes.push_back(std::move(*files));
    else if (files && files->present > 3 && (!nearly || files->present > nearly->present))
      nearly = std::move(*files);
  }
  if (cubes.size() == 1) return std::move(cubes[0]);
  if (cubes.empty() && nearly)
    return fail(ErrorCode::not_found, folder.string() + ": holds " + std::to_string(nearly->present) +
                                          " of the six files of a cube, without " + missingOf(*nearly));
  if (cubes.empty())
    return fail(ErrorCode::not_found, folder.string() +
                                          ": is a folder without the six files of a cube, such as px nx "
                                          "py ny pz nz or right left top bottom front back; name a file in it");
  return fail(ErrorCode::usage, folder.string() + ": holds " + std::to_string(cubes.size()) +
                                    " cubes; name one of the six files, such as " +
                                    cubes[0].paths[0].filename().string());
}

}  // namespace mirrorball
