// How near a surface is to the camera's place (formula/proxy/captured_sight.glsl).
uniform vec3 camera_position;
uniform float unit;

in vec3 world_position;

out vec4 fragment;

void main() { fragment = vec4(unit / distance(world_position, camera_position), 0.0, 0.0, 1.0); }
