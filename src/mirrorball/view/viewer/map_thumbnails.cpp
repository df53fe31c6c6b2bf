#include "mirrorball/view/viewer/map_thumbnails.h"

#include <algorithm>
#include <utility>

#include "mirrorball/base/range.h"
#include "mirrorball/codec/color/automatic_exposure.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/view/viewer/map_loading.h"

namespace mirrorball {
namespace {

constexpr int kHeight_px = 48;

Result<Image8> thumbnailOf(const AskedMap& asked, const ProgressFunction& progress) {
  MIRRORBALL_TRY(source, loadMap(asked, {.environment = {.repair = true}}, progress));
  MIRRORBALL_TRY(map, convert(source.loaded.environment, Projection::equirect, kHeight_px, {}, progress));
  Image light = pictureOf(std::move(map), {.projection = Projection::equirect});
  const Display display{.exposure_ev = automaticExposure(light), .tone_map = ToneMap::agx};
  Image opaque(light.width(), light.height(), 4, 1.0f);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) std::copy_n(light.texel(x, y), 3, opaque.texel(x, y));
  return displayedPicture(display, std::move(opaque));
}

}  // namespace

MapThumbnails::Key MapThumbnails::keyOf(const Workspace& workspace, const std::string& map) {
  return {map, workspace.photos.contains(map)};
}

MapThumbnails::MapThumbnails(const Device& device) : on_(new OnDevice{device}) {}

Result<bool> MapThumbnails::follow(const Workspace& workspace) {
  if (auto ready = making_.take()) {
    MIRRORBALL_TRY_VOID(on_->device.state().context.enter());
    std::optional<gl::Framebuffer>& picture = on_->thumbnails.at(making_key_).picture;
    if (*ready) {
      MIRRORBALL_TRY_VOID(gl::resize(picture, gl::Format::rgba8, {(*ready)->width(), (*ready)->height()}));
      picture->upload(std::move(**ready));
    } else {
      picture.reset();
    }
    return true;
  }
  if (making_.isRunning() || isDone(workspace)) return false;
  MIRRORBALL_TRY_VOID(on_->device.state().context.enter());
  const auto is_let_go = [&](const auto& each) {
    return !contains(workspace.maps, each.first.first) || each.first != keyOf(workspace, each.first.first);
  };
  if (std::erase_if(on_->thumbnails, is_let_go) > 0) return true;
  for (const std::string& map : workspace.maps) {
    if (isMade(workspace, map)) continue;
    making_key_ = keyOf(workspace, map);
    Thumbnail& thumbnail = on_->thumbnails[making_key_];
    thumbnail.asked = askedMap(workspace, map);
    thumbnail.watch.watch({map});
    thumbnail.is_stale = false;
    making_.begin([asked = thumbnail.asked](const ProgressFunction& progress) { return thumbnailOf(asked, progress); });
    break;
  }
  return false;
}

bool MapThumbnails::isMade(const Workspace& workspace, const std::string& map) const {
  const auto found = on_->thumbnails.find(keyOf(workspace, map));
  if (found == on_->thumbnails.end() || found->second.is_stale) return false;
  return found->second.picture || found->second.asked == askedMap(workspace, map);
}

bool MapThumbnails::isDone(const Workspace& workspace) const {
  if (!hasSeveralMaps(workspace)) return true;
  for (const std::string& map : workspace.maps)
    if (!isMade(workspace, map)) return false;
  return !making_.isRunning();
}

void MapThumbnails::askDisk() {
  for (auto& [key, thumbnail] : on_->thumbnails)
    if (thumbnail.watch.hasChanged()) thumbnail.is_stale = true;
}

std::vector<MapThumbnail> MapThumbnails::of(const Workspace& workspace) const {
  std::vector<MapThumbnail> thumbnails;
  if (!hasSeveralMaps(workspace)) return thumbnails;
  const std::string& shown = mapOf(workspace, editedSide(workspace));
  for (const std::string& map : workspace.maps) {
    MapThumbnail& thumbnail = thumbnails.emplace_back(MapThumbnail{.name = map, .is_shown = map == shown});
    const auto found = on_->thumbnails.find(keyOf(workspace, map));
    if (found == on_->thumbnails.end() || !found->second.picture) continue;
    const gl::Framebuffer& picture = *found->second.picture;
    thumbnail.texture = picture.color().name();
    thumbnail.size_px = {picture.width(), picture.height()};
  }
  return thumbnails;
}

}  // namespace mirrorball
