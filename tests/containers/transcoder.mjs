// Basis Universal's transcoder, as three.js brings it, in Node.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname } from 'node:path';

const toBc6h = 22;  // transcoder_texture_format::cTFBC6H and cTFRGBA_HALF
const toHalves = 25;

export async function loadTranscoder() {
  const require = createRequire(import.meta.url);
  const script = require.resolve('three/addons/libs/basis/basis_transcoder.js');
  // The script is no module of ours: it asks for what Node gives to its own kind of modules.
  const load = new Function('module', 'exports', 'require', '__dirname', '__filename',
    `${readFileSync(script, 'utf8')}; return BASIS;`)({}, {}, require, dirname(script), script);
  const transcoder = await load({ wasmBinary: readFileSync(script.replace(/js$/, 'wasm')) });
  transcoder.initializeBasis();
  return transcoder;
}

/// One image of a KTX 2 file: red, green, blue and alpha of its texels as the bits of half floats, and blocks of BC6H.
/// What the transcoder refuses is thrown.
export function transcoded(transcoder, bytes, level, layer, face) {
  const file = new transcoder.KTX2File(new Uint8Array(bytes));
  try {
    const isTaken = file.isValid() && file.isHDR() && file.startTranscoding();
    if (!isTaken) throw new Error('the transcoder refuses the file');
    const [bc6h, halves] = [toBc6h, toHalves].map((format) => {
      const texels = new Uint8Array(file.getImageTranscodedSizeInBytes(level, layer, face, format));
      if (!file.transcodeImage(texels, level, layer, face, format, 0, -1, -1))
        throw new Error(`the transcoder refuses level ${level}, layer ${layer}, face ${face}`);
      return texels;
    });
    return { bc6h, halves: new Uint16Array(halves.buffer) };
  } finally {
    file.close();
    file.delete();
  }
}
