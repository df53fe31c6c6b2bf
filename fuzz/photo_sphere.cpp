// What a file says of a panorama in XMP: the part that its picture shows, how its camera stood, its compass heading.
// The first three bytes are a picture's size and what the caller says of its form; the rest is the file. What is
// accepted becomes a whole panorama, 2:1, of finite light.

#include "mirrorball/environment/file/photo_sphere.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/environment/file/picture_meaning.h"
#include "mirrorball/photo/heading_in_file.h"

namespace {

using namespace mirrorball;

constexpr std::array<std::string_view, 5> kHints{"", "equirect", "equirect:crop=none", "equirect:fill=smooth",
                                                 "equirect:fov=90x45,level=no"};

void checkHeading(const Result<std::optional<CompassHeading>>& read) {
  fuzz::checkError(read);
  if (!read || !*read) return;
  const auto [heading, pitch, roll, is_magnetic, source] = **read;
  fuzz::check(heading >= 0.0 && heading < 360.0 && std::abs(pitch) <= 90.0 && std::abs(roll) <= 180.0,
              "a heading's angles are in their ranges");
}

void checkPanorama(const PictureMeaning& meaning, const FormHint& hint, glm::ivec2 size) {
  for (const std::string& oddity : meaning.oddities) fuzz::checkLine(oddity);
  if (meaning.tilt)
    fuzz::check(std::abs(meaning.tilt->pitch_deg) <= 90.0 && std::abs(meaning.tilt->roll_deg) <= 180.0,
                "a tilt's angles are in their ranges");
  DecodedImage decoded{.image = Image(size.x, size.y, 3, 0.5f)};
  const auto completed = completePanorama(meaning, hint, decoded);
  fuzz::checkError(completed);
  if (!completed || meaning.recognition.form.projection != Projection::equirect) return;
  fuzz::check(decoded.image.width() == 2 * decoded.image.height(), "a whole panorama is 2:1");
  for (const float sample : decoded.image.samples())
    fuzz::check(sample >= 0.0f && sample < 0.5001f, "its light is the picture's, or none");
}

}  // namespace

MIRRORBALL_HARNESS(photo_sphere) {
  if (size < 3) return 0;
  // Panoramas whose size a file states stay small.
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(std::uint64_t{64} << 20);
  const glm::ivec2 picture(2 * (1 + data[0]), 1 + data[1]);
  const FormHint hint = *formHintNamed(kHints[data[2] % kHints.size()]);
  const std::span<const std::uint8_t> file(data + 3, size - 3);
  checkHeading(headingIn(file));
  const auto meaning = readMeaning(picture, {}, photoSphereIn(file), hint);
  fuzz::checkError(meaning);
  if (meaning) checkPanorama(*meaning, hint, picture);
  setMemoryLimit(before);
  return 0;
}
