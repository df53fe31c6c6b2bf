// How the balls are seen, by the engines as by the path tracer: radius 1, in the middle, from +Z.

export const side_px = 64;
export const distance = 6;
export const fieldOfView_deg = 20;

/// Engines draw more pixels, which are averaged as the path tracer averages over a pixel.
export const oversampling = 4;
export const drawnSide_px = oversampling * side_px;

/// The means over a pixel, of RGBA.
export function shrunk(drawn, width_px, height_px) {
  const picture = new Array(3 * width_px * height_px).fill(0);
  const drawnWidth_px = oversampling * width_px;
  for (let y = 0; y < oversampling * height_px; ++y)
    for (let x = 0; x < drawnWidth_px; ++x) {
      const pixel = Math.floor(y / oversampling) * width_px + Math.floor(x / oversampling);
      for (let c = 0; c < 3; ++c)
        picture[3 * pixel + c] += drawn[4 * (y * drawnWidth_px + x) + c] / oversampling ** 2;
    }
  return picture;
}

/// Whether a pixel shows the ball only.
export function isOnBall(pixel) {
  const half = side_px / 2;
  const radius = (0.97 * half * Math.tan(Math.asin(1 / distance))) / Math.tan((fieldOfView_deg * Math.PI) / 360);
  return Math.hypot((pixel % side_px) + 0.5 - half, Math.floor(pixel / side_px) + 0.5 - half) < radius;
}
