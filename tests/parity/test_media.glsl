// Bodies 0, 1 and 2 of the priorities x, y and z, entered one after the other as far as w > ¼, ½, ¾; numbers in [0, 1].
FN Media testMedia(vec4 p) {
  Media media;
  media.count = 0;
  if (p.w > 0.25f) media = entered(media, 0, int(3.0f * p.x));
  if (p.w > 0.5f) media = entered(media, 1, int(3.0f * p.y));
  if (p.w > 0.75f) media = entered(media, 2, int(3.0f * p.z));
  return media;
}

FN vec4 shownMedia(Media media) {
  return vec4(float(media.count), media.count > 0 ? float(10 * media.bodies[0] + media.priorities[0]) : 0.0f,
              media.count > 1 ? float(10 * media.bodies[1] + media.priorities[1]) : 0.0f,
              media.count > 2 ? float(10 * media.bodies[2] + media.priorities[2]) : 0.0f);
}
