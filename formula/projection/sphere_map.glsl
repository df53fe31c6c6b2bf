// The sphere map: the orthographic picture of a mirror ball, seen from +Z. Texture coordinates (s, t) with t growing
// upwards, so that they are OpenGL's; the ball is inscribed into [0, 1]².

// Where a reflected direction is seen on the ball: GL_SPHERE_MAP of the OpenGL 1.x to 4.x compatibility specification,
// m = 2 √(rx² + ry² + (rz + 1)²), s = rx / m + ½, t = ry / m + ½. The ball's normal there is r + (0, 0, 1), normalised.
FN vec2 sphereMapCoordinates(vec3 r) {
  float m = 2.0f * sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0f) * (r.z + 1.0f));
  // The direction straight behind the ball is seen all along the rim; any point of it will do.
  if (m == 0.0f) return vec2(1.0f, 0.5f);
  return vec2(r.x / m + 0.5f, r.y / m + 0.5f);
}

// The lecture's simplified form: a point of any object shows what the ball shows where it has the same normal.
FN vec2 sphereMapCoordinatesOfNormal(vec3 n) { return vec2((1.0f + n.x) / 2.0f, (1.0f + n.y) / 2.0f); }

// The same as a texture matrix: normals are the texture coordinates, the matrix turns them as the object is turned
// and scales [−1, 1] to [0, 1].
FN mat4 sphereMapTextureMatrix(mat3 view_from_world) {
  mat4 rotation = mat4(vec4(view_from_world[0], 0.0f), vec4(view_from_world[1], 0.0f),
                       vec4(view_from_world[2], 0.0f), vec4(0.0f, 0.0f, 0.0f, 1.0f));
  mat4 to_unit = mat4(vec4(0.5f, 0.0f, 0.0f, 0.0f), vec4(0.0f, 0.5f, 0.0f, 0.0f), vec4(0.0f, 0.0f, 0.5f, 0.0f),
                      vec4(0.5f, 0.5f, 0.5f, 1.0f));
  return to_unit * rotation;
}

// The ball's normal at (s, t); outside the disc the nearest normal of the rim.
FN vec3 sphereMapNormal(vec2 st) {
  vec2 p = vec2(2.0f * st.x - 1.0f, 2.0f * st.y - 1.0f);
  float square = dot(p, p);
  if (square >= 1.0f) return vec3(p / sqrt(square), 0.0f);
  return vec3(p, sqrt(1.0f - square));
}

// The direction seen at (s, t): the ray (0, 0, −1) reflected by the normal, (2 nz nx, 2 nz ny, 2 nz² − 1).
// Equal areas of the disc see equal solid angles: dω = 4 cos θn dωn and dωn = dA / cos θn, so dω = 4 dA.
FN vec3 sphereMapDirection(vec2 st) {
  vec3 n = sphereMapNormal(st);
  return vec3(2.0f * n.z * n.x, 2.0f * n.z * n.y, 2.0f * n.z * n.z - 1.0f);
}
