// The eye's ray through a fragment of shaders that cover the picture (screen.vert; render/surface/eye_ray.h).
in vec2 screen;

uniform mat4 directions_from_clip;
uniform vec3 camera_position;
uniform vec3 camera_forward;
uniform float orthographic;

vec4 nearPoint() { return directions_from_clip * vec4(screen, -1.0, 1.0); }

vec3 eyeDirection() {
  if (orthographic > 0.5) return normalize(camera_forward);
  vec4 near_point = nearPoint();
  vec4 far_point = directions_from_clip * vec4(screen, 1.0, 1.0);
  return normalize(far_point.xyz / far_point.w - near_point.xyz / near_point.w);
}

vec3 eyeOrigin() { return orthographic > 0.5 ? camera_position + nearPoint().xyz : camera_position; }
