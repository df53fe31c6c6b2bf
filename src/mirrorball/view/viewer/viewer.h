#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/stage/device.h"
#include "mirrorball/render/stage/stage.h"
#include "mirrorball/view/control/event.h"
#include "mirrorball/view/viewer/picture_job.h"
#include "mirrorball/view/viewer/under_pointer.h"
#include "mirrorball/view/viewer/viewer_status.h"
#include "mirrorball/view/workspace/history.h"

namespace mirrorball {

struct ViewerOptions {
  double frame_s = 0.016;                 ///< that a picture may take while something moves [s]
  std::optional<CacheFolder> cache = {};  ///< of prefiltered environments
  bool inside_only = true;                ///< ModelLoadOptions::inside_only
};

/// A viewer without a screen: events and time go in, pictures come out. Models and maps are loaded beside it, and what
/// a technique needs of a scene is found beside it; until that is there, the picture before stays. While something
/// moves, pictures are as large as their time allows (TimeBudget), of one sample each; once it rests, all samples of
/// the whole picture follow, one with each `advance`. In a comparison there are two halves, each with its technique,
/// map and quality, or traced by paths; what a traced one shows while something moves is drawn.
class Viewer {
 public:
  /// size_px   of the picture
  Viewer(const Device& device, Workspace start, glm::ivec2 size_px, ViewerOptions options = {});
  Viewer(Viewer&&) noexcept;
  Viewer& operator=(Viewer&&) noexcept;
  ~Viewer();

  /// Takes note of what a user does.
  void handle(const Event& event);

  /// Lets time go on, takes what was loaded, and does the next piece of work: makes a program, or draws a sample.
  ///
  /// seconds  since the call before, however long that is
  /// returns  whether there is another picture than before
  /// errors   no_gl. All else that fails is told in the status, and the picture before stays
  /// cost     that of the piece; a model that is being read does not stop when another is asked for, and the end of the
  ///          viewer waits for it
  Result<bool> advance(double seconds);

  /// Whether nothing is left to do until something else happens: nothing is loaded, and the picture has all its
  /// samples, or the status says why not.
  bool isDone() const;
  /// Whether all that is left goes on beside the viewer, so that a host may sleep a little before it asks again.
  bool isWaiting() const;

  const Workspace& workspace() const;
  /// As it is to be kept: of an animation that goes on the moment that is shown, seen as it is.
  Workspace stillWorkspace() const;
  /// That, for `render` to draw the picture that is seen: where a sun throws a shadow, and the workspace leaves the
  /// camera's place open, `render` holds the shadow alone, so the camera is where it is seen from, in numbers.
  Workspace renderedWorkspace() const;
  /// What was done; a change of it is seen with the next `advance`.
  History& history();
  ViewerStatus status() const;
  /// The material that is selected, as panelsOf takes it; null: none is. Valid until the next `advance`.
  const Material* selectedMaterial() const;

  /// What is told of the place under the pointer, and written over the picture: while the map is shown alone, or where
  /// the workspace inspects.
  UnderPointer underPointer() const;

  /// The panoramas that there are to choose among; empty: there is but one. Textures stay until the next `advance`.
  std::vector<MapThumbnail> thumbnails() const;

  /// Whether there is a picture.
  bool hasPicture() const;
  /// Draws the last picture into a part of a framebuffer, stretched to its size; of a comparison both halves or what
  /// they differ by, as the workspace says; black while there is none.
  ///
  /// framebuffer  OpenGL's name of it, of 8 bits a channel and one sample a pixel; 0 is a window's. It stays bound
  /// corner       the lower left one of that part [pixels]
  /// errors       no_gl
  Result<void> show(unsigned framebuffer, glm::ivec2 corner, glm::ivec2 size_px) const;
  /// Gives the context back to its host: Device::leave.
  ///
  /// errors   no_gl
  Result<void> leave() const;
  /// Makes a picture file beside the viewer, of the workspace as it is now (makePicture); one that is being made is
  /// left. The status tells what has become of it.
  void savePicture(PictureRequest request);
  /// Stops that.
  void cancelSaving();

  /// What `show` shows: 4 channels, sRGB-encoded, row 0 at the top. Without a comparison as it was drawn, else of the
  /// window's size.
  ///
  /// errors   usage: there is none; no_gl
  Result<Image8> picture() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
