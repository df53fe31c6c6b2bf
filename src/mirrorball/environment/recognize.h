#pragma once

#include <optional>
#include <string>

#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/picture.h"

namespace mirrorball {

/// What --from names: a projection ("cube", "eac": the layout by the picture's shape; "ball:distance=12") or a cube
/// layout ("hcross", "faces").
///
/// errors   usage: lists all names
struct FormHint {
  std::optional<Projection> projection;
  std::optional<CubeLayout> layout;
};
Result<FormHint> formHintNamed(std::string_view name);

/// A form, and what told it.
struct Recognition {
  MapForm form;
  std::string told_by;  ///< "--from", "the file's metadata", "its shape, 2:1"
};

/// What a file says of its form, for `recognize` to read back: "mirrorball:projection", a cube's "mirrorball:layout" and
/// a ball's "mirrorball:ball_distance".
Metadata metadataOf(const MapForm& form);

/// Of six files with a face each: eac where the hint or a face's metadata says so, else cube.
Projection projectionOfFaces(const Metadata& metadata, const FormHint& hint);

/// Tells a picture's form: by the hint, else by the file's own metadata, else by its shape (2:1 equirect, 1:1 sphere
/// map, 4:3 horizontal cross, 3:4 vertical cross, 6:1 and 1:6 strips, 3:2 tiles). All other forms have to be named.
///
/// name     the file, for messages
/// errors   bad_shape: the shape fits no form, or not the one that was named
Result<Recognition> recognize(const std::string& name, int width, int height, const Metadata& metadata,
                              const FormHint& hint = {});

}  // namespace mirrorball
