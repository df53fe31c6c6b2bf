// Where the environment is, for the parts "proxy" that say it is near.
#include "proxy_sight.glsl"

layout(std140) uniform ProxyBlock {
  vec3 captured_at;    // world, as all of these
  float proxy_ground;  // height
  vec3 proxy_center;   // of a sphere
  float proxy_radius;
  vec3 proxy_low;      // corners of a box
  vec3 proxy_high;
  vec3 ground_irradiance;  // of a level ground, divided by π, in the unit of the environment's maps
  vec3 shadow_area;        // the middle of the picture of the ground's shadow, x and z, and half of its side
};
