#include "cli/picture_request.h"

#include "cli/terminal.h"
#include "mirrorball/environment/builtin/sunset.h"
#include "mirrorball/render/settings/frame_checks.h"

namespace mirrorball::cli {

void addPictureOptions(Command& command, PictureRequest& request) {
  addOptions(command, sceneOptions(), request.scene, &request.stated);
  addOptions(command, stanceOptions(), request.scene.stance);
  addOptions(command, qualityOptions(), request.scene.wish, &request.stated);
  addOptions(command, frameOptions(), request.frame, &request.stated);
  addOptions(command, materialOptions(), request.materials, &request.stated);
}

void setTheStage(PictureRequest& request) {
  request.frame.proxy.load.inside_only = request.scene.inside_only;
  if (request.scene.model != "showcase" || request.stated.contains("env")) return;
  if (!hasSunset()) remark("this build reads no OpenEXR, and so has no sunset: the showcase is in the studio");
  setShowcase(request.stated, request.scene.environment, request.frame);
}

Result<FrameSettings> checkedFrame(const PictureRequest& request) {
  FrameSettings settings = request.frame;
  MIRRORBALL_TRY_VOID(checkSettings(settings, request.stated));
  standOnGround(settings);
  return settings;
}

}  // namespace mirrorball::cli
