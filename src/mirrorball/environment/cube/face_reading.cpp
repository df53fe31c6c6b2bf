#include "mirrorball/environment/cube/face_reading.h"

#include <algorithm>
#include <cassert>

#include "mirrorball/environment/cube/preset.h"

namespace mirrorball {
namespace {

constexpr int kQuarters = 4;

FaceFrame turnedQuarters(FaceFrame frame, int quarters) {
  for (int quarter = 0; quarter < quarters; ++quarter) frame = {frame.centre, frame.down, -frame.right};
  return frame;
}

/// An arrangement with the images of ±Y, in whichever slots they are, turned in each of the 16 ways.
void appendWithTurnedPoles(const CubeArrangement& arrangement, std::vector<CubeArrangement>& arrangements) {
  for (int top = 0; top < kQuarters; ++top)
    for (int bottom = 0; bottom < kQuarters; ++bottom) {
      CubeArrangement turned = arrangement;
      for (FaceFrame& frame : turned.slots) {
        if (frame.centre == SignedAxis::plus_y) frame = turnedQuarters(frame, top);
        if (frame.centre == SignedAxis::minus_y) frame = turnedQuarters(frame, bottom);
      }
      arrangements.push_back(turned);
    }
}

CubeArrangement mirroredWorld(const CubeArrangement& arrangement) {
  return inWorld(arrangement, {.x = SignedAxis::minus_x});
}

/// Images that count once around, then up and down, as an eye sees them.
CubeArrangement countedAround() {
  // Which of the slots right, left, up, down, front and back each has.
  constexpr FaceOrder kFrontRightBackLeftUpDown{4, 0, 5, 1, 2, 3};
  return reordered(mirroredWorld(CubeArrangement{}), kFrontRightBackLeftUpDown);
}

}  // namespace

std::vector<CubeArrangement> possibleArrangements(const CubeArrangement& expected, bool is_numbered) {
  const CubeArrangement ours;
  // Where names promise pictures as an eye sees them, so are those that go on with the right one at the right.
  const bool is_table = is_numbered || expected == ours;
  std::vector<CubeArrangement> arrangements{expected, is_table ? ours : mirroredWorld(ours), asSeen(ours)};
  if (is_numbered) arrangements.push_back(countedAround());
  const std::vector<CubeArrangement> sides = arrangements;
  for (const CubeArrangement& side : sides) appendWithTurnedPoles(side, arrangements);
  return arrangements;
}

FaceReading readByEdges(const EnvironmentMap& images, std::span<const CubeArrangement> arrangements) {
  assert(!arrangements.empty());
  std::vector<EdgeFit> fits;
  for (const CubeArrangement& arrangement : arrangements) fits.push_back(edgeFit(images, arrangement));
  std::size_t best = 0;
  for (std::size_t other = 1; other < fits.size(); ++other)
    if (fits[other].meets() && fits[other].isClearlyBetterThan(fits[best])) best = other;
  const EdgeFit& fit = fits[best];
  const bool goes_on = fit.across <= 1.5f * fit.beside + 0.01f;
  const bool is_proved = goes_on && std::any_of(fits.begin(), fits.end(),
                                                [&](const EdgeFit& other) { return fit.isClearlyBetterThan(other); });
  return {arrangements[best], fit, is_proved};
}

std::optional<CubeArrangement> mirrorReading(const CubeArrangement& arrangement) {
  const std::array<FaceFrame, 6>& slots = arrangement.slots;
  constexpr std::size_t kRight = 0;
  constexpr std::size_t kFront = 4;
  // The image of the right slot is at the right side of that of the front slot.
  if (slots[kFront].right != slots[kRight].centre || slots[kRight].down != SignedAxis::minus_y) return std::nullopt;
  return mirroredWorld(arrangement);
}

std::string hintForFaces(const CubeArrangement& arrangement) {
  constexpr std::array<std::string_view, 3> kPrograms{"krpano", "quake", "ogre"};
  for (const std::string_view program : kPrograms)
    if (arrangement == presetNamed(program)->cube) return "faces:for=" + std::string(program);
  std::string text = textOf(arrangement);
  std::erase(text, '|');  // which stands between hints
  return text.empty() ? "faces" : "faces:" + text;
}

}  // namespace mirrorball
