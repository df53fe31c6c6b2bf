// The environment behind everything.
in vec2 screen;

uniform samplerCube environment;
uniform mat3 environment_from_world;
uniform float environment_intensity;
uniform mat4 world_from_clip;
uniform vec3 camera_forward;
uniform float orthographic;
uniform float level;

out vec4 fragment;

void main() {
  vec4 near_point = world_from_clip * vec4(screen, -1.0, 1.0);
  vec4 far_point = world_from_clip * vec4(screen, 1.0, 1.0);
  vec3 ray = orthographic > 0.5 ? camera_forward : far_point.xyz / far_point.w - near_point.xyz / near_point.w;
  fragment = vec4(sampleLod(environment, environment_from_world * ray, level).xyz * environment_intensity, 1.0);
}
