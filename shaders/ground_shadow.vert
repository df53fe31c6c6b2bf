// A vertex of a model where its shadow falls on a level ground, in the picture of that ground.
uniform mat4 world_from_object;
uniform vec3 towards_light;  // unit, upwards
uniform float ground;        // height
uniform vec3 area;           // the middle of the picture, and half of its side: x, z, world units
uniform float depth;         // of the light: nearer than those before

layout(location = 0) in vec3 position;

void main() {
  vec3 world = (world_from_object * vec4(position, 1.0)).xyz;
  // What is below the ground throws no shadow on it; along the ground it would be endless.
  vec2 place = world.xz - towards_light.xz * (max(world.y - ground, 0.0) / towards_light.y);
  gl_Position = vec4((place - area.xy) / area.z, depth, 1.0);
}
