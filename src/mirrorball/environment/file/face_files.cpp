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

/// From how many of six files on they are taken for a cube, some of which is missing: a stereo pair is two pictures.
constexpr int kMostOfSix = 4;

struct NamingTraits {
  FaceNaming naming;
  std::array<std::string_view, 6> endings;
  std::string_view reading = {};  ///< words for --from faces:
  bool joins = false;             ///< needs no character between a name and the ending
  bool is_common = false;
};

/// "As an eye sees them, the right one on the right of the front one": krpano's preset says that.
constexpr std::string_view kAsSeen = "for=krpano";
/// The same, in the order front, right, back, left, up, down (Pano2VR, erect2cubic).
constexpr std::string_view kAround = "for=krpano,order=+z+x-z-x+y-y";

/// In the order of FaceNaming. docs/conventions.md has the sources.
constexpr auto kNamings = std::to_array<NamingTraits>({
    {FaceNaming::px, {"px", "nx", "py", "ny", "pz", "nz"}},
    {FaceNaming::posx, {"posx", "negx", "posy", "negy", "posz", "negz"}},
    {FaceNaming::pos_x, {"pos_x", "neg_x", "pos_y", "neg_y", "pos_z", "neg_z"}},
    {FaceNaming::xpos, {"xpos", "xneg", "ypos", "yneg", "zpos", "zneg"}},
    {FaceNaming::x_pos, {"x_pos", "x_neg", "y_pos", "y_neg", "z_pos", "z_neg"}},
    {FaceNaming::positive_x, {"positive_x", "negative_x", "positive_y", "negative_y", "positive_z", "negative_z"}},
    {FaceNaming::positive_x_hyphen,
     {"positive-x", "negative-x", "positive-y", "negative-y", "positive-z", "negative-z"}},
    {FaceNaming::positivex, {"PositiveX", "NegativeX", "PositiveY", "NegativeY", "PositiveZ", "NegativeZ"}},
    {FaceNaming::signs, {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}, "", true},
    {FaceNaming::signs_behind, {"X+", "X-", "Y+", "Y-", "Z+", "Z-"}},
    {FaceNaming::top, {"right", "left", "top", "bottom", "front", "back"}},
    {FaceNaming::up, {"right", "left", "up", "down", "front", "back"}},
    {FaceNaming::forward, {"right", "left", "up", "down", "forward", "back"}, kAsSeen},
    {FaceNaming::forward_backward, {"right", "left", "up", "down", "forward", "backward"}, kAsSeen},
    {FaceNaming::forward_top, {"right", "left", "top", "bottom", "forward", "backward"}, kAsSeen},
    {FaceNaming::quake, {"rt", "lf", "up", "dn", "ft", "bk"}, "for=quake", true},
    {FaceNaming::ogre, {"rt", "lf", "up", "dn", "fr", "bk"}, "for=ogre"},
    {FaceNaming::unity, {"Right-X", "Left+X", "Up+Y", "Down-Y", "Front+Z", "Back-Z"}, "as-seen"},
    {FaceNaming::unity_cameras,
     {"Cam_3_Right-X", "Cam_2_Left+X", "Cam_4_Up+Y", "Cam_5_Down-Y", "Cam_0_Front+Z", "Cam_1_Back-Z"},
     "as-seen"},
    {FaceNaming::unity_textures, {"RightTex", "LeftTex", "UpTex", "DownTex", "FrontTex", "BackTex"}, "as-seen"},
    {FaceNaming::c00, {"c00", "c01", "c02", "c03", "c04", "c05"}},
    {FaceNaming::face0, {"face0", "face1", "face2", "face3", "face4", "face5"}},
    {FaceNaming::letters, {"r", "l", "u", "d", "f", "b"}, kAsSeen, false, true},
    {FaceNaming::from_0, {"0", "1", "2", "3", "4", "5"}, "", false, true},
    {FaceNaming::from_1, {"1", "2", "3", "4", "5", "6"}, kAround, false, true},
    {FaceNaming::from_00, {"00", "01", "02", "03", "04", "05"}, "", false, true},
    {FaceNaming::from_0000, {"0000", "0001", "0002", "0003", "0004", "0005"}, kAround, true, true},
});
constexpr std::string_view kSeparators = "_-. ";

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kNamings.size(); ++i)
    if (static_cast<std::size_t>(kNamings[i].naming) != i) return false;
  return true;
}
static_assert(isInOrder());

const NamingTraits& findTraits(FaceNaming naming) { return kNamings[static_cast<std::size_t>(naming)]; }

/// "room_" of "room_PX".
struct FaceBase {
  std::string text;
  bool is_apart;    ///< the ending is the whole name, or stands behind a separator
  bool is_capital;  ///< the ending is written in capital letters
};

std::optional<FaceBase> splitEnding(const std::string& stem, const NamingTraits& naming) {
  for (const std::string_view ending : naming.endings) {
    if (!lowerCase(stem).ends_with(lowerCase(ending))) continue;
    const std::string base = stem.substr(0, stem.size() - ending.size());
    const std::string_view written = std::string_view(stem).substr(base.size());
    const bool is_apart = base.empty() || kSeparators.find(base.back()) != std::string_view::npos;
    const bool is_capital =
        std::none_of(written.begin(), written.end(), [](unsigned char c) { return std::islower(c); });
    if (is_apart || naming.joins) return FaceBase{base, is_apart, is_capital && written != ending};
  }
  return std::nullopt;
}

/// The files of a folder by their names in small letters.
using Listing = std::map<std::string, fs::path>;

Listing readListing(const fs::path& folder) {
  Listing listing;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end; !error && entry != end;
       entry.increment(error))
    listing.emplace(lowerCase(entry->path().filename().string()), folder / entry->path().filename());
  return listing;
}

std::string upperCase(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  return upper;
}

/// The six files of a naming as they are spelled beside the named one.
FaceFiles spelledLike(const fs::path& file, const FaceBase& base, const NamingTraits& naming) {
  FaceFiles files{{}, naming.naming, 0};
  std::error_code error;
  for (std::size_t face = 0; face < files.paths.size(); ++face) {
    const std::string_view ending = naming.endings[face];
    const std::string name =
        base.text + (base.is_capital ? upperCase(ending) : std::string(ending)) + file.extension().string();
    files.paths[face] = file.parent_path() / name;
    files.present += fs::exists(files.paths[face], error) ? 1 : 0;
  }
  return files;
}

/// Takes files that are missing however else they are spelled in the folder.
void findInAnyCase(FaceFiles& files, const Listing& listing) {
  std::error_code error;
  for (fs::path& path : files.paths) {
    if (fs::exists(path, error)) continue;
    const auto listed = listing.find(lowerCase(path.filename().string()));
    if (listed == listing.end()) continue;
    path = listed->second;
    ++files.present;
  }
}

/// listing   of the file's folder; nullptr where it has not been read, which takes long in a large one
std::optional<FaceFiles> filesNamedLike(const fs::path& file, const Listing* listing) {
  std::optional<Listing> read;
  std::optional<FaceFiles> best;
  for (const NamingTraits& naming : kNamings) {
    const auto base = splitEnding(file.stem().string(), naming);
    if (!base) continue;
    FaceFiles files = spelledLike(file, *base, naming);
    if (files.present < 6 && !naming.is_common) {
      if (!listing && !read) read = readListing(file.parent_path());
      findInAnyCase(files, listing ? *listing : *read);
    }
    const bool needs_others = !base->is_apart && naming.naming != FaceNaming::signs;
    const int needed = naming.is_common ? 6 : needs_others ? kMostOfSix : 0;
    if (files.present >= needed && (!best || files.present > best->present)) best = std::move(files);
  }
  return best;
}

}  // namespace

const std::array<std::string_view, 6>& endingsOf(FaceNaming naming) { return findTraits(naming).endings; }

std::string textOf(FaceNaming naming) { return join(endingsOf(naming), " "); }

std::string usualReading(FaceNaming naming) {
  const std::string_view reading = findTraits(naming).reading;
  return reading.empty() ? "faces" : "faces:" + std::string(reading);
}

bool isCommon(FaceNaming naming) { return findTraits(naming).is_common; }

std::optional<FaceFiles> faceFilesBeside(const fs::path& file) { return filesNamedLike(file, nullptr); }

bool lacksBottomAlone(const FaceFiles& files) {
  std::error_code error;
  return files.present == 5 && !isCommon(files.naming) && !fs::exists(files.paths[kBottomFace], error);
}

std::string listFaces(const FaceFiles& files, bool exist, const fs::path& but) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::path& path : files.paths)
    if (fs::exists(path, error) == exist && path != but) names.push_back(path.filename().string());
  return join(names, ", ", " and ");
}

Result<FaceFiles> faceFilesIn(const fs::path& folder) {
  const Listing listing = readListing(folder);
  std::vector<FaceFiles> cubes;
  std::optional<FaceFiles> nearly;
  for (const auto& [name, path] : listing) {
    auto files = filesNamedLike(path, &listing);
    const auto is_same = [&](const FaceFiles& other) { return other.paths == files->paths; };
    if (files && files->present == 6 && std::none_of(cubes.begin(), cubes.end(), is_same))
      cubes.push_back(std::move(*files));
    else if (files && files->present >= kMostOfSix && (!nearly || files->present > nearly->present))
      nearly = std::move(*files);
  }
  // Six numbered pictures beside a cube are not a second one.
  const auto is_common = [](const FaceFiles& files) { return isCommon(files.naming); };
  if (!std::all_of(cubes.begin(), cubes.end(), is_common)) std::erase_if(cubes, is_common);
  if (cubes.size() == 1) return std::move(cubes[0]);
  if (cubes.empty() && nearly && lacksBottomAlone(*nearly)) return std::move(*nearly);
  if (cubes.empty() && nearly)
    return fail(ErrorCode::not_found, folder.string() + ": holds " + std::to_string(nearly->present) +
                                          " of the six files of a cube, without " + listFaces(*nearly, false));
  if (cubes.empty())
    return fail(ErrorCode::not_found, folder.string() +
                                          ": is a folder without the six files of a cube, such as px nx "
                                          "py ny pz nz or right left top bottom front back; name a file in it");
  return fail(ErrorCode::usage, folder.string() + ": holds " + std::to_string(cubes.size()) +
                                    " cubes; name one of the six files, such as " +
                                    cubes[0].paths[0].filename().string());
}

}  // namespace mirrorball
