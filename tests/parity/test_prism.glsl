// A prism of relief for parity's cases: its corners' normals spread, and half a map of SmoothMap(32) lies on it.
FN ReliefPrism testPrism(vec4 p) {
  return MAKE(ReliefPrism)(vec3(0.125f * p.x, 0.0f, 0.0f), vec3(1.0f, 0.0f, 0.125f * p.y),
                           vec3(0.25f * p.z, 1.0f, 0.0f), vec3(0.0f, 0.0f, 0.5f), vec3(0.125f, 0.0f, 0.0f),
                           vec3(0.0f, 0.0625f * p.w, 0.0f), vec2(2.3f, 3.1f), vec2(11.0f, 1.0f), vec2(0.5f, 9.0f),
                           vec3(1.0f, 0.0f, 1.0f), vec2(0.0625f * p.y, 1.0f - 0.0625f * p.z));
}
