#include "mirrorball/view/control/commands.h"

#include <array>
#include <string>
#include <utility>

#include "mirrorball/view/control/camera_control.h"
#include "mirrorball/view/workspace/asked_map.h"

namespace mirrorball {
namespace {

/// Where the camera is by the options alone.
CameraOptions cameraOf(const History& history) {
  const auto settings = frameOf(history.now(), editedSide(history.now()));
  return settings ? settings->camera : CameraOptions();
}

template <AxisView view>
void lookAlong(History& history) {
  history.change("Look along an axis", withCamera(history.now(), alongAxis(cameraOf(history), view)));
}

template <int by>
void stepMap(History& history) {
  history.change("Another panorama", withMapStepped(history.now(), by));
}

template <CompareBy by>
void compare(History& history) {
  Workspace next = history.now();
  next.compare_by = next.compare_by == by ? CompareBy::none : by;
  history.change("Compare", std::move(next));
}

/// By half a stop.
template <int by>
void expose(History& history) {
  history.change("Exposure", exposedBy(history.now(), 0.5f * static_cast<float>(by)));
}

constexpr auto kCommands = std::to_array<ViewerCommand>({
    {"undo", "Undo", "Edit", "Ctrl+Z", "", [](History& history) { (void)history.undo(); }},
    {"redo", "Do again", "Edit", "Ctrl+Shift+Z", "Ctrl+Y", [](History& history) { (void)history.redo(); }},
    {"reset-all", "Reset all options", "Edit", "Ctrl+Shift+R", "",
     [](History& history) { history.change("Reset all options", withoutOptions(history.now())); }},
    {"frame-all", "Show all", "Camera", "F", "Home",
     [](History& history) { history.change("Show all", withCamera(history.now(), framingAll(cameraOf(history)))); }},
    {"view-front", "From the front", "Camera", "1", "", lookAlong<AxisView::front>},
    {"view-back", "From behind", "Camera", "Ctrl+1", "", lookAlong<AxisView::back>},
    {"view-right", "From the right", "Camera", "3", "", lookAlong<AxisView::right>},
    {"view-left", "From the left", "Camera", "Ctrl+3", "", lookAlong<AxisView::left>},
    {"view-top", "From above", "Camera", "7", "", lookAlong<AxisView::top>},
    {"view-bottom", "From below", "Camera", "Ctrl+7", "", lookAlong<AxisView::bottom>},
    {"play", "Play the model's animation, and stop", "Camera", "Space", "",
     [](History& history) {
       Workspace next = history.now();
       next.plays = !next.plays;
       // The end belongs to the step that it ends.
       if (next.plays)
         history.change("Play", std::move(next));
       else
         history.goOn(std::move(next));
     }},
    {"next-map", "Next panorama", "Light", "]", "", stepMap<1>},
    {"previous-map", "Panorama before", "Light", "[", "", stepMap<-1>},
    {"brighter", "Brighter", "Light", "=", "Shift+=", expose<1>},
    {"darker", "Darker", "Light", "-", "", expose<-1>},
    {"show-map", "The map alone", "Light", "M", "",
     [](History& history) {
       Workspace next = history.now();
       next.shows_map = !next.shows_map;
       history.change("The map alone", std::move(next));
     }},
    {"photograph", "A photograph of a mirror ball", "Light", "B", "",
     [](History& history) {
       const bool is_photograph = askedMap(history.now(), editedSide(history.now())).photo.has_value();
       history.change("A photograph of a mirror ball", withPhotograph(history.now(), !is_photograph));
     }},
    {"inspect", "Inspect what is under the pointer", "Camera", "I", "",
     [](History& history) {
       Workspace next = history.now();
       next.inspects = !next.inspects;
       history.change("Inspect", std::move(next));
     }},
    {"compare-slider", "Compare side by side", "Compare", "C", "", compare<CompareBy::slider>},
    {"compare-flip", "Compare by flipping", "Compare", "Shift+C", "", compare<CompareBy::flip>},
    {"compare-difference", "Show the difference", "Compare", "Ctrl+D", "", compare<CompareBy::difference>},
    {"compare-flip-error", "Show the visible error (FLIP)", "Compare", "Ctrl+Shift+D", "",
     compare<CompareBy::flip_error>},
    {"edit-other", "Edit the other half", "Compare", "Tab", "",
     [](History& history) {
       const Workspace& now = history.now();
       if (now.compare_by == CompareBy::none) return;
       history.change("Edit the other half", withEditedSide(now, 1 - now.edited_side));
     }},
    {"truth", "The truth, and back", "Compare", "T", "",
     [](History& history) { history.change("Compare with the truth", withTruth(history.now())); }},
});

}  // namespace

std::span<const ViewerCommand> viewerCommands() { return kCommands; }

const ViewerCommand* commandOfKey(std::string_view chord) {
  for (const ViewerCommand& command : kCommands)
    if (!chord.empty() && (command.key == chord || command.other_key == chord)) return &command;
  return nullptr;
}

}  // namespace mirrorball
