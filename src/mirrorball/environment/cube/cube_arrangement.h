#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// The two directions of each axis of our world, in the order of a cube's faces.
enum class SignedAxis { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

constexpr SignedAxis operator-(SignedAxis axis) { return static_cast<SignedAxis>(static_cast<int>(axis) ^ 1); }

glm::vec3 vectorOf(SignedAxis axis);

/// "+x", "-x", "+y", "-y", "+z", "-z"
std::string_view nameOf(SignedAxis axis);

/// errors   usage: lists the names; capital letters are taken too
Result<SignedAxis> signedAxisNamed(std::string_view name);

/// What one image of a cube shows: the direction at its centre and those in which s (to the right) and t (downwards)
/// grow, three different axes of our world.
struct FaceFrame {
  SignedAxis centre;
  SignedAxis right;
  SignedAxis down;

  friend bool operator==(const FaceFrame&, const FaceFrame&) = default;
};

/// How six images cover all directions. Each slot, in the reader's order +X −X +Y −Y +Z −Z, holds the image of one
/// frame. The default is ours, OpenGL's table (docs/conventions.md).
struct CubeArrangement {
  std::array<FaceFrame, 6> slots{{
      {SignedAxis::plus_x, SignedAxis::minus_z, SignedAxis::minus_y},
      {SignedAxis::minus_x, SignedAxis::plus_z, SignedAxis::minus_y},
      {SignedAxis::plus_y, SignedAxis::plus_x, SignedAxis::plus_z},
      {SignedAxis::minus_y, SignedAxis::plus_x, SignedAxis::minus_z},
      {SignedAxis::plus_z, SignedAxis::plus_x, SignedAxis::minus_y},
      {SignedAxis::minus_z, SignedAxis::minus_x, SignedAxis::minus_y},
  }};

  friend bool operator==(const CubeArrangement&, const CubeArrangement&) = default;
};

/// Whether the six centres are the six directions, and each frame's axes are three different ones.
bool isComplete(const CubeArrangement& arrangement);

/// How each image is flipped: its columns, its rows or both in reverse order.
enum class Flip { none, horizontal, vertical, both };

/// "none", "horizontal", "vertical", "both": the enumeration's order.
std::span<const std::string_view> flipNames();
/// errors   usage: lists the names
Result<Flip> flipNamed(std::string_view name);

CubeArrangement flipped(CubeArrangement arrangement, Flip flip);

/// Mirrors each image in its slot. Our own arrangement, OpenGL's table, then becomes the pictures that an eye sees from
/// inside.
inline CubeArrangement asSeen(const CubeArrangement& arrangement) { return flipped(arrangement, Flip::horizontal); }

/// The images in these slots turned by 180°, each in its place.
CubeArrangement turned(CubeArrangement arrangement, std::span<const SignedAxis> slots);

/// Which of an arrangement's images lies in each slot: 0 … 5, each once.
using FaceOrder = std::array<int, 6>;

/// "+x,-x,+y,-y,+z,-z", with or without the commas.
///
/// errors   usage: not six, or not each once
Result<FaceOrder> faceOrderNamed(std::string_view written);

/// "+x,-x,+y,-y,+z,-z", as faceOrderNamed reads it.
std::string textOf(const FaceOrder& order);

CubeArrangement reordered(const CubeArrangement& arrangement, const FaceOrder& order);

/// Where another program's +X, +Y and +Z point in our world: three different axes, left-handed or not.
struct WorldAxes {
  SignedAxis x = SignedAxis::plus_x;
  SignedAxis y = SignedAxis::plus_y;
  SignedAxis z = SignedAxis::plus_z;
};

/// An arrangement whose frames are written in another program's axes, in ours.
CubeArrangement inWorld(CubeArrangement arrangement, const WorldAxes& world);

/// Changes an arrangement by one word: "as-seen"; "flip=" and a Flip; "turn=" and the slots whose images are turned by
/// 180°, "turn=-z"; "order=" and a FaceOrder; "axes=" and centre, right and down of all six slots, as textOf writes
/// them, in place of what it was.
///
/// errors   usage: lists the words
Result<CubeArrangement> rearranged(const CubeArrangement& arrangement, std::string_view word);

/// "" for ours, "as-seen", "turn=-z", else "axes=+x-z-y|-x+z-y|…":
/// `rearranged` makes the arrangement from ours by this word.
std::string textOf(const CubeArrangement& arrangement);

/// A square's texels under one of its 8 symmetries: what is shown at texel (i, j) is taken from texel `from(i, j)`.
struct SquareSymmetry {
  glm::ivec2 right{1, 0};  ///< the step in the source when i grows
  glm::ivec2 down{0, 1};   ///< and when j grows

  glm::ivec2 from(glm::ivec2 texel, int side) const {
    const glm::ivec2 way = right + down;
    const glm::ivec2 origin(way.x < 0 ? side - 1 : 0, way.y < 0 ? side - 1 : 0);
    return origin + texel.x * right + texel.y * down;
  }
};

/// A square turned clockwise by that many times 90°.
SquareSymmetry turnedClockwise(int quarters);

/// Which texel of a frame's image our face of its centre shows.
SquareSymmetry faceFromImage(const FaceFrame& frame);

/// The six faces of our cube as the images of another arrangement, slot by slot: texels are moved, not resampled. Every
/// level and layer; of our own arrangement the images as they are.
///
/// faces    6 square faces a layer, by OpenGL's table
/// cost     one copy
ImageSet arranged(ImageSet faces, const CubeArrangement& arrangement);

/// The inverse: our six faces from the images of another arrangement.
ImageSet restored(ImageSet images, const CubeArrangement& arrangement);

}  // namespace mirrorball
