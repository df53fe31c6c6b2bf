#include "mirrorball/render/surface/map_sampling.h"

namespace mirrorball {
namespace {

gl::Sampling::Wrap samplingWrap(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return gl::Sampling::Wrap::repeat;
    case Wrap::mirrored_repeat:
      return gl::Sampling::Wrap::mirrored_repeat;
    case Wrap::clamp_to_edge:
      break;
  }
  return gl::Sampling::Wrap::clamp_to_edge;
}

}  // namespace

gl::Sampling wrapOf(MapEdges edges) {
  const auto wrap = edges == MapEdges::tiled ? gl::Sampling::Wrap::repeat : gl::Sampling::Wrap::clamp_to_edge;
  return {.wrap_s = wrap, .wrap_t = wrap};
}

gl::Sampling wrapOf(const Texture& texture) {
  return {.magnify_nearest = texture.nearest,
          .wrap_s = samplingWrap(texture.wrap_s),
          .wrap_t = samplingWrap(texture.wrap_t)};
}

gl::Sampling samplingOf(gl::Sampling sampling, TextureFilter filter, float anisotropy) {
  sampling.filter = gl::Sampling::Filter::trilinear;
  switch (filter) {
    case TextureFilter::nearest:
      sampling.filter = gl::Sampling::Filter::nearest;
      break;
    case TextureFilter::bilinear:
      sampling.filter = gl::Sampling::Filter::linear;
      break;
    case TextureFilter::anisotropic:
      sampling.anisotropy = anisotropy;
      break;
    case TextureFilter::trilinear:
      break;
  }
  return sampling;
}

}  // namespace mirrorball
