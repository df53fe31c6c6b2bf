// usage: node check_containers.mjs FOLDER
//
// Reads the texture files that FOLDER/files.json lists with readers that others have written, and compares headers and
// every texel. Exit code 1, and one line a fault, where something differs.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { isDeepStrictEqual } from 'node:util';

import * as ktx from 'ktx-parse';
import parseDds from 'parse-dds';
import { DataUtils, FloatType, HalfFloatType, LinearSRGBColorSpace, RGB_BPTC_UNSIGNED_Format, RGBA_ASTC_4x4_Format,
  RGBAFormat, RGBFormat, RGFormat, UnsignedInt101111Type, UnsignedInt5999Type } from 'three';
import { DDSLoader } from 'three/addons/loaders/DDSLoader.js';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';
import { ZSTDDecoder } from 'three/addons/libs/zstddec.module.js';

import { loadTranscoder, transcoded } from './transcoder.mjs';

const formats = {
  half: { vk: ktx.VK_FORMAT_R16G16B16A16_SFLOAT, type: HalfFloatType, format: RGBAFormat, word: 2, size: 8,
    bits: [16, 16, 16, 16],
    decode: (view, at) => [0, 2, 4, 6].map((i) => DataUtils.fromHalfFloat(view.getUint16(at + i, true))) },
  float32: { vk: ktx.VK_FORMAT_R32G32B32A32_SFLOAT, type: FloatType, format: RGBAFormat, word: 4, size: 16,
    bits: [32, 32, 32, 32],
    decode: (view, at) => [0, 4, 8, 12].map((i) => view.getFloat32(at + i, true)) },
  b10g11r11: { vk: ktx.VK_FORMAT_B10G11R11_UFLOAT_PACK32, type: UnsignedInt101111Type, format: RGBFormat, word: 4,
    size: 4, bits: [11, 11, 10], decode: (view, at) => decodePacked(view.getUint32(at, true)) },
  e5b9g9r9: { vk: ktx.VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, type: UnsignedInt5999Type, format: RGBFormat, word: 4, size: 4,
    bits: [9, 5, 9, 5, 9, 5], decode: (view, at) => decodeShared(view.getUint32(at, true)) },
  rg_half: { vk: ktx.VK_FORMAT_R16G16_SFLOAT, type: HalfFloatType, format: RGFormat, word: 2, size: 4, bits: [16, 16],
    decode: (view, at) => [...[0, 2].map((i) => DataUtils.fromHalfFloat(view.getUint16(at + i, true))), 0, 1] },
  rg_float32: { vk: ktx.VK_FORMAT_R32G32_SFLOAT, type: FloatType, format: RGFormat, word: 4, size: 8, bits: [32, 32],
    decode: (view, at) => [...[0, 4].map((i) => view.getFloat32(at + i, true)), 0, 1] },
  // Its blocks are compared byte by byte.
  bc6h: { vk: ktx.VK_FORMAT_BC6H_UFLOAT_BLOCK, word: 1, size: 16, bits: [128], side: 4, model: 133, decode: blockAt },
  uastc_hdr: { vk: ktx.VK_FORMAT_ASTC_4x4_SFLOAT_BLOCK_EXT, type: HalfFloatType, format: RGBA_ASTC_4x4_Format, word: 1,
    size: 16, bits: [128], side: 4, model: 167, decode: blockAt },
};

function blockAt(view, at) {
  return [...new Uint8Array(view.buffer, view.byteOffset + at, 16)];
}

/// VK_FORMAT_B10G11R11_UFLOAT_PACK32: exponents of 5 bits with bias 15, above mantissas of 6, 6 and 5 bits. The test's
/// values are normal.
function decodePacked(bits) {
  const value = (code, mantissaBits) =>
    code === 0 ? 0 : (1 + (code % 2 ** mantissaBits) / 2 ** mantissaBits) * 2 ** ((code >> mantissaBits) - 15);
  return [value(bits & 0x7ff, 6), value((bits >>> 11) & 0x7ff, 6), value(bits >>> 22, 5), 1];
}

function decodeShared(bits) {
  const unit = 2 ** ((bits >>> 27) - 24);
  return [(bits & 0x1ff) * unit, ((bits >>> 9) & 0x1ff) * unit, ((bits >>> 18) & 0x1ff) * unit, 1];
}

let faults = 0;
function expectEqual(found, expected, what) {
  if (isDeepStrictEqual(found, expected)) return;
  faults += 1;
  console.error(`${what}: found ${JSON.stringify(found)}, expected ${JSON.stringify(expected)}`);
}

/// Compares texels, or blocks where they are compressed, one behind the other with the part of the list that begins at
/// texel `first`; returns its end.
function checkTexels(bytes, count, file, first, what) {
  const { decode, size, side } = formats[file.format];
  const numbers = side ? size : 4;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  expectEqual(bytes.byteLength, count * size, `${what}, bytes`);
  for (let i = 0; i < count && (i + 1) * size <= bytes.byteLength; ++i)
    expectEqual(decode(view, i * size), file.texels.slice(numbers * (first + i), numbers * (first + i + 1)),
      `${what}, texel ${i}`);
  return first + count;
}

/// How many texels a level's image has, or blocks.
function levelTexels(file, level) {
  const { side = 1 } = formats[file.format];
  const along = (texels) => Math.ceil(Math.max(1, texels >> level) / side);
  return along(file.width) * along(file.height);
}

async function checkKtx2(file, bytes) {
  const { vk, word, size, bits, type, format, side = 1, model = ktx.KHR_DF_MODEL_RGBSDA } = formats[file.format];
  const texture = ktx.read(bytes);
  const { name } = file;
  expectEqual(texture.vkFormat, vk, `${name}, vkFormat`);
  expectEqual(texture.typeSize, word, `${name}, typeSize`);
  const { pixelWidth, pixelHeight, pixelDepth } = texture;
  expectEqual([pixelWidth, pixelHeight, pixelDepth], [file.width, file.height, 0], `${name}, size`);
  expectEqual(texture.layerCount, file.layers > 1 ? file.layers : 0, `${name}, layerCount`);
  expectEqual(texture.faceCount, file.faces, `${name}, faceCount`);
  expectEqual(texture.levels.length, file.levels, `${name}, levels`);
  const scheme = file.zstandard ? ktx.KHR_SUPERCOMPRESSION_ZSTD : ktx.KHR_SUPERCOMPRESSION_NONE;
  expectEqual(texture.supercompressionScheme, scheme, `${name}, supercompressionScheme`);

  const [descriptor] = texture.dataFormatDescriptor;
  expectEqual(descriptor.colorModel, model, `${name}, colour model`);
  expectEqual([...descriptor.texelBlockDimension], [side - 1, side - 1, 0, 0], `${name}, size of a block`);
  expectEqual(descriptor.colorPrimaries, ktx.KHR_DF_PRIMARIES_BT709, `${name}, primaries`);
  expectEqual(descriptor.transferFunction, ktx.KHR_DF_TRANSFER_LINEAR, `${name}, transfer function`);
  expectEqual([...descriptor.bytesPlane], [size, 0, 0, 0, 0, 0, 0, 0], `${name}, bytesPlane`);
  expectEqual(descriptor.samples.map((sample) => sample.bitLength + 1), bits, `${name}, bits of the samples`);

  // ktx-parse leaves the values of keys that it does not know as bytes.
  const { envmap, ...known } = texture.keyValue;
  expectEqual(known, { KTXorientation: 'rd', KTXwriter: 'mirrorball' }, `${name}, key/value data`);
  expectEqual(new TextDecoder().decode(envmap), 'cube\0', `${name}, envmap`);

  const zstd = new ZSTDDecoder();
  await zstd.init();
  let first = 0;
  texture.levels.forEach((level, i) => {
    const data = file.zstandard ? zstd.decode(level.levelData, level.uncompressedByteLength) : level.levelData;
    const count = levelTexels(file, i) * file.layers * file.faces;
    expectEqual(level.uncompressedByteLength, count * size, `${name}, uncompressedByteLength of level ${i}`);
    first = checkTexels(data, count, file, first, `${name}, level ${i}`);
  });

  if (file.halves) checkTranscoded(file, bytes);

  // three.js makes no cubes and arrays of uncompressed files, no arrays of cubes, and takes BC6H from DDS only.
  const isCube = file.faces > 1;
  if (file.layers > 1 || !format || (isCube && !file.halves)) return;
  const loader = new KTX2Loader();
  loader.workerConfig = { astcHDRSupported: true };  // what it asks a renderer for: compressed formats only
  const copy = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const loaded = await new Promise((resolve, reject) => loader.parse(copy, resolve, reject));
  expectEqual([loaded.type, loaded.format], [type, format], `${name}, three.js' type and format`);
  expectEqual(loaded.colorSpace, LinearSRGBColorSpace, `${name}, three.js' colour space`);
  expectEqual(loaded.isCubeTexture ?? false, isCube, `${name}, three.js' cube`);
  const images = isCube ? loaded.image.map((face) => face.mipmaps) : [loaded.mipmaps];
  expectEqual(images.map((mipmaps) => mipmaps.length), images.map(() => file.levels), `${name}, three.js' mipmaps`);
  first = 0;
  for (let level = 0; level < file.levels; ++level)
    images.forEach((mipmaps, face) => {
      const { data } = mipmaps[level];
      const texels = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
      const what = `${name}, three.js' level ${level}, face ${face}`;
      first = checkTexels(texels, levelTexels(file, level), file, first, what);
    });
}

/// Basis Universal's transcoder takes every image, to BC6H and to the half floats that our decoder makes of it.
function checkTranscoded(file, bytes) {
  let first = 0;
  for (let level = 0; level < file.levels; ++level)
    for (let layer = 0; layer < file.layers; ++layer)
      for (let face = 0; face < file.faces; ++face) {
        const what = `${file.name}, level ${level}, layer ${layer}, face ${face}`;
        const { halves, bc6h } = transcoded(transcoder, bytes, level, layer, face);
        const colors = halves.filter((_, i) => i % 4 < 3);
        const other = colors.findIndex((half, i) => half !== file.halves[first + i]);
        expectEqual(other, -1, `${what}, the first half float that is another`);
        expectEqual(bc6h.length, levelTexels(file, level) * 16, `${what}, bytes of BC6H`);
        first += colors.length;
      }
  expectEqual(first, file.halves.length, `${file.name}, texels`);
}

/// three.js' reader, for what parse-dds does not take.
function checkCompressedDds(file, bytes) {
  const copy = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const texture = new DDSLoader().parse(copy, true);
  expectEqual(texture.format, RGB_BPTC_UNSIGNED_Format, `${file.name}, format`);
  expectEqual(texture.isCubemap, file.faces === 6, `${file.name}, cube`);
  expectEqual([texture.width, texture.height], [file.width, file.height], `${file.name}, size`);
  expectEqual(texture.mipmaps.length, file.faces * file.levels, `${file.name}, images`);
  // As below: the list goes by level and face, the file by face and level.
  let first = 0;
  for (let level = 0; level < file.levels; ++level)
    for (let face = 0; face < file.faces; ++face) {
      const { data } = texture.mipmaps[face * file.levels + level];
      first = checkTexels(data, levelTexels(file, level), file, first, `${file.name}, face ${face}, level ${level}`);
    }
}

function checkDds(file, bytes) {
  const copy = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const texture = parseDds(copy);
  expectEqual(texture.format, 'rgba32f', `${file.name}, format`);
  expectEqual(texture.cubemap, true, `${file.name}, cube`);
  expectEqual(texture.shape, [file.width, file.height], `${file.name}, size`);
  expectEqual(texture.images.length, file.faces * file.levels, `${file.name}, images`);
  // The list goes by level and face, the file by face and level.
  let first = 0;
  for (let level = 0; level < file.levels; ++level)
    for (let face = 0; face < file.faces; ++face) {
      const image = texture.images[face * file.levels + level];
      first = checkTexels(new Uint8Array(copy, image.offset, image.length), levelTexels(file, level), file, first,
        `${file.name}, face ${face}, level ${level}`);
    }
}

/// Filament's own reader, as its programs for the web have it.
async function loadFilament() {
  const require = createRequire(import.meta.url);
  globalThis.window ??= globalThis;  // it asks for a browser
  const wasm = readFileSync(require.resolve('filament/filament.wasm'));
  return require('filament')({ wasmBinary: wasm });
}

function checkKtx1(filament, file, bytes) {
  const { name } = file;
  const buffer = new filament.driver$BufferDescriptor(bytes.byteLength);
  buffer.getBytes().set(bytes);
  const texture = new filament.Ktx1Bundle(buffer);
  const { pixelWidth, pixelHeight } = texture.info();
  expectEqual([pixelWidth, pixelHeight], [file.width, file.height], `${name}, size`);
  expectEqual([texture.isCubemap(), texture.getNumMipLevels()], [file.faces === 6, file.levels], `${name}, shape`);
  const { RGBA, RGB } = filament.PixelDataFormat;
  const { HALF, FLOAT, UINT_10F_11F_11F_REV } = filament.PixelDataType;
  const { RGBA16F, RGBA32F, R11F_G11F_B10F } = filament.Texture$InternalFormat;
  const kinds = { half: [RGBA16F, RGBA, HALF], float32: [RGBA32F, RGBA, FLOAT],
    b10g11r11: [R11F_G11F_B10F, RGB, UINT_10F_11F_11F_REV] };
  if (kinds[file.format])
    expectEqual([texture.getInternalFormat(false), texture.getPixelDataFormat(), texture.getPixelDataType()],
      kinds[file.format], `${name}, internal format, format and type`);
  else
    expectEqual(texture.isCompressed(), true, `${name}, compressed`);
  const harmonics = texture.getMetadata('sh').split(/\s/, 9 * 3).map(parseFloat);  // as Filament's own program does
  expectEqual(harmonics, [0, ...Array.from({ length: 26 }, (_, i) => i + 1.5)], `${name}, harmonics`);
  let first = 0;
  for (let level = 0; level < file.levels; ++level) {
    const texels = new Uint8Array(texture._getCubeBlob(level).getBytes());
    first = checkTexels(texels, levelTexels(file, level) * 6, file, first, `${name}, level ${level}`);
  }
}

const folder = process.argv[2];
const filament = await loadFilament();
const transcoder = await loadTranscoder();
const files = JSON.parse(readFileSync(join(folder, 'files.json'), 'utf8'));
for (const file of files) {
  const bytes = readFileSync(join(folder, file.name));
  if (file.name.endsWith('.ktx')) checkKtx1(filament, file, bytes);
  else if (file.name.endsWith('.dds')) (formats[file.format].side ? checkCompressedDds : checkDds)(file, bytes);
  else await checkKtx2(file, bytes);
}
console.log(`${files.length} files, ${faults} faults`);
process.exit(faults > 0 || files.length === 0 ? 1 : 0);
