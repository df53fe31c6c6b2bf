// The equi-angular cube, EAC (Google, "Bringing pixels front and center in VR video", 2017): the cube's faces by
// OpenGL's table, with equal angles instead of equal lengths along s and t. Needs: constants, cube.
// (YouTube's files lay such faces out in a 3 × 2 arrangement of its own, with some of them turned; that is not this.)

// [−1, 1] on the face's plane → the same range in steps of equal angle.
FN float equiangular(float tangent) { return atan(tangent) * (4.0f / kPi); }

FN vec2 equiangularCubeCoordinates(int face, vec3 d) {
  vec3 p = cubeProjected(face, d);
  return vec2((equiangular(p.x / p.z) + 1.0f) / 2.0f, (equiangular(p.y / p.z) + 1.0f) / 2.0f);
}

// The point of the face's plane at (s, t), which may lie a little outside [0, 1].
FN vec3 equiangularCubePoint(int face, vec2 st) {
  vec2 angle = (2.0f * st - 1.0f) * (kPi / 4.0f);
  return cubePoint(face, vec2((tan(angle.x) + 1.0f) / 2.0f, (tan(angle.y) + 1.0f) / 2.0f));
}

FN vec3 equiangularCubeDirection(int face, vec2 st) { return normalize(equiangularCubePoint(face, st)); }
