// Part "sky": the light of the environment on a surface, and what hides it.
//   vec3 litByEnvironment(Surface s, SurfacePoint point, vec3 transmitted, vec3 on_cloth)
// Here: nothing does.

vec3 litByEnvironment(Surface s, SurfacePoint point, vec3 transmitted, vec3 on_cloth) {
  return shadedByEnvironment(s, reflectedLight(s, point), transmitted, arrivingIrradiance(point.position, s.normal),
                             on_cloth);
}
