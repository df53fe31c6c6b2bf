// What relief hides of the environment, by horizons: Max 1988, "Horizon mapping: shadows for bump-mapped surfaces";
// Sloan & Cohen 2000, "Interactive horizon mapping", for reading them between azimuths.
// Needs: constants, occlusion.

// How steep the horizon is in eight azimuths, each 45° on from growing u towards growing v: heights over texture widths
// (height_field/horizon_map.h).
struct Horizons {
  vec4 first;
  vec4 opposite;
};

FN float horizonSlope(Horizons h, int azimuth) {
  int number = azimuth & 3;
  vec4 half_circle = (azimuth & 4) == 0 ? h.first : h.opposite;
  return number == 0 ? half_circle.x : (number == 1 ? half_circle.y : (number == 2 ? half_circle.z : half_circle.w));
}

// The relief around a place, in the world.
struct ReliefGround {
  vec3 along_u;  // what a texture width passes along u
  vec3 along_v;  // and along v
  vec3 up;       // unit, of the mesh
  float depth;   // of a height of 1
};

// Along the mesh, what a texture width passes in an azimuth.
FN vec3 alongAzimuth(ReliefGround ground, int azimuth) {
  float angle = 0.25f * kPi * float(azimuth);
  vec3 along = cos(angle) * ground.along_u + sin(angle) * ground.along_v;
  return along - ground.up * dot(along, ground.up);
}

// What a surface sees of the sky in one of the eight slices around it: the mean direction of the light, weighted by its
// cosine, and the share that it has of the irradiance of an even sky.
struct SkySlice {
  vec3 direction;  // unit
  float share;
};

// Above a slope.
FN SkySlice sliceAbove(ReliefGround ground, vec3 normal, vec3 away, float width, float slope) {
  vec3 slice = visibleSlice(dot(normal, away), max(dot(normal, ground.up), 1e-3f), slope);
  vec3 mean = slice.x * away + slice.y * ground.up;
  return MAKE(SkySlice)(dot(mean, mean) > 1e-12f ? normalize(mean) : ground.up, max(width * slice.z / kPi, 0.0f));
}

// With the relief, and as it would be without.
struct SkySlices {
  SkySlice visible;
  SkySlice open;
};

//   normal   unit, of the bumpy surface
FN SkySlices slicesOfSky(ReliefGround ground, Horizons h, vec3 normal, int azimuth) {
  vec3 along = alongAzimuth(ground, azimuth);
  vec3 away = normalize(along);
  vec3 before = normalize(alongAzimuth(ground, azimuth - 1));
  vec3 next = normalize(alongAzimuth(ground, azimuth + 1));
  float width = 0.5f * acos(clamp(dot(before, next), -1.0f, 1.0f));
  float slope = horizonSlope(h, azimuth) * ground.depth / length(along);
  return MAKE(SkySlices)(sliceAbove(ground, normal, away, width, slope),
                         sliceAbove(ground, normal, away, width, -1e6f));
}

// The slope of the horizon in a direction, between azimuths.
//   along   the direction's part along the mesh, in texture widths for a length of 1 in the world
FN float slopeTowards(Horizons h, vec2 along, float depth) {
  float azimuth = atan(along.y, along.x) * (4.0f / kPi);
  float first = floor(azimuth);
  int number = int(first) & 7;
  float slope = mix(horizonSlope(h, number), horizonSlope(h, (number + 1) & 7), azimuth - first);
  return slope * depth * length(along);
}

// How much of what a surface reflects around a direction is above the horizon. What is below its own plane it does not
// reflect anyway.
//   normal      unit, of the bumpy surface
//   direction   unit
//   alpha       of the facets: half of the lobe lies within twice the angle whose tangent that is (GGX)
FN float lobeOverHorizons(ReliefGround ground, Horizons h, vec3 normal, vec3 direction, float alpha) {
  float height = dot(direction, ground.up);
  vec3 along = direction - height * ground.up;
  float run = length(along);
  vec3 for_u = cross(ground.along_v, ground.up);
  vec3 for_v = cross(ground.up, ground.along_u);
  float area = dot(ground.along_u, for_u);
  if (run < 1e-6f || area == 0.0f) return 1.0f;
  vec2 widths = vec2(dot(along, for_u), dot(along, for_v)) / (area * run);
  float plane = atan(-dot(normal, along) / (run * max(dot(normal, ground.up), 1e-3f)));
  float horizon = max(atan(slopeTowards(h, widths, ground.depth)), plane);
  float elevation = atan(height, run);
  float width = 0.02f + 2.0f * atan(alpha);
  float whole = smoothstep(-width, width, elevation - plane);
  return smoothstep(-width, width, elevation - horizon) / max(whole, 1e-3f);
}
