#pragma once

#include <span>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/handle.h"
#include "mirrorball/gl/sampler.h"
#include "mirrorball/image/image.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball::gl {

/// How texels are kept on the GPU.
enum class Format {
  rgba8,             ///< 8 bits, linear
  srgb8_alpha8,      ///< 8 bits, decoded from sRGB when sampled
  rgba16f,           ///< half floats: radiance up to 65504
  rgba32f,           ///< floats; OpenGL ES interpolates them only where Context::filtersFloats says so
  r32f,              ///< floats, the first channel alone; not filtered
  rg32f,             ///< likewise the first two
  depth24,           ///< depths, 0 to 1, of a Framebuffer: read by single texels
  depth24_stencil8,  ///< the same, with eight bits beside each that draws may ask
  rgba32ui,          ///< words that shaders take for what they like; of no mip levels, and not to be filtered
};

/// A 2D texture, an array of them or a cube map, of any number of mip levels. Texel rows are as in Image: row 0 is at
/// t = 0. It starts with Sampling{}; rgba32f, which OpenGL ES cannot filter, with Filter::nearest.
///
/// Uploads and settings go through texture unit 15, which is therefore no unit to bind textures to.
class Texture {
 public:
  /// A 2D texture whose texels are undefined until uploaded or rendered.
  ///
  /// levels   mip levels, level k being max(1, side >> k); kAllLevels: down to 1 × 1
  /// errors   too_large: a side is longer than the driver takes
  static Result<Texture> make2d(Format format, int width, int height, int levels = 1);

  /// A cube map, faces in the order +X −X +Y −Y +Z −Z, each as OpenGL's table has it. Always
  /// clamped to its edges and filtered across them.
  ///
  /// errors   too_large
  static Result<Texture> makeCube(Format format, int size, int levels = 1);

  /// An array of 2D textures of the same size, whose texels are undefined until uploaded.
  ///
  /// layers   at most 256, which every driver takes
  /// errors   too_large
  static Result<Texture> makeArray(Format format, int width, int height, int layers, int levels = 1);

  /// A texture with all levels of `images`: a cube if it has six faces, else 2D.
  ///
  /// errors   too_large
  static Result<Texture> fromImages(Format format, const ImageSet& images);

  /// A list of texels of four words, for the shaders' fetchWords (gl/shader_source.h): rows of kWordTexels.
  ///
  /// words    at least one
  /// errors   too_large: a side is longer than the driver takes, or there is no memory
  static Result<Texture> fromWords(std::span<const glm::uvec4> words);
  static constexpr int kWordTexels = 4096;

  static constexpr int kAllLevels = 0;

  /// Texture units to bind to.
  static constexpr int kUnits = 15;

  /// Replaces one image by linear floats. A grey image fills r, g and b; alpha is 1 where the image
  /// has none. Formats of one or two channels take as many from any image that has them. In 8-bit
  /// formats [0, 1] is stored (sRGB-encoded for srgb8_alpha8); rgba16f clamps to ±65504.
  ///
  /// face     of a cube; of an array the layer; else 0
  /// image    of exactly the level's size, with 1, 3 or 4 channels. Of an array's layer it may be smaller: it then
  ///          lies at texel (0, 0), and the others stay as they are
  void upload(int level, int face, const Image& image);

  /// Replaces one image of an 8-bit format by bytes as they are; the channels as above.
  void upload(int level, int face, const Image8& image);
  void upload(const Image8& image) { upload(0, 0, image); }

  /// Replaces all images by those of a set of as many levels and faces.
  void upload(const ImageSet& images);

  /// Makes the further levels of the first by the driver's own filter. Of a picture, not of light that must stay exact.
  void makeLevels();

  void setSampling(const Sampling& sampling);

  /// Shaders see only the levels from `first` to `last`, `first` being their lod 0: a level that is drawn into must not
  /// be among those that are read.
  void setLevels(int first, int last);

  /// Binds to a texture unit, 0 to kUnits − 1, for the sampler uniform that is set to that number.
  ///
  /// sampler   how it is read there; null: as setSampling says
  void bind(int unit, const Sampler* sampler = nullptr) const;

  /// Reads one image back: 4 channels as a shader would sample them, so sRGB is decoded. In OpenGL
  /// ES the format must be one that the driver can draw into.
  Image read(int level = 0, int face = 0) const;

  Format format() const { return format_; }
  bool isCube() const { return shape_ == Shape::cube; }
  int width() const { return width_; }
  int height() const { return height_; }
  int levels() const { return levels_; }
  /// What its texels take, of all levels.
  std::size_t bytes() const;
  unsigned name() const { return handle_.name(); }  ///< for a call that this class does not have

 private:
  enum class Shape { plane, array, cube };

  static void destroy(unsigned name);
  Texture(Format format, Shape shape, int width, int height, int layers, int levels);
  static Result<Texture> make(Format format, Shape shape, int width, int height, int layers, int levels);
  unsigned target() const;
  unsigned imageTarget(int face) const;
  void bindForWork() const;
  bool takes(int level, int width, int height) const;
  /// Replaces an image row by row: fill(y, rgba) writes row y as the GPU keeps it.
  ///
  /// channels   of the rows
  template <typename Component, typename Fill>
  void uploadRows(int level, int face, int width, int height, Fill&& fill, int channels = 4);

  Handle<destroy> handle_;
  Format format_;
  Shape shape_;
  int width_;
  int height_;
  int layers_;  ///< faces of a cube
  int levels_;
  float anisotropy_ = 1.0f;
};

}  // namespace mirrorball::gl
