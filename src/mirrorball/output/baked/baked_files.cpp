#include "mirrorball/output/baked/baked_files.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "mirrorball/base/file.h"
#include "mirrorball/base/folder.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/output/lamps/lamp_files.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// errors   usage: it is none of them
Result<std::string_view> extensionNamed(const std::string& name, std::span<const std::string_view> known) {
  if (const auto index = indexOfName(withoutDot(name), known)) return known[*index];
  return tl::unexpected<Error>(unknownName("extension", name, known));
}

/// The extension of a set's textures, or pictures.
///
/// errors   usage: none that there is, or none that the engine reads
Result<std::string_view> extensionFor(const EngineSet& set, const std::string& wanted) {
  if (wanted.empty() || set.files == SetFiles::packed) return set.extension;
  MIRRORBALL_TRY(extension, extensionNamed(wanted, bakedCubeExtensions()));
  if (set.files == SetFiles::cmgens && isTexturePath("x." + std::string(extension)) && extension != set.extension)
    return fail(ErrorCode::usage, programNameOf(set) + " reads ." + std::string(set.extension) + ", no ." +
                                      std::string(extension) + "; leave the extension to it");
  return extension;
}

/// The table as the cubes are stored, except for formats that would round it to a percent.
BrdfFile brdfFile(const std::string& stem, std::string_view extension, const BakedSetSettings& settings) {
  BrdfFile file{.path = stem + "." + std::string(extension),
                .facts = {writtenSetting(settings, "distribution"), writtenSetting(settings, "brdf-axes"),
                          settings.brdf_channels}};
  const std::optional<TexelFormat> format = settings.file.format;
  // Pictures are in 32-bit floats unless told otherwise, as everywhere.
  const bool in_floats = format == TexelFormat::float32 || (format != TexelFormat::half && !file.isTexture());
  if (file.isTexture() && settings.brdf_channels == 2)
    file.format = in_floats ? TexelFormat::rg_float32 : TexelFormat::rg_half;
  else
    file.format = in_floats ? TexelFormat::float32 : TexelFormat::half;
  if (extension == "ktx2") file.zstandard_level = settings.file.zstandard_level;
  return file;
}

/// The lobes of a set's rows; 0: it has none.
///
/// errors   usage: no such rows are known
Result<int> settledLobes(const BakedSetSettings& settings) {
  const bool is_ggx = settings.distribution == Distribution::ggx;
  const bool is_asked_for = contains(settings.only, BakedPart::lobe_rows);
  const int lobes = settings.lobe_rows.value_or(is_ggx || is_asked_for ? BakedSetSettings::kUsualLobes : 0);
  if (lobes != 0 && lobes != 2 && lobes != 4 && lobes != 6)
    return fail(ErrorCode::usage, "rows have 2, 4 or 6 lobes, or 0 for no such table, not " + std::to_string(lobes));
  if (lobes > 0 && !is_ggx)
    return fail(ErrorCode::usage, "rows of lobes are known for ggx only, not for " +
                                      writtenSetting(settings, "distribution") + "; ask for none");
  if (lobes == 0 && is_asked_for)
    return fail(ErrorCode::usage,
                "{option:only} asks for rows of lobes, and {option:lobe-rows} 0 for none of them; "
                "leave one of the two out");
  return lobes;
}

/// A folder's own name, also of "." and "..".
std::string nameOfFolder(const std::string& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/// Refuses parts that a program's set does not consist of.
///
/// errors   usage
Result<void> checkParts(const BakedSetSettings& settings, const EngineSet& set) {
  if (settings.only.empty()) return {};
  if (set.files == SetFiles::packed)
    return fail(ErrorCode::usage, programNameOf(set) + " reads one ." + std::string(set.extension) +
                                      " with all in it, which has no parts; leave {option:only} out, or leave out "
                                      "{option:for} " +
                                      std::string(set.program));
  const auto refuse = [&](BakedPart part, bool is_there) -> Result<void> {
    if (is_there || !contains(settings.only, part)) return {};
    return fail(ErrorCode::usage, "{option:only} " + writtenSetting(settings, "only") + ": " +
                                      std::string(set.needs_no_others) + "; leave out what it has no use for");
  };
  MIRRORBALL_TRY_VOID(refuse(BakedPart::irradiance, set.files == SetFiles::ours));
  MIRRORBALL_TRY_VOID(refuse(BakedPart::brdf, set.files == SetFiles::ours));
  MIRRORBALL_TRY_VOID(refuse(BakedPart::lobe_rows, set.hasLobeRows()));
  return refuse(BakedPart::harmonics, set.hasHarmonics());
}

Result<void> addIrradiance(const BakedSetSettings& settings, std::string_view extension, const Observer& observer,
                           BakedFiles& files) {
  MIRRORBALL_TRY(irradiance,
                 CubeFiles::resolve(settings.file, files.folder, {"irradiance", "i"}, extension, 1, observer));
  files.irradiance = std::move(irradiance);
  return {};
}

Result<void> addBrdf(const BakedSetSettings& settings, std::string_view extension, BakedFiles& files) {
  const std::string_view usual = extension == "hdr" ? bakedBrdfExtensions().back() : extension;
  const std::string brdf = settings.brdf_extension.empty() ? std::string(usual) : settings.brdf_extension;
  MIRRORBALL_TRY(brdf_extension, extensionNamed(brdf, bakedBrdfExtensions()));
  files.brdf = brdfFile(files.folder + "/brdf", brdf_extension, settings);
  return {};
}

Result<void> addLobeRows(const BakedSetSettings& settings, BakedFiles& files) {
  MIRRORBALL_TRY(lobes, settledLobes(settings));
  const bool has_text = files.set.files == SetFiles::ours;
  if (lobes > 0) files.lobe_rows = LobeRowFiles{files.folder, lobes, settings.file.zstandard_level, has_text};
  return {};
}

bool wantsSkybox(const BakedSetSettings& settings, const EngineSet& set) {
  if (!settings.only.empty()) return settings.makes(BakedPart::skybox);
  return set.files == SetFiles::cmgens || settings.skybox || settings.skybox_size > 0;
}

/// One texture with the chain, or with the one cube that is asked for.
///
/// errors   usage: it has no place for what is asked for
Result<BakedFiles> oneTexture(const std::string& output, const BakedSetSettings& settings, const EngineSet& set,
                              const Observer& observer) {
  const BakedPart part = settings.only.empty() ? BakedPart::specular : settings.only.front();
  const bool is_cube = part == BakedPart::specular || part == BakedPart::irradiance || part == BakedPart::skybox;
  if (!is_cube || settings.only.size() > 1)
    return fail(ErrorCode::usage, output + ": one texture holds specular, irradiance or skybox, not " +
                                      writtenSetting(settings, "only") + "; name a folder, without an extension");
  // A packed file has no parts, but its program may read any cube as a texture.
  if (set.files != SetFiles::packed) MIRRORBALL_TRY_VOID(checkParts(settings, set));
  MIRRORBALL_TRY(cube, CubeFiles::resolve(settings.file, output, observer));
  BakedFiles files{.set = set};
  std::optional<CubeFiles>& place = part == BakedPart::irradiance ? files.irradiance
                                    : part == BakedPart::skybox   ? files.skybox
                                                                  : files.specular;
  place = std::move(cube);
  return files;
}

Result<BakedFiles> filesInFolder(const std::string& output, const BakedSetSettings& settings, const EngineSet& set,
                                 const Observer& observer) {
  const bool is_cmgens = set.files == SetFiles::cmgens;
  MIRRORBALL_TRY_VOID(checkParts(settings, set));
  MIRRORBALL_TRY(extension, extensionFor(set, settings.extension));
  std::string folder = output;
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  std::error_code status;
  if (fs::exists(folder, status) && !fs::is_directory(folder, status))
    return fail(ErrorCode::usage, folder + ": is a file; name a folder, or a " +
                                      writtenExtensions(Holds::texture, " or ") + " file for the chain only");
  const bool is_packed = set.files == SetFiles::packed;
  const std::string prefix = is_cmgens ? nameOfFolder(folder) + "_" : "";
  BakedFiles files{.folder = folder, .set = set};
  if (is_packed) files.packed = folder + "/" + kPackedStem + "." + std::string(extension);
  if ((!is_packed || !set.beside.empty()) && settings.makes(BakedPart::specular)) {
    const CubeNames chain{is_cmgens ? prefix + "ibl" : is_packed ? kPackedStem : "specular", "m", true};
    MIRRORBALL_TRY(specular, CubeFiles::resolve(settings.file, folder, chain, is_packed ? set.beside : extension,
                                                settings.levels, observer));
    files.specular = std::move(specular);
  }
  if (!is_packed && wantsSkybox(settings, set)) {
    MIRRORBALL_TRY(skybox,
                   CubeFiles::resolve(settings.file, folder, {prefix + "skybox", "skybox"}, extension, 1, observer));
    files.skybox = std::move(skybox);
  }
  if (settings.split) files.lamps = lampFilesFor(folder + "/" + kLampStem, settings.file.program);
  const bool is_ours = set.files == SetFiles::ours;
  if (is_ours && settings.makes(BakedPart::irradiance))
    MIRRORBALL_TRY_VOID(addIrradiance(settings, extension, observer, files));
  if (is_ours && settings.makes(BakedPart::brdf)) MIRRORBALL_TRY_VOID(addBrdf(settings, extension, files));
  if (set.hasLobeRows() && settings.makes(BakedPart::lobe_rows)) MIRRORBALL_TRY_VOID(addLobeRows(settings, files));
  if (set.hasHarmonics() && settings.makes(BakedPart::harmonics))
    files.harmonics = is_ours ? std::vector<std::string>{"sh.json", "sh.h"} : std::vector<std::string>{"sh.txt"};
  return files;
}

}  // namespace

Result<std::optional<TexelFormat>> settledFormat(const EngineSet& set, const BakedSetSettings& settings,
                                                 const std::string& extension) {
  const std::optional<TexelFormat> wanted = settings.file.format;
  const bool is_engines = extension.empty() || indexOfName(extension, {&set.extension, 1}).has_value();
  if (!is_engines || set.other_formats.empty()) return wanted;
  if (!wanted || wanted == set.format) return set.format;
  if (contains(set.other_formats, *wanted)) return wanted;
  const auto nameOf = [](TexelFormat one) { return kTexelFormatNames[static_cast<std::size_t>(one)].name; };
  std::vector<std::string_view> known;
  if (set.format) known.push_back(nameOf(*set.format));
  for (const TexelFormat one : set.other_formats) known.push_back(nameOf(one));
  return fail(ErrorCode::usage, programNameOf(set) + " reads " + join(known, ", ", " and ") + ", no " +
                                    std::string(nameOf(*wanted)) + "; leave the format to it");
}

Result<BakedFiles> BakedFiles::resolve(const std::string& output, const BakedSetSettings& settings,
                                       const EngineSet& set, const Observer& observer) {
  if (!isOneFile(output)) return filesInFolder(output, settings, set, observer);
  if (set.files == SetFiles::packed && extensionOf(output) == set.extension) {
    MIRRORBALL_TRY_VOID(checkParts(settings, set));
    return BakedFiles{.set = set, .packed = output};
  }
  if (!isTexturePath(output)) {
    const std::string_view reader = programOfPacked(extensionOf(output));
    return fail(ErrorCode::usage,
                output + ": a prefiltered chain goes into " + writtenExtensions(Holds::texture, " or ") +
                    (set.files == SetFiles::packed ? ", or into ." + std::string(set.extension) : "") +
                    (reader.empty() ? "" : "; ." + extensionOf(output) + " is {option:for} " + std::string(reader)) +
                    "; or name a folder, without an extension");
  }
  return oneTexture(output, settings, set, observer);
}

std::vector<std::string> BakedFiles::paths() const {
  std::vector<std::string> all;
  const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
  if (!packed.empty()) add({packed});
  if (specular) add(specular->paths());
  if (irradiance) add(irradiance->paths());
  if (skybox) add(skybox->paths());
  if (folder.empty()) return all;
  if (brdf) add({brdf->path});
  add(lamps);
  if (lobe_rows) add({lobe_rows->texture()});
  if (lobe_rows && lobe_rows->has_text) add({lobe_rows->text()});
  for (const std::string& name : harmonics) add({folder + "/" + name});
  add({folder + "/" + kManifestName});
  return all;
}

const CubeFiles* BakedFiles::anyCube() const {
  for (const std::optional<CubeFiles>* const cube : {&specular, &irradiance, &skybox})
    if (*cube) return &**cube;
  return nullptr;
}

}  // namespace mirrorball
