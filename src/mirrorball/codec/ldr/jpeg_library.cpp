#include "mirrorball/codec/ldr/jpeg_library.h"

#include "mirrorball/codec/ldr/jpeg_damage.h"

namespace mirrorball {
namespace {

void onJpegError(j_common_ptr codec) {
  auto* errors = reinterpret_cast<JpegErrors*>(codec->err);
  errors->code = codec->err->msg_code;
  codec->err->format_message(codec, errors->message);
  std::longjmp(errors->jump, 1);
}

/// Warnings have the level −1, news others. After a warning libjpeg goes on.
void onMessage(j_common_ptr codec, int level) {
  auto* errors = reinterpret_cast<JpegErrors*>(codec->err);
  if (level < 0 && errors->damage) errors->damage->note(*reinterpret_cast<j_decompress_ptr>(codec));
}

/// The library prints nothing.
void onOutput(j_common_ptr) {}

}  // namespace

jpeg_error_mgr* installJpegErrors(JpegErrors& errors) {
  jpeg_std_error(&errors.base);
  errors.base.error_exit = onJpegError;
  errors.base.emit_message = onMessage;
  errors.base.output_message = onOutput;
  errors.message[0] = '\0';
  errors.code = 0;
  return &errors.base;
}

}  // namespace mirrorball
