#pragma once

#include <concepts>
#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace mirrorball {

/// What kind of failure an Error is, for callers that treat kinds differently.
enum class ErrorCode {
  usage,         ///< an option or argument is wrong: the command line exits with 2
  not_found,     ///< a file or a built-in name does not exist
  io,            ///< reading or writing failed
  bad_file,      ///< the bytes are not what the format says
  bad_shape,     ///< right format, wrong dimensions for what was asked
  non_finite,    ///< NaN or infinity where light is expected
  out_of_range,  ///< a value that the format asked for cannot hold
  too_large,     ///< more texels than the program takes
  unsupported,   ///< a valid file that uses a feature which this program lacks
  no_gl,         ///< no OpenGL driver, or one too old
  interrupted,   ///< the user pressed Ctrl-C
};

/// What mends a failure, where the library has a setting or a function for it. Messages name none: a program has words
/// of its own for them, which it adds (the command line in apps/cli/terminal.cpp).
enum class FixHint {
  none,                    ///< the message says all
  repair,                  ///< EnvironmentLoadOptions::repair: bad texels become the mean of their neighbours
  raise_memory,            ///< setMemoryLimit
  raise_memory_or_shrink,  ///< that, or a smaller size of what is made
  scale_light,             ///< LightLimits::scale: a smaller unit of light
  store_floats,            ///< TexelFormat::float32 instead of the format that cannot hold the light
  name_projection,         ///< FileConversion::to
  name_form,               ///< EnvironmentLoadOptions::from: neither the file nor its shape tells the form
  name_form_of_cube,       ///< no `from`, or a cube's
  take_one_level,          ///< of a map's mip levels, the one that is wanted, by itself
  give_circle,             ///< ballOfCircle: where the ball is in the photograph
  give_exposures,          ///< MergeOptions::exposures
  name_response,           ///< MergeOptions::response, as sRGB
  convert_to_panorama,     ///< convert to Projection::equirect
  give_angles,             ///< CameraOptions' azimuth and elevation in place of a name
  resize,                  ///< resized: to the size of the other one
};

/// A failure as the user reads it: one line that says what is wrong and what to do. Whoever knows the name of the file
/// that it is about puts it in front (withName).
struct Error {
  ErrorCode code = ErrorCode::io;
  std::string message;
  FixHint fix_hint = FixHint::none;
};

/// A value or an Error, with std::expected's member names. The library neither exits nor throws.
///
/// Of tl::expected's constructors it has those that are used: a compiler tries all of them at each return, which was a
/// tenth of its work in files that fail often.
template <typename Value>
class [[nodiscard]] Result : public tl::expected<Value, Error> {
 public:
  Result() = default;
  /// What a Value can be made of.
  template <std::convertible_to<Value> Source = Value>
  Result(Source&& value) : tl::expected<Value, Error>(tl::in_place, std::forward<Source>(value)) {}
  Result(tl::unexpected<Error> failure) : tl::expected<Value, Error>(std::move(failure)) {}
};

/// Success or an Error.
template <>
class [[nodiscard]] Result<void> : public tl::expected<void, Error> {
 public:
  Result() = default;
  Result(tl::unexpected<Error> failure) : tl::expected<void, Error>(std::move(failure)) {}
};

/// `return fail(ErrorCode::bad_file, "is truncated at byte 9");`
inline tl::unexpected<Error> fail(ErrorCode code, std::string message, FixHint hint = FixHint::none) {
  return tl::unexpected<Error>(Error{code, std::move(message), hint});
}

/// Passes on the Error of a failed Result.
template <typename Value>
tl::unexpected<Error> fail(Result<Value>&& failed) {
  return tl::unexpected<Error>(std::move(failed).error());
}

/// Puts in front of a failure's message what it is about: "room.exr: is truncated at byte 9". A decoder says what is
/// wrong with its bytes, and where (byte, line, key); it knows no name. Who opened the file adds it, once. An
/// interruption is about no file, and stays as it is.
///
/// name     of the file; of a part within it ("images[3]"), before the file's; of what is made ("the BRDF table")
inline Error withName(const std::string& name, Error error) {
  if (error.code != ErrorCode::interrupted) error.message.insert(0, name + ": ");
  return error;
}

/// The same for a failed Result; a value passes unchanged.
template <typename Value>
Result<Value> withName(const std::string& name, Result<Value> result) {
  if (!result) result.error() = withName(name, std::move(result).error());
  return result;
}

}  // namespace mirrorball

/// `MIRRORBALL_TRY(image, readImage(path));` declares `image`, or returns the failure to the caller.
#define MIRRORBALL_TRY(name, expression)                                   \
  auto name##_result = (expression);                                       \
  if (!name##_result) return ::mirrorball::fail(std::move(name##_result)); \
  auto name = std::move(*name##_result)

/// The same for a Result<void>.
#define MIRRORBALL_TRY_VOID(expression)                                                        \
  do {                                                                                         \
    auto mirrorball_void_result = (expression);                                                \
    if (!mirrorball_void_result) return ::mirrorball::fail(std::move(mirrorball_void_result)); \
  } while (false)
