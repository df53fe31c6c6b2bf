#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/bake/mip_chain.h"
#include "mirrorball/base/option.h"
#include "mirrorball/codec/texture_file.h"
#include "mirrorball/environment/convert.h"
#include "mirrorball/environment/light_limits.h"
#include "mirrorball/environment/preset.h"

namespace mirrorball::cli {

/// What a command that writes a map is told about its files.
struct MapOutputOptions {
  std::string output;
  std::string layout;
  std::string program;
  bool as_seen = false;
  std::string face_order;
  std::string flip = "none";
  std::string format = "auto";
  int zstandard_level = 0;
  float scale_light = 1.0f;
  float clamp_light = 0.0f;
  bool mips = false;
  MipWeights mip_weights = MipWeights::solid_angle;
};

std::span<const Option<MapOutputOptions>> mapOutputOptions();
/// Those of them that a cube's texture may be asked for, without --output.
std::span<const Option<MapOutputOptions>> textureOutputOptions();

/// What --scale-light and --clamp-light ask for.
LightLimits lightLimits(const MapOutputOptions& options);

/// Says how much light --clamp-light took from a map, if any.
void tellClamped(const std::string& name, const LostLight& light);

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

  /// Writes a map to its files, which say what form it has. Light beyond a format that was asked for is lowered to the
  /// most that it holds, with a remark.
  ///
  /// errors   as writeImage's and writeImageSet's
  Result<void> write(EnvironmentMap map) const;

  /// Writes a map that `convert_to` converts and hands on piece by piece. May call it twice: where the format is left to
  /// us and half floats do not hold the light, it is written in 32-bit floats.
  Result<void> writePieces(int size, const std::function<Result<void>(const TakeTexels&)>& convert_to) const;

  /// Writes a cube's texture, all of whose levels are made already.
  ///
  /// returns  the format that it was written in
  Result<TexelFormat> writeLevels(ImageSet levels) const;

  /// The memory that writing a cube of `size`² texels a face takes beside them.
  std::uint64_t memoryToWrite(int size) const;

  const MapForm& form() const { return form_; }

 private:
  Result<void> setForm(const MapOutputOptions& options, Projection projection);
  Result<void> setFormat(const MapOutputOptions& options);
  Result<TexelFormat> writeImages(const ImageSet& images) const;
  /// Whether a format was asked for that does not hold all light.
  bool limitsLight() const;
  /// Lowers what that format does not hold; returns what is lost of the first level.
  LostLight limitLevels(ImageSet& levels) const;
  void tellLost(const LostLight& light) const;
  Result<ImageSet> textureImages(EnvironmentMap map) const;
  /// Says what the format that was asked for does not hold: so many values below 0, alpha.
  void tellNegative(std::size_t negative) const;
  void remarkOnLosses(std::size_t negative) const;
  /// Runs `write(format)`, once more in 32-bit floats where that is to be; returns the format.
  Result<TexelFormat> inFormat(const std::function<Result<void>(TexelFormat)>& write) const;

  std::string output_;
  MapForm form_;
  FaceNaming naming_ = FaceNaming::px;
  bool is_texture_ = false;
  std::optional<TexelFormat> format_;  // nothing: half floats or, where they do not hold the light, 32-bit ones
  bool half_ = false;                  // of .exr
  int zstandard_level_ = 0;
  std::optional<MipWeights> mips_;
};

}  // namespace mirrorball::cli
