#include "mirrorball/view/viewer/screenshot.h"

#include <algorithm>
#include <utility>

#include "mirrorball/codec/image_file.h"

namespace mirrorball {

Result<Screenshot> Screenshot::make(glm::ivec2 size_px) {
  MIRRORBALL_TRY(picture, gl::Framebuffer::make(gl::Format::rgba8, size_px.x, size_px.y));
  return Screenshot(std::move(picture));
}

Result<void> Screenshot::save(const std::string& path) const {
  const Image8 drawn = picture_.readBytes();
  Image8 seen(drawn.width(), drawn.height(), 3);
  for (int y = 0; y < seen.height(); ++y)
    for (int x = 0; x < seen.width(); ++x) std::copy_n(drawn.texel(x, y), 3, seen.texel(x, y));
  return savePicture(path, seen);
}

}  // namespace mirrorball
