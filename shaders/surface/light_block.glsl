// The light that a surface reads: the environment's, or what a probe has captured of the scene around an object.
layout(std140) uniform LightBlock {
  mat3 environment_from_world;
  vec3 captured_from;      // of a probe, where it stands
  float nearness_unit;     // world units; of what it captured of distances (captured_sight.glsl)
  float environment_intensity;
  float first_level;
  float last_level;
  float texels_per_radian;
};
