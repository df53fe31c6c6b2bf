// The photograph of a mirror ball from a finite distance: direction ↔ position in the image. Needs: constants.
// The camera stands on +Z, looks at the ball's centre and has +Y up; the picture is cropped to the ball's visible rim,
// so that the rim touches its four sides. Positions (u, v) are in [0, 1]², v down; directions are unit vectors.
//
// k = 1 / d, the ball's radius over the camera's distance from its centre, is the sine of the angle under which the
// camera sees the rim. k = 0, a camera at infinity, is the sphere map (sphere_map.glsl); k < 1.
//
//   Let β be the angle at which the view ray meets the ball, measured from the normal, and ψ the ray's angle from −Z.
//   The triangle of centre, camera and point gives sin ψ = k sin β; the normal there stands at β − ψ from +Z and the
//   ray is reflected to
//     θ = 2 (β − ψ) + ψ = 2β − ψ                                                                    (1)
//   from +Z. The rim has β = π/2, hence θ = π − asin k: the cone of half-angle asin k around −Z is hidden by the ball.
//   With ρ = tan ψ / tan(asin k), the distance from the picture's centre in units of the rim's,
//     ρ = sin β √(1 − k²) / √(1 − k² sin² β)                                                        (2)
//   and backwards, with q = 1 − k² (1 − ρ²): sin β = ρ / √q, cos β = cos ψ √(1 − ρ²), cos ψ = √((1 − k²) / q).
//
// θ as a function of β is Alhazen's problem for a source at infinity, a quartic in tan(β/2) whose closed form loses its
// digits in float. θ(β) grows with a slope of 2 − k cos β / cos ψ, which lies in [1, 2], and is convex: Newton's steps
// from β = θ/2, the answer for k = 0, converge from everywhere. Three suffice up to k = 0.9, five up to k = 0.999.

// Where a direction is seen. In the hidden cone: the nearest point of the rim.
FN vec2 mirrorBallPosition(vec3 d, float k) {
  float sine = sqrt(d.x * d.x + d.y * d.y);
  if (sine == 0.0f) return d.z >= 0.0f ? vec2(0.5f, 0.5f) : vec2(1.0f, 0.5f);
  vec2 side = vec2(d.x, -d.y) / (2.0f * sine);
  if (d.z < 0.0f && sine <= k) return side + 0.5f;
  // (sin β, cos β) from the half angle, by whichever of the two is the larger.
  float larger = sqrt((1.0f + abs(d.z)) / 2.0f);
  float smaller = sine / (2.0f * larger);
  vec2 beta = d.z >= 0.0f ? vec2(smaller, larger) : vec2(larger, smaller);
  for (int i = 0; i < 5; ++i) {
    float sin_psi = k * beta.x;
    float cos_psi = sqrt(max(1.0f - sin_psi * sin_psi, 0.0f));
    float sin_two = 2.0f * beta.x * beta.y;
    float cos_two = beta.y * beta.y - beta.x * beta.x;
    // sin of the difference between (1) and θ: of the same sign and nearly as large.
    float beyond = (sin_two * cos_psi - cos_two * sin_psi) * d.z - (cos_two * cos_psi + sin_two * sin_psi) * sine;
    float turn = beyond / (2.0f - k * beta.y / cos_psi);
    beta = normalize(vec2(beta.x - turn * beta.y, beta.y + turn * beta.x));
  }
  if (beta.y <= 0.0f) return side + 0.5f;
  float sin_psi = k * beta.x;
  return side * (beta.x * sqrt((1.0f - k) * (1.0f + k) / (1.0f - sin_psi * sin_psi))) + 0.5f;
}

// The direction seen at a position; outside the disc that of the nearest point of the rim. With (2),
//   sin θ = (ρ / √q) (2 cos β cos ψ − k (1 − 2 sin² β)),  cos θ = cos ψ − 2 sin² β (cos ψ − k cos β).
FN vec3 mirrorBallDirection(vec2 uv, float k) {
  vec2 p = vec2(2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y);
  float square = dot(p, p);
  if (square > 1.0f) p = p / sqrt(square);
  float inside = max(1.0f - square, 0.0f);
  float q = 1.0f - k * k * inside;
  float cos_psi = sqrt((1.0f - k) * (1.0f + k) / q);
  float cos_beta = cos_psi * sqrt(inside);
  float sin_beta2 = (1.0f - inside) / q;
  float sideways = (2.0f * cos_beta * cos_psi - k * (1.0f - 2.0f * sin_beta2)) / sqrt(q);
  return vec3(p * sideways, cos_psi - 2.0f * sin_beta2 * (cos_psi - k * cos_beta));
}

// Whether the camera sees a direction: it does not lie in the hidden cone. Written with the sine, which keeps its
// digits where the cone is narrow.
FN bool mirrorBallCovers(vec3 d, float k) { return d.z >= 0.0f || d.x * d.x + d.y * d.y >= k * k; }

// The solid angle of the hidden cone, 2π (1 − cos(asin k)).
FN float mirrorBallBlindSolidAngle(float k) {
  return kTwoPi * k * k / (1.0f + sqrt((1.0f - k) * (1.0f + k)));
}
