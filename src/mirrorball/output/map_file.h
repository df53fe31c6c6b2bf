#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/observer.h"
#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/environment/file/light_limits.h"

namespace mirrorball {

struct ValueCounts;

/// Where mip levels come from.
enum class MipSource {
  automatic,    ///< a texture's own if its map is not changed, else weighted by solid angle
  solid_angle,  ///< MipWeights'
  box,
};

/// How a map goes into its file.
struct MapFileOptions {
  std::string program = {};                     ///< for this program: a preset's name (preset.h); empty: as ours
  bool as_seen = false;                         ///< then a cube's faces as pictures seen from inside
  Flip flip = Flip::none;                       ///< then each flipped
  std::optional<FaceOrder> face_order = {};     ///< then in that order
  std::optional<TexelFormat> format = {};       ///< nothing: as fits the file and the light
  int zstandard_level = 0;                      ///< of .ktx2: 1 fast … 22 small; 0: none
  LightLimits light = {};                       ///< of what is loaded or captured for it
  std::optional<CubeLayout> layout = {};        ///< of a cube in pictures; nothing: the program's, or hcross
  bool is_one_file = false;                     ///< refuse a cube as six pictures: the output is a pipe
  bool mips = false;                            ///< with all mip levels; of a picture, on a sheet
  std::optional<int> level = {};                ///< one mip level instead of the map
  MipSource mip_source = MipSource::automatic;  ///< weights of their texels
  Display display = {};                         ///< of pictures
  bool gain_map = false;                        ///< of a .jpg: light beside the picture (savePictureWithGainMap)
  OutputPrimaries primaries = OutputPrimaries::rec709;  ///< of the file's colours
};

/// The table of these options, except for those of pictures.
std::span<const Option<MapFileOptions>> mapFileOptions();
/// The options that apply to a cube's texture.
std::span<const Option<MapFileOptions>> textureFileOptions();
/// Those of maps in .png and .jpg: how light becomes a picture.
std::span<const Option<MapFileOptions>> mapPictureOptions();

/// Where a map goes, and in which form.
class MapFile {
 public:
  /// Checks names only, not whether the folder exists.
  ///
  /// observer  told of what is written by it, and of what its file does not hold
  /// errors    usage: what the options ask for does not exist, or not in such a file
  static Result<MapFile> resolve(const std::string& path, const MapFileOptions& options, Projection projection,
                                 Observer observer = {});

  /// The files: one, or the six of a cube whose layout is `faces`.
  std::vector<std::string> paths() const;

  /// Whether the map can be written while it is converted: a texture of one level whose texels stay where they are.
  bool takesStrips() const;

  /// Whether the smaller levels that a texture has are wanted, if its map is not changed.
  bool takesOwnLevels() const { return (all_levels_ || level_.value_or(0) > 0) && mip_source_ == MipSource::automatic; }

  /// Whether it is a texture that could hold mip levels, and none was asked for.
  bool leavesLevelsOut() const { return is_texture_ && !hasLevels(); }

  /// Remarks that the program which the map is for makes no light of such a file, if that is so.
  void tellIfNotImported() const;

  /// errors   usage: a mip level is wanted that a map of that size does not have
  Result<void> checkLevelOfSize(int size) const;

  /// Writes a map to its files: the map, or all of its mip levels (a picture gets a sheet of them), or one of them. The
  /// files say what form the map has, except .dds, for which a remark says it. Light beyond the range of a requested
  /// format is lowered to its maximum, with a remark.
  ///
  /// errors   as writeImage's and writeImageSet's; usage: there is no such level
  Result<void> write(EnvironmentMap map) const;
  /// The same for a map's own levels, which are in the form of the file.
  Result<void> write(ImageSet levels) const;

  /// Writes a map that `convert_to` converts and hands on strip by strip. May call it twice: where the format is left
  /// to us and half floats do not hold the light, it is written in 32-bit floats.
  Result<void> writeByStrips(int size, const std::function<Result<void>(const TakeTexels&)>& convert_to) const;

  /// Writes the texture of a cube whose levels all exist already.
  ///
  /// facts    that it keeps beside its form
  /// returns  the format that it was written in
  Result<TexelFormat> writeLevels(ImageSet levels, const Metadata& facts = {}) const;

  /// Remarks how to read the file again, if it does not say what map it holds and would be taken for another.
  void remarkOnForm() const;

  /// How pictures hold light: "three channels of half floats".
  std::string pictureFormat() const;

  /// The memory that writing a cube of `size`² texels a face takes beside them.
  std::uint64_t memoryToWrite(int size) const;

  const MapForm& form() const { return form_; }

 private:
  Result<void> setForm(const MapFileOptions& options, Projection projection);
  Result<void> setFormat(const MapFileOptions& options);
  Result<void> setLevels(const MapFileOptions& options);
  Result<void> setPrimaries(const MapFileOptions& options);
  bool hasLevels() const { return all_levels_ || level_; }
  Result<void> writeFiles(ImageSet images, std::size_t negative) const;
  Result<void> writePictures(ImageSet images) const;
  /// The picture that goes into one of paths(): the map, or a sheet of its levels.
  Image pictureFor(ImageSet& images, std::size_t file) const;
  Result<TexelFormat> writeImages(const ImageSet& images, const Metadata& facts = {}) const;
  /// Brings light to the file's primaries, before it is limited to what the format holds: what is negative in Rec.709
  /// need not be in them. Pictures are converted when they are what a display shows.
  void convertLight(Image& image) const;
  /// Whether a format was asked for that does not hold all light.
  bool limitsLight() const;
  /// Lowers what that format does not hold; returns what is lost of the first level.
  LostLight limitLevels(ImageSet& levels) const;
  void tellLost(const LostLight& light) const;
  /// Whether its files hold no light below 0.
  bool refusesNegative() const;
  /// The levels of a map, or the one that is wanted, as the form has them.
  Result<ImageSet> levelsOf(EnvironmentMap map) const;
  Result<ImageSet> wantedOf(ImageSet levels) const;
  Result<void> checkLevel(int levels) const;
  /// Says what the format that was asked for does not hold: so many values below 0, alpha.
  void tellNegative(std::size_t negative) const;
  void remarkOnLosses(std::size_t negative) const;
  /// Says that half floats hold few digits of these values, where that is so.
  void tellDark(const ValueCounts& counts) const;
  /// Runs `write(format)`, once more in 32-bit floats where that is to be; returns the format.
  Result<TexelFormat> inFormat(const std::function<Result<void>(TexelFormat)>& write) const;

  std::string path_;
  MapForm form_;
  std::string hint_;                         // FormHint's words for the form
  std::optional<std::string> not_imported_;  // importedInstead() of the program
  FaceNaming naming_ = FaceNaming::px;
  bool is_texture_ = false;
  std::optional<TexelFormat> format_;  // nothing: half floats or, where they do not hold the light, 32-bit ones
  bool half_ = false;                  // of .exr
  int zstandard_level_ = 0;
  bool all_levels_ = false;
  std::optional<int> level_;
  MipSource mip_source_ = MipSource::automatic;
  Display display_;
  bool gain_map_ = false;
  OutputPrimaries primaries_ = OutputPrimaries::rec709;
  Observer observer_;
};

}  // namespace mirrorball
