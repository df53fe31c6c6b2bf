#pragma once

#include <optional>

#include "mirrorball/environment/file/picture_half.h"
#include "mirrorball/environment/file/recognize.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What the light of a picture shows about its form, where only its shape says it. Each looks at no more than some ten
/// thousand texels, whatever the size, but settleByContent(), which goes through a square of one colour as a whole.

/// Whether a square holds one disc that reaches to its sides, black outside: the picture of a ball, or a light probe.
bool showsDisc(const Image& picture);

/// Whether a 2:1 picture holds two such discs side by side, as 360° cameras with two fisheye lenses write them before
/// they are stitched. A panorama that is black above and below is none.
bool showsTwoDiscs(const Image& picture);

/// Whether the edges of a square are the same from their middle to either side, as those of an octahedron that is
/// unfolded are, and show four directions: at most two are alike. What is symmetrical about both of its axes, as a
/// vignette or an ornament, has other pairs of edges that are alike. An octahedron in light that is the same in several
/// horizon directions is not recognised.
bool foldsAtEdges(const Image& picture);

/// The eye that is taken of two that are nearly equal and of 2:1 each: the upper half of a square, the left one of 4:1.
///
/// returns  nothing where the halves differ, or light does not vary enough to tell
std::optional<PictureHalf> equalHalves(const Image& picture);

/// Whether the cells of a picture that a cube's cross leaves empty hold more than one colour each, in every cross of
/// that shape.
bool fillsEmptyCells(const Image& picture, CubeLayout cross);

/// Settles what a shape alone leaves open: changes the form, or adds the remark that names the others.
///
/// errors   bad_shape: it is certain that the picture is not a map of its shape's form, nor of another that is read
Result<FormDoubt> settleByContent(const Image& picture, Recognition& recognition);

}  // namespace mirrorball
