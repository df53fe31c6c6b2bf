// Bodies 0, 1 and 2 of the priorities x, y and z, entered one after the other as far as w > ¼, ½, ¾; numbers in [0, 1].
FN Media testMedia(vec4 p) {
  Media media = noMedia();
  if (p.w > 0.25f) media = entered(media, 0, int(3.0f * p.x));
  if (p.w > 0.5f) media = entered(media, 1, int(3.0f * p.y));
  if (p.w > 0.75f) media = entered(media, 2, int(3.0f * p.z));
  return media;
}

// The bodies and priorities of the words, which are small here.
FN vec4 shownMedia(Media media) {
  uvec4 words = media.latest;
  return 10.0f * vec4(words & uvec4(kBodyBits)) + vec4(words >> kPriorityShift) - float(kGreatestPriority);
}
