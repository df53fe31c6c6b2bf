// Where a mesh stands.
layout(std140) uniform InstanceBlock {
  mat4 world_from_object;
  mat3 normal_matrix;
  int instance;     // its number in the scene
  int knows_backs;  // 1: what its vertices know of the scene is that of the side that is drawn
};
