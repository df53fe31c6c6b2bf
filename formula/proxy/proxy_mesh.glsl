// A proxy of any triangles, in a tree of theirs (scene/bodies/body_tree.h).
// Needs: octahedral, optics, proxy_sight, triangle_tree.

// Through a hole a ray goes on for ever.
FN ProxyHit hitOfMesh(WORD_SAMPLER tree, vec3 origin, vec3 d) {
  TriangleHit hit = nearestTriangle(tree, origin, d, 0.0f, -1, kNarrowMargin);
  if (hit.triangle < 0) return MAKE(ProxyHit)(origin, vec3(0.0f), 0.0f, false);
  vec3 normal = bodySurfaceAt(tree, hit).geometric_normal;
  return MAKE(ProxyHit)(origin + hit.distance * d, normal, hit.distance, false);
}
