#pragma once

#include <optional>
#include <string>

#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/cube_layout.h"
#include "mirrorball/environment/projection.h"

namespace mirrorball {

/// The form of a map.
struct MapForm {
  Projection projection = Projection::equirect;
  CubeLayout layout = CubeLayout::hcross;  ///< of a cube only
};

/// A map's form as text: "equirect", "cube, hcross".
std::string textOf(const MapForm& form);

/// What --from names: a projection ("cube": the layout by the picture's shape) or a cube layout ("hcross", "faces").
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

/// Tells a picture's form: by the hint, else by the file's own metadata, else by its shape (2:1 equirect, 1:1 sphere
/// map, 4:3 horizontal cross, 3:4 vertical cross, 6:1 and 1:6 strips, 3:2 tiles).
///
/// name     the file, for messages
/// errors   bad_shape: the shape fits no form, or not the one that was named
Result<Recognition> recognize(const std::string& name, int width, int height, const Metadata& metadata,
                              const FormHint& hint = {});

}  // namespace mirrorball
