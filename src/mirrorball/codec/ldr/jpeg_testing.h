#pragma once

#include <cstdio>
#include <cstdlib>
#include <vector>

// jpeglib.h needs <cstdio>.
#include <jpeglib.h>

#include "mirrorball/base/file.h"
#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// How libjpeg is to write a picture, in ways that this program does not.
struct JpegForm {
  const char* name = "Plain";
  int channels = 3;       ///< of the picture: 1, 3, or 4 for CMYK
  int subsampling = 1;    ///< texels of a colour's sample on either side
  unsigned interval = 0;  ///< groups of blocks between restart markers
  bool progressive = false;
  std::vector<jpeg_scan_info> scans = {};  ///< none: as libjpeg chooses them
  J_COLOR_SPACE stored = JCS_UNKNOWN;      ///< as libjpeg chooses it
  bool has_adobe_marker = true;            ///< where libjpeg writes one
};

/// picture  with the form's channels
inline Bytes jpegFile(const Image8& picture, const JpegForm& form) {
  jpeg_compress_struct codec;
  jpeg_error_mgr errors;
  codec.err = jpeg_std_error(&errors);
  jpeg_create_compress(&codec);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&codec, &memory, &size);
  codec.image_width = static_cast<JDIMENSION>(picture.width());
  codec.image_height = static_cast<JDIMENSION>(picture.height());
  codec.input_components = form.channels;
  codec.in_color_space = form.channels == 1 ? JCS_GRAYSCALE : form.channels == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&codec);
  if (form.stored != JCS_UNKNOWN) jpeg_set_colorspace(&codec, form.stored);
  if (!form.has_adobe_marker) codec.write_Adobe_marker = FALSE;
  codec.comp_info[0].h_samp_factor = codec.comp_info[0].v_samp_factor = form.subsampling;
  codec.restart_interval = form.interval;
  if (form.progressive) jpeg_simple_progression(&codec);
  if (!form.scans.empty()) {
    codec.scan_info = form.scans.data();
    codec.num_scans = static_cast<int>(form.scans.size());
  }
  jpeg_start_compress(&codec, TRUE);
  for (int y = 0; y < picture.height(); ++y) {
    JSAMPROW row = const_cast<JSAMPLE*>(picture.row(y).data());
    jpeg_write_scanlines(&codec, &row, 1);
  }
  jpeg_finish_compress(&codec);
  jpeg_destroy_compress(&codec);
  Bytes bytes(memory, memory + size);
  std::free(memory);
  return bytes;
}

}  // namespace mirrorball::testing
