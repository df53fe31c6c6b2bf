// The ground of a relief, whose texture is stretched and turned.
FN ReliefGround testGround(vec4 p) {
  return MAKE(ReliefGround)(vec3(1.0f, 0.25f * p.x, 0.0f), vec3(0.25f * p.y, -0.5f - p.z, 0.125f),
                            vec3(0.0f, 0.0f, 1.0f), 0.25f + p.w);
}
