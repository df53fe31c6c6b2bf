#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// What the key/value data of a KTX file tells us. Other keys are left unread.
struct KtxKeyValues {
  Metadata metadata;
  bool right_to_left = false;  ///< KTXorientation: S increases to the left
  bool bottom_up = false;      ///< T increases upwards
  std::string swizzle = {};    ///< KTXswizzle, where it is not "rgba"
};

/// Walks over the key/value data of KTX 1 and 2.
///
/// bytes    the whole file
/// begin    where the data begins, and `size` its bytes: both within the file
/// big_endian  how the entries' sizes are stored (KTX 1 only)
/// errors   bad_file (the byte is named)
/// from     KTX 2.0 specification, "Key/Value Data" and "KTXorientation"
Result<KtxKeyValues> readKtxKeyValues(std::span<const std::uint8_t> bytes, std::size_t begin, std::size_t size,
                                      bool big_endian);

enum class KtxVersion { ktx1, ktx2 };

/// The data for a file of ours: KTXorientation, right and down, KTXwriter, which only KTX 2 knows, and the metadata;
/// sorted by key as KTX 2 demands.
Bytes ktxKeyValues(const Metadata& metadata, KtxVersion version);

/// What is remarked of a file that wants its channels exchanged, as no environment does.
std::string swizzleRemark(const KtxKeyValues& values);

/// Turns an image as the orientation demands, so that row 0 is on top.
void turnUpright(Image& image, const KtxKeyValues& values);

}  // namespace mirrorball
