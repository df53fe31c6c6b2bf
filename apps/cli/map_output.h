#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/command.h"
#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/environment/file/light_limits.h"

namespace mirrorball::cli {

/// Where mip levels come from.
enum class MipSource {
  automatic,    ///< a texture's own where its map stays as it is, else weighted by solid angle
  solid_angle,  ///< MipWeights'
  box,
};

/// What a command that writes a map is told about its files.
struct MapOutputOptions {
  std::string output;
  std::string layout;
  std::string program;
  bool as_seen = false;
  std::string face_order;
  std::string flip = "none";
  std::optional<TexelFormat> format;  ///< nothing: as fits the file
  int zstandard_level = 0;
  float scale_light = 1.0f;
  float clamp_light = 0.0f;
  bool mips = false;
  std::optional<int> level;
  MipSource mip_source = MipSource::automatic;
  Display display = {};     ///< of pictures
  GivenOptions given = {};  ///< which options were given, as far as it matters
};

std::span<const Option<MapOutputOptions>> mapOutputOptions();
/// Those of them that a cube's texture may be asked for, without --output.
std::span<const Option<MapOutputOptions>> textureOutputOptions();

/// A projection that --to names.
///
/// errors   usage: there is none such; a cube's layout is no projection
Result<Projection> projectionToWrite(const std::string& name);

/// What --scale-light and --clamp-light ask for.
LightLimits lightLimits(const MapOutputOptions& options);

/// Says how much light --clamp-light took from a map, if any.
void tellClamped(const std::string& name, const LostLight& light);

/// Refuses what can be refused before the map's projection is known.
///
/// errors   usage
Result<void> checkMapOutput(const MapOutputOptions& options, const std::string& output);

/// Where a map goes, and in which form.
class MapOutput {
 public:
  /// Looks at names only: whether the folder is there is another matter (files.h).
  ///
  /// errors   usage: what the options ask for does not exist, or not in such a file
  static Result<MapOutput> resolve(const MapOutputOptions& options, Projection projection);

  /// The files: one, or the six of a cube whose layout is `faces`.
  std::vector<std::string> paths() const;

  /// Whether the map can be written while it is converted: a texture of one level whose texels stay where they are.
  bool takesPieces() const;

  /// Whether of a texture whose map stays as it is those smaller levels are wanted that it has.
  bool takesOwnLevels() const { return (all_levels_ || level_.value_or(0) > 0) && mip_source_ == MipSource::automatic; }

  /// errors   usage: a mip level is wanted that a map of that size does not have
  Result<void> checkLevelOfSize(int size) const;

  /// Writes a map to its files, which say what form it has (all but .dds: of that a remark tells): the map, or its mip levels, of which pictures get a sheet, or
  /// one of them. Light beyond a format that was asked for is lowered to the most that it holds, with a remark.
  ///
  /// errors   as writeImage's and writeImageSet's; usage: there is no such level
  Result<void> write(EnvironmentMap map) const;
  /// The same of a map's own levels, as the form has them.
  Result<void> write(ImageSet levels) const;

  /// Writes a map that `convert_to` converts and hands on piece by piece. May call it twice: where the format is left to
  /// us and half floats do not hold the light, it is written in 32-bit floats.
  Result<void> writePieces(int size, const std::function<Result<void>(const TakeTexels&)>& convert_to) const;

  /// Writes a cube's texture, all of whose levels are made already.
  ///
  /// facts    that it keeps beside its form
  /// returns  the format that it was written in
  Result<TexelFormat> writeLevels(ImageSet levels, const Metadata& facts = {}) const;

  /// Says how to read the file again, if it is one that does not say what map it holds and that would be taken for another.
  void remarkOnForm() const;

  /// How pictures hold light: "three channels of half floats".
  std::string pictureFormat() const;

  /// The memory that writing a cube of `size`² texels a face takes beside them.
  std::uint64_t memoryToWrite(int size) const;

  const MapForm& form() const { return form_; }

 private:
  Result<void> setForm(const MapOutputOptions& options, Projection projection);
  Result<void> setFormat(const MapOutputOptions& options);
  Result<void> setLevels(const MapOutputOptions& options);
  bool hasLevels() const { return all_levels_ || level_; }
  Result<void> writeFiles(ImageSet images, std::size_t negative) const;
  Result<void> writePictures(ImageSet images) const;
  Result<TexelFormat> writeImages(const ImageSet& images, const Metadata& facts = {}) const;
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
  /// Runs `write(format)`, once more in 32-bit floats where that is to be; returns the format.
  Result<TexelFormat> inFormat(const std::function<Result<void>(TexelFormat)>& write) const;

  std::string output_;
  MapForm form_;
  std::string hint_;  // what --from calls the form
  FaceNaming naming_ = FaceNaming::px;
  bool is_texture_ = false;
  std::optional<TexelFormat> format_;  // nothing: half floats or, where they do not hold the light, 32-bit ones
  bool half_ = false;                  // of .exr
  int zstandard_level_ = 0;
  bool all_levels_ = false;
  std::optional<int> level_;
  MipSource mip_source_ = MipSource::automatic;
  Display display_;
};

}  // namespace mirrorball::cli
