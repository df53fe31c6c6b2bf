// The reflection of a surface whose roughness is stretched along its tangent, put together from round lobes of its
// narrow width: the slopes of its facets along the tangent are gone through in steps of equal shares.
// Needs: constants, ggx.

const int kTapsOfStretchedLobe = 16;

// One of the steps: facets about a normal.
struct FacetTap {
  vec3 normal;   // in the frame of the surface, unit
  float alpha;   // of the round lobe that they reflect
  float weight;  // of the light from there; 0: it is below the horizon
};

// Slopes x and y of GGX's facets are distributed as (1 + x² / αx² + y² / αy²)⁻² / (π αx αy) (Heitz 2014, eq. 81). So
// those along x alone have the density (1 + x² / αx²)^(−3/2) / 2αx, a share u of them being below x = αx c / √(1 − c²)
// with c = 2 u − 1; and round lobes of the width αy spread those along y as they are spread in all. They are as wide
// along x, too: what is left to the steps is √(αx² − αy²). Light is weighed as for facets that are chosen by their
// area: G (v·h) / (v.z h.z).
//
// v               towards the eye, in the frame of the surface
// share           of the facets, in (0, 1)
// step_of_shares  between neighbouring shares: a tap is at least so wide that it meets its neighbours
FN FacetTap tapOfStretchedLobe(vec2 alpha, vec3 v, float share, float step_of_shares) {
  float c = 2.0f * share - 1.0f;
  float rest = sqrt(max(1.0f - c * c, 1e-6f));
  float along = sqrt(max(alpha.x * alpha.x - alpha.y * alpha.y, 0.0f));
  vec3 h = normalize(vec3(along * c / rest, 0.0f, 1.0f));
  vec3 l = reflect(-v, h);
  float towards = dot(v, h);
  bool is_seen = towards > 0.0f && l.z > 0.0f;
  float spacing = 2.0f * along * step_of_shares / (rest * rest * rest);
  // The facets' slopes as angles about h.
  float angle = max(alpha.y * h.z, 0.5f * spacing * h.z * h.z);
  float weight = is_seen ? ggxMaskingShadowing(alpha, v, l) * towards / h.z : 0.0f;
  return MAKE(FacetTap)(h, clamp(angle, 0.0f, 1.0f), weight);
}

// How much of white light such facets send away at the first bounce, over what round ones of the narrow width send.
FN float stretchedShare(vec2 alpha, vec3 v) {
  float sum = 0.0f;
  for (int i = 0; i < kTapsOfStretchedLobe; ++i) {
    float share = (float(i) + 0.5f) / float(kTapsOfStretchedLobe);
    sum += tapOfStretchedLobe(alpha, v, share, 1.0f / float(kTapsOfStretchedLobe)).weight;
  }
  float of_round = tapOfStretchedLobe(vec2(alpha.y), v, 0.5f, 1.0f).weight;
  return clamp(sum / (float(kTapsOfStretchedLobe) * max(of_round, 1e-6f)), 0.0f, 1.0f);
}

