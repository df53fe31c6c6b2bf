// Stands for a cube map on both sides: its light is the direction itself and the level, which is smooth, so that
// only the formula's own arithmetic is compared and not how a driver filters.
struct SmoothCube {
  float brightness;
};

FN vec4 sampleLod(SmoothCube cube, vec3 d, float lod) { return vec4(cube.brightness * d, lod); }
