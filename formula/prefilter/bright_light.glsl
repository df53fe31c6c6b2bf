// What is so bright that it is summed as points of light, and which bound tells it from the rest. Brightness is that of
// the strongest channel.

FN float brightness(vec3 light) { return max(light.x, max(light.y, light.z)); }

// What a light has more than a threshold, of its own colour: light minus that is no brighter than the threshold.
FN vec3 lightAbove(vec3 light, float threshold) {
  float bright = brightness(light);
  return bright > threshold ? light * (1.0f - threshold / bright) : vec3(0.0f);
}

// Which of four thresholds a light exceeds: 1 or 0 for each.
FN vec4 thresholdsExceeded(vec3 light, vec4 thresholds) {
  float bright = brightness(light);
  return vec4(bright > thresholds.x ? 1.0f : 0.0f, bright > thresholds.y ? 1.0f : 0.0f,
              bright > thresholds.z ? 1.0f : 0.0f, bright > thresholds.w ? 1.0f : 0.0f);
}

// The first of four thresholds, which grow, that no more than `max_count` texels exceed; 4 if all have more.
FN int firstWithin(vec4 counts, float max_count) {
  if (counts.x <= max_count) return 0;
  if (counts.y <= max_count) return 1;
  if (counts.z <= max_count) return 2;
  return counts.w <= max_count ? 3 : 4;
}

// Four thresholds that grow by factors of 16 from eight times the mean on: what is less bright does not stand out.
FN vec4 coarseThresholds(float mean) { return vec4(8.0f, 128.0f, 2048.0f, 32768.0f) * mean; }

// Four thresholds that grow by factors of 2 up to the first of the coarse ones with no more than `max_count` texels,
// but none below the least of those.
FN vec4 fineThresholds(vec4 coarse, vec4 counts, float max_count) {
  float below = coarse.x * exp2(4.0f * float(firstWithin(counts, max_count) - 1));
  return max(vec4(2.0f, 4.0f, 8.0f, 16.0f) * below, vec4(coarse.x));
}
