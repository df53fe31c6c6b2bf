#pragma once

#include <cstdint>
#include <vector>

#include <ImfIO.h>
#include <ImfMultiPartInputFile.h>

namespace mirrorball {

/// Whether a part is stored in tiles. Its attribute `tiles` does not tell: programs that convert tiles to scan lines
/// leave it in the header, where it means nothing.
///
/// from   "OpenEXR File Layout", Version Field, and type
bool isTiledPart(const Imf::MultiPartInputFile& file, int part);

/// How many scan lines a chunk of a part has, or how many rows a tile.
int rowsInExrChunk(const Imf::MultiPartInputFile& file, int part);

/// Finds the rows that a file lacks because its writer, or who copied it, did not get to the end: walks over its
/// chunks, which lie one behind the other, up to the first that is not whole. Rows of which one tile is missing are.
///
/// stream       the file's, whose position OpenEXR must not count on afterwards
/// first_chunk  where the first of them begins
/// file_size    in bytes
/// returns      for each row of the part's data window, whether it is missing
/// cost         reads the few bytes that each chunk begins with
/// from         "OpenEXR File Layout", Offset Tables and Pixel Data
std::vector<std::uint8_t> missingExrRows(Imf::IStream& stream, const Imf::MultiPartInputFile& file, int part,
                                         std::uint64_t first_chunk, std::uint64_t file_size);

}  // namespace mirrorball
