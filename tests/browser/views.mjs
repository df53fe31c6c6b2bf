// In the browser: loads a map with three.js' own loaders, draws what a camera at the origin sees and what a mirror ball
// shows, and compares that with pictures that our program has made.

import * as THREE from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { HDRCubeTextureLoader } from 'three/addons/loaders/HDRCubeTextureLoader.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';

const side_px = 256;
const samples = 2;  // across and down a pixel
const gap_px = 4;
const magnification = 8;

// three.js multiplies by no tone map and encodes to sRGB unless told otherwise.
const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setSize(side_px * samples, side_px * samples);

const cubeLoaders = { png: THREE.CubeTextureLoader, hdr: HDRCubeTextureLoader };
const panoramaLoaders = { png: THREE.TextureLoader, hdr: HDRLoader, exr: EXRLoader };

const ktx2Loader = new KTX2Loader().setTranscoderPath('/node_modules/three/examples/jsm/libs/basis/')
  .detectSupport(renderer);

function contextOf(width, height) {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  return canvas.getContext('2d', { willReadFrequently: true });
}

/// An image turned, mirrored or moved about its middle, by the matrix of CanvasRenderingContext2D.transform:
/// [-1, 0, 0, 1, 0, 0] swaps left and right, the last two move right and down.
function transformed(image, matrix) {
  const context = contextOf(image.width, image.height);
  context.translate(image.width / 2, image.height / 2);
  context.transform(...matrix);
  context.drawImage(image, -image.width / 2, -image.height / 2);
  return context.canvas;
}

/// A map as a user of three.js would load it; a cube has six files or is a .ktx2, a panorama has one. `damage` is done
/// to one image.
async function load({ files, damage }) {
  if (files[0].endsWith('.ktx2')) return ktx2Loader.loadAsync(files[0]);
  const isCube = files.length === 6;
  const extension = files[0].split('.').pop();
  const loader = new (isCube ? cubeLoaders : panoramaLoaders)[extension]();
  const texture = await new Promise((resolve, reject) =>
    loader.load(isCube ? files : files[0], resolve, undefined, reject));
  if (!isCube) texture.mapping = THREE.EquirectangularReflectionMapping;
  if (!isCube && extension === 'png') texture.colorSpace = THREE.SRGBColorSpace;
  if (damage && isCube) texture.images[damage.image] = transformed(texture.images[damage.image], damage.matrix);
  if (damage && !isCube) texture.image = transformed(texture.image, damage.matrix);
  return texture;
}

function drawBackground(texture, { direction, up }) {
  const scene = new THREE.Scene();
  scene.background = texture;
  const camera = new THREE.PerspectiveCamera(90, 1, 0.1, 10);
  camera.up.set(...up);
  camera.lookAt(...direction);
  renderer.render(scene, camera);
}

/// The orthographic picture of a mirror ball, inscribed into the picture, seen from +Z: a sphere map.
function drawBall(texture, { material }) {
  const mirror = new THREE[material]({ envMap: texture });
  if (mirror.isMeshStandardMaterial) Object.assign(mirror, { metalness: 1, roughness: 0 });
  const scene = new THREE.Scene();
  scene.add(new THREE.Mesh(new THREE.SphereGeometry(1, 256, 128), mirror));
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  camera.position.z = 3;
  renderer.render(scene, camera);
}

function shownNow() {
  const context = contextOf(side_px, side_px);
  context.imageSmoothingQuality = 'high';
  context.drawImage(renderer.domElement, 0, 0, side_px, side_px);
  return context;
}

async function pictureOf(file) {
  const image = new Image();
  image.src = file;
  await image.decode();
  const context = contextOf(side_px, side_px);
  context.drawImage(image, 0, 0);
  return context;
}

/// Towards a ball's rim a pixel spans ever more of the map, until what it shows is a matter of filtering.
const isWellInsideBall = (x, y) => Math.hypot(2 * x - 1, 2 * y - 1) ** 2 < 0.9;

const codesOf = (context) => context.getImageData(0, 0, side_px, side_px).data;

/// Peak signal-to-noise ratio [dB] over the red, green and blue of the pixels that count.
function psnr(a, b, counts) {
  const [codesA, codesB] = [codesOf(a), codesOf(b)];
  let sum = 0;
  let count = 0;
  for (let i = 0; i < codesA.length; ++i) {
    const [x, y] = [(i >> 2) % side_px, Math.floor((i >> 2) / side_px)];
    if (i % 4 === 3 || !counts((x + 0.5) / side_px, (y + 0.5) / side_px)) continue;
    sum += (codesA[i] - codesB[i]) ** 2;
    count += 1;
  }
  return -10 * Math.log10(sum / count / 255 ** 2);
}

function magnifiedDifference(a, b) {
  const context = contextOf(side_px, side_px);
  const codesB = codesOf(b);
  const codes = codesOf(a).map((code, i) => (i % 4 === 3 ? 255 : magnification * Math.abs(code - codesB[i])));
  context.putImageData(new ImageData(codes, side_px, side_px), 0, 0);
  return context;
}

/// A row for each view: ours | three.js' | difference × 8.
function contactSheet(rows) {
  const step = side_px + gap_px;
  const sheet = contextOf(3 * step - gap_px, rows.length * step - gap_px);
  rows.forEach((row, y) => row.forEach((picture, x) => sheet.drawImage(picture.canvas, x * step, y * step)));
  return sheet.canvas.toDataURL('image/png');
}

/// Shows a map in its views. Returns the PSNR of each against its picture, and a contact sheet of all, as a data URL.
window.compareViews = async (map) => {
  const texture = await load(map);
  const rows = [];
  const psnrs_db = [];
  for (const view of map.views) {
    if (view.material) drawBall(texture, view);
    else drawBackground(texture, view);
    const [ours, theirs] = [await pictureOf(view.picture), shownNow()];
    psnrs_db.push(psnr(ours, theirs, view.material ? isWellInsideBall : () => true));
    rows.push([ours, theirs, magnifiedDifference(ours, theirs)]);
  }
  texture.dispose();
  return { psnrs_db, sheet: contactSheet(rows) };
};
