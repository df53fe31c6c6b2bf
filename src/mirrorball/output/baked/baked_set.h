#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/bake/brdf/brdf_table.h"
#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/observer.h"
#include "mirrorball/base/option.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/light_edit/lamp_settings.h"
#include "mirrorball/output/map_file.h"
#include "mirrorball/output/save_map.h"

namespace mirrorball {

/// What a set consists of, each of which can be asked for by itself.
enum class BakedPart { specular, irradiance, harmonics, brdf, lobe_rows, skybox };

/// Which maps are baked for an engine, and how they are stored. What is left open goes by the engine, `file.program`.
struct BakedSetSettings {
  int size = 256;  ///< side of a face in level 0 of the specular mip chain [texels]
  int levels = 0;  ///< number of mip levels, level 0 included; 0: down to the smallest face that the engine looks up
  Distribution distribution = Distribution::ggx;
  std::optional<MipMapping> mip_mapping = {};  ///< nothing: the engine's
  int irradiance_size = 32;                    ///< side of a face of the irradiance cube [texels]
  int harmonics_degree = 2;                    ///< highest band of the spherical harmonics, 2 to 4
  int brdf_size = 128;                         ///< side of the BRDF table [texels]
  int brdf_channels = 3;                       ///< 2 or 3: BrdfTableOptions::channels
  BrdfAxes brdf_axes = BrdfAxes::linear;
  /// Lobes in each row of the table of lobe rows: 2, 4 or 6; 0: no such table. Nothing: kUsualLobes for ggx, else none.
  std::optional<int> lobe_rows = {};
  static constexpr int kUsualLobes = 4;
  /// Of the table's file; empty: that of the others, but .exr in place of .hdr, or .dds in a build without OpenEXR.
  std::string brdf_extension = {};
  bool skybox = false;                 ///< also write the environment itself
  int skybox_size = 0;                 ///< side of its faces [texels]; 0: as fine as the environment, at most 1024
  bool split = false;                  ///< take small lamps out of the maps, and write them as files of their own
  LampSettings lamps = {};             ///< which; in a folder alone
  std::string extension = {};          ///< of the cubes' files; empty: the engine's
  std::vector<BakedPart> only = {};    ///< which parts are made; empty: all that the engine has a use for
  std::vector<float> rotate_deg = {};  ///< turns the light by yaw, pitch and roll; those that are missing are 0
  std::string made_by = "mirrorball";  ///< the program, for the manifest
  std::string source = {};             ///< the environment's name in the manifest; empty: that it was loaded by
  MapFileOptions file = {};            ///< of the cubes; their layout is the set's

  /// Whether `only` leaves a part in.
  bool makes(BakedPart part) const;
};

/// The table of these settings, except for `lamps`, `rotate_deg`, `made_by`, `source` and `file`.
std::span<const Option<BakedSetSettings>> bakedSetOptions();

/// The parts of a set that an option describes: one of that table, of textureFileOptions or lampOptions, or the
/// rotation. None: it concerns the whole set.
std::span<const BakedPart> partsDescribedBy(std::string_view option);

/// The maps of an environment that an engine needs, as files: a folder of them with a manifest, or the specular mip
/// chain, or another of the cubes, alone as one texture.
class BakedSet {
 public:
  /// Settles what the files are called and which format they have.
  ///
  /// output   a folder, which need not be there, or the name of a texture for the chain alone, or for the one cube that
  ///          the settings make
  /// observer told of progress, of finished files, and of what the maps lack
  /// errors   usage: the settings ask for what does not exist or what the engine does not read; a file has the folder's
  ///          name
  static Result<BakedSet> resolve(const std::string& output, const BakedSetSettings& settings, Observer observer = {});

  BakedSet(BakedSet&&) noexcept;
  BakedSet& operator=(BakedSet&&) noexcept;
  ~BakedSet();

  /// All files that are written.
  std::vector<std::string> paths() const;

  /// Begins the BRDF table on threads of its own: it needs no environment, and loading one leaves cores idle. A large
  /// table is left to `save`, which knows how much memory the maps take.
  ///
  /// errors   too_large
  Result<void> begin();

  /// Bakes the maps and writes the files. A folder that was not there is gone again if they could not all be written;
  /// of an older set in a folder the manifest is gone then, and files may be. Where the settings make only some parts,
  /// the others of an older set of the same light stay, and in the manifest, also if the new ones could not be written.
  ///
  /// environment  none of whose files is one of `paths()`; values below 0 are taken as 0, which a remark tells
  /// errors       usage or bad_file, before anything is made: an older set has other parts of another light, or a
  ///              manifest that cannot be read; out_of_range (too bright to be summed); too_large, before anything is
  ///              made; interrupted; io
  /// cost         as bake's, and that of packing and writing
  Result<void> save(LoadedEnvironment environment);

 private:
  struct Parts;
  explicit BakedSet(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

/// The same in one call.
///
/// errors   as BakedSet's
Result<SavedMap> saveBakedSet(const std::string& output, LoadedEnvironment environment,
                              const BakedSetSettings& settings = {}, const Observer& observer = {});

}  // namespace mirrorball
