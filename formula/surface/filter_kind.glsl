// How pictures are read that lie smaller or larger than their texels: what OpenGL calls a texture's filter.

const int kFilterNearest = 0;      // the texel that lies there
const int kFilterBilinear = 1;     // the four around it
const int kFilterTrilinear = 2;    // the same in two mip levels, whose texels are about as large as a pixel
const int kFilterAnisotropic = 3;  // several such reads along a pixel's longer side

// The most reads of one pixel, as drivers have it.
const int kMostReads = 16;

FN bool readsMipLevels(int kind) { return kind >= kFilterTrilinear; }

// How many reads as wide as the shorter side of a pixel cover the longer one (EXT_texture_filter_anisotropic, where it
// tells what a driver may do). Texels need no more reads than there are.
//
// longer, shorter   in texels
FN int readsAlong(float longer, float shorter) {
  return int(clamp(ceil(longer / max(shorter, 1.0f)), 1.0f, float(kMostReads)));
}

// Where the i-th of `count` reads lies on the way from one side to the other, 0 being the middle.
FN float placeOfRead(int i, int count) { return (float(i) + 0.5f) / float(count) - 0.5f; }
