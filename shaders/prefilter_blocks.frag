// Sums over blocks of 8 × 8 cells.
uniform sampler2D cells;

out vec4 fragment;

void main() {
  ivec2 begin = ivec2(gl_FragCoord.xy) * 8;
  ivec2 end = min(begin + 8, textureSize(cells, 0));
  vec4 sum = vec4(0.0);
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x) sum += texelFetch(cells, ivec2(x, y), 0);
  fragment = sum;
}
