#include "mirrorball/environment/cube/cube_arrangement.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr std::array<std::string_view, 6> kAxisNames{"+x", "-x", "+y", "-y", "+z", "-z"};
constexpr std::array<std::string_view, 4> kFlipNames{"none", "horizontal", "vertical", "both"};
constexpr std::array<std::string_view, 5> kWords{"as-seen", "flip=", "order=", "axes=", "turn="};
constexpr std::string_view kBetweenAxes = ", |";

/// x, y or z: 0, 1, 2.
int dimensionOf(SignedAxis axis) { return static_cast<int>(axis) / 2; }

bool areDifferent(SignedAxis a, SignedAxis b, SignedAxis c) {
  return dimensionOf(a) != dimensionOf(b) && dimensionOf(b) != dimensionOf(c) && dimensionOf(c) != dimensionOf(a);
}

/// The axes of "+x-z-y|-x,+z": two characters each, with or without something between them.
Result<std::vector<SignedAxis>> signedAxesIn(std::string_view written) {
  std::vector<SignedAxis> axes;
  while (!written.empty()) {
    if (kBetweenAxes.find(written.front()) != std::string_view::npos) {
      written.remove_prefix(1);
      continue;
    }
    MIRRORBALL_TRY(axis, signedAxisNamed(written.substr(0, 2)));
    axes.push_back(axis);
    written.remove_prefix(2);
  }
  return axes;
}

/// Six frames written centre, right, down.
Result<CubeArrangement> framesNamed(std::string_view written) {
  MIRRORBALL_TRY(axes, signedAxesIn(written));
  CubeArrangement arrangement;
  if (axes.size() == 3 * arrangement.slots.size()) {
    for (std::size_t slot = 0; slot < arrangement.slots.size(); ++slot)
      arrangement.slots[slot] = {axes[3 * slot], axes[3 * slot + 1], axes[3 * slot + 2]};
    if (isComplete(arrangement)) return arrangement;
  }
  return fail(ErrorCode::usage, "'axes=" + std::string(written) +
                                    "' is no cube: six times the axis at a face's centre, the one to its right and the "
                                    "one down, as in axes=+x-z-y|-x+z-y|+y+x+z|-y+x-z|+z+x-y|-z-x-y");
}

/// The symmetry that shows one of our faces as the image of a frame.
SquareSymmetry symmetryOf(const FaceFrame& frame) {
  const FaceFrame ours = CubeArrangement{}.slots[static_cast<std::size_t>(frame.centre)];
  const auto stepAlong = [&](SignedAxis axis) {
    if (axis == ours.right) return glm::ivec2(1, 0);
    if (axis == -ours.right) return glm::ivec2(-1, 0);
    return axis == ours.down ? glm::ivec2(0, 1) : glm::ivec2(0, -1);
  };
  return {stepAlong(frame.right), stepAlong(frame.down)};
}

SquareSymmetry inverse(const SquareSymmetry& symmetry) {
  return {{symmetry.right.x, symmetry.down.x}, {symmetry.right.y, symmetry.down.y}};
}

Image shown(const Image& source, const SquareSymmetry& symmetry) {
  constexpr std::size_t kRowsPerPiece = 32;
  const int side = source.width();
  Image image = Image::withoutValues(side, side, source.channels());
  parallelFor(static_cast<std::size_t>(side), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < side; ++x) {
        const glm::ivec2 from = symmetry.from({x, y}, side);
        std::copy_n(source.texel(from.x, from.y), source.channels(), image.texel(x, y));
      }
  });
  return image;
}

enum class Way { to_slots, to_faces };

ImageSet moved(ImageSet source, const CubeArrangement& arrangement, Way way) {
  assert(source.faces() == 6 && isComplete(arrangement));
  if (arrangement == CubeArrangement{}) return source;
  ImageSet target(source.levels(), 6, source.layers());
  for (int level = 0; level < source.levels(); ++level)
    for (int layer = 0; layer < source.layers(); ++layer)
      for (int slot = 0; slot < 6; ++slot) {
        const FaceFrame& frame = arrangement.slots[static_cast<std::size_t>(slot)];
        const int face = static_cast<int>(frame.centre);
        if (way == Way::to_slots)
          target.at(level, slot, layer) = shown(source.at(level, face, layer), symmetryOf(frame));
        else
          target.at(level, face, layer) = shown(source.at(level, slot, layer), faceFromImage(frame));
      }
  return target;
}

}  // namespace

glm::vec3 vectorOf(SignedAxis axis) {
  glm::vec3 vector(0.0f);
  vector[dimensionOf(axis)] = static_cast<int>(axis) % 2 == 0 ? 1.0f : -1.0f;
  return vector;
}

std::string_view nameOf(SignedAxis axis) { return kAxisNames[static_cast<std::size_t>(axis)]; }

Result<SignedAxis> signedAxisNamed(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto found = std::find(kAxisNames.begin(), kAxisNames.end(), lower);
  if (found == kAxisNames.end()) return tl::unexpected<Error>(unknownName("axis", name, kAxisNames));
  return static_cast<SignedAxis>(found - kAxisNames.begin());
}

bool isComplete(const CubeArrangement& arrangement) {
  std::array<bool, 6> seen{};
  for (const FaceFrame& frame : arrangement.slots) {
    if (!areDifferent(frame.centre, frame.right, frame.down)) return false;
    seen[static_cast<std::size_t>(frame.centre)] = true;
  }
  return std::all_of(seen.begin(), seen.end(), [](bool is_seen) { return is_seen; });
}

std::span<const std::string_view> flipNames() { return kFlipNames; }

Result<Flip> flipNamed(std::string_view name) {
  const auto found = indexOfName(name, kFlipNames);
  if (!found) return tl::unexpected<Error>(unknownName("flip", name, kFlipNames));
  return static_cast<Flip>(*found);
}

CubeArrangement flipped(CubeArrangement arrangement, Flip flip) {
  for (FaceFrame& frame : arrangement.slots) {
    if (flip == Flip::horizontal || flip == Flip::both) frame.right = -frame.right;
    if (flip == Flip::vertical || flip == Flip::both) frame.down = -frame.down;
  }
  return arrangement;
}

CubeArrangement turned(CubeArrangement arrangement, std::span<const SignedAxis> slots) {
  for (const SignedAxis slot : slots) {
    FaceFrame& frame = arrangement.slots[static_cast<std::size_t>(slot)];
    frame.right = -frame.right;
    frame.down = -frame.down;
  }
  return arrangement;
}

Result<FaceOrder> faceOrderNamed(std::string_view written) {
  MIRRORBALL_TRY(axes, signedAxesIn(written));
  FaceOrder order{};
  std::array<bool, 6> seen{};
  for (std::size_t slot = 0; slot < order.size() && slot < axes.size(); ++slot) {
    order[slot] = static_cast<int>(axes[slot]);
    seen[static_cast<std::size_t>(axes[slot])] = true;
  }
  if (axes.size() != order.size() || std::find(seen.begin(), seen.end(), false) != seen.end())
    return fail(ErrorCode::usage,
                "the face order '" + excerpt(written) + "' is not each of the six once, as in +x,-x,+y,-y,+z,-z");
  return order;
}

std::string textOf(const FaceOrder& order) {
  std::string text;
  for (const int slot : order) text += (text.empty() ? "" : ",") + std::string(nameOf(static_cast<SignedAxis>(slot)));
  return text;
}

CubeArrangement reordered(const CubeArrangement& arrangement, const FaceOrder& order) {
  CubeArrangement result;
  for (std::size_t slot = 0; slot < order.size(); ++slot)
    result.slots[slot] = arrangement.slots[static_cast<std::size_t>(order[slot])];
  return result;
}

CubeArrangement inWorld(CubeArrangement arrangement, const WorldAxes& world) {
  assert(areDifferent(world.x, world.y, world.z));
  const std::array<SignedAxis, 6> ours{world.x, -world.x, world.y, -world.y, world.z, -world.z};
  const auto translated = [&](SignedAxis axis) { return ours[static_cast<std::size_t>(axis)]; };
  for (FaceFrame& frame : arrangement.slots)
    frame = {translated(frame.centre), translated(frame.right), translated(frame.down)};
  return arrangement;
}

Result<CubeArrangement> rearranged(const CubeArrangement& arrangement, std::string_view word) {
  const auto valueOf = [&](std::string_view key) { return word.substr(key.size()); };
  if (word == kWords[0]) return asSeen(arrangement);
  if (word.starts_with(kWords[1])) {
    MIRRORBALL_TRY(flip, flipNamed(valueOf(kWords[1])));
    return flipped(arrangement, flip);
  }
  if (word.starts_with(kWords[2])) {
    MIRRORBALL_TRY(order, faceOrderNamed(valueOf(kWords[2])));
    return reordered(arrangement, order);
  }
  if (word.starts_with(kWords[3])) return framesNamed(valueOf(kWords[3]));
  if (word.starts_with(kWords[4])) {
    MIRRORBALL_TRY(slots, signedAxesIn(valueOf(kWords[4])));
    if (!slots.empty()) return turned(arrangement, slots);
    return fail(ErrorCode::usage, "'turn=' needs the faces that are turned by 180 degrees, as in turn=-z");
  }
  return tl::unexpected<Error>(unknownName("arrangement of a cube", word, kWords));
}

std::string textOf(const CubeArrangement& arrangement) {
  const CubeArrangement ours;
  if (arrangement == ours) return "";
  if (arrangement == asSeen(ours)) return "as-seen";
  std::string text;
  std::vector<SignedAxis> heads_down;
  for (std::size_t slot = 0; slot < ours.slots.size(); ++slot)
    if (arrangement.slots[slot] != ours.slots[slot]) heads_down.push_back(static_cast<SignedAxis>(slot));
  if (arrangement == turned(ours, heads_down)) {
    for (const SignedAxis slot : heads_down) text += nameOf(slot);
    return "turn=" + text;
  }
  for (const FaceFrame& frame : arrangement.slots) {
    text += text.empty() ? "axes=" : "|";
    for (const SignedAxis axis : {frame.centre, frame.right, frame.down}) text += nameOf(axis);
  }
  return text;
}

SquareSymmetry turnedClockwise(int quarters) {
  // One quarter: the source's left column, read upwards, is the row on top.
  SquareSymmetry symmetry;
  for (int quarter = 0; quarter < quarters; ++quarter) symmetry = {-symmetry.down, symmetry.right};
  return symmetry;
}

SquareSymmetry faceFromImage(const FaceFrame& frame) { return inverse(symmetryOf(frame)); }

ImageSet arranged(ImageSet faces, const CubeArrangement& arrangement) {
  return moved(std::move(faces), arrangement, Way::to_slots);
}

ImageSet restored(ImageSet images, const CubeArrangement& arrangement) {
  return moved(std::move(images), arrangement, Way::to_faces);
}

}  // namespace mirrorball
