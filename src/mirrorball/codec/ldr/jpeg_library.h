#pragma once

#include <csetjmp>
#include <cstdio>

// jpeglib.h needs size_t and FILE from <cstdio>.
#include <jpeglib.h>

namespace mirrorball {

class JpegDamage;

/// libjpeg's error manager with where to jump, the error's text and its number; and where warnings go.
struct JpegErrors {
  jpeg_error_mgr base;  // first: libjpeg hands out a pointer to it
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX];
  int code;
  JpegDamage* damage = nullptr;  ///< of a file that is read
};

/// Makes libjpeg report its errors there, and print nothing.
jpeg_error_mgr* installJpegErrors(JpegErrors& errors);

/// Runs calls of libjpeg, which reports an error by a jump back to here. `body` must own nothing
/// that has a destructor, for the jump passes over its frame.
///
/// returns  false after an error; it stands in `errors`
template <typename Body>
bool guardedFromJpeg(JpegErrors& errors, const Body& body) {
  if (setjmp(errors.jump)) return false;
  body();
  return true;
}

}  // namespace mirrorball
