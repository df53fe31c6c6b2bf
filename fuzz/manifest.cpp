// The manifest beside a table that bake wrote, as `info` reads it.

#include <fstream>
#include <vector>

#include "folder.h"
#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/output/baked/brdf_file.h"

MIRRORBALL_HARNESS(manifest) {
  using namespace mirrorball;
  static const fuzz::Folder folder("mirrorball_manifest");
  static const std::string table = (folder.path() / "brdf.dds").string();
  static const auto written = writeImageSet(table, ImageSet(Image(2, 2, 3, 0.5f)), {.format = TexelFormat::half});
  fuzz::check(written.has_value(), "the table is written");
  std::ofstream(folder.path() / "manifest.json").write(reinterpret_cast<const char*>(data), std::streamsize(size));
  const auto found = brdfTableIn(table);
  fuzz::checkError(found, table);
  if (!found || !*found) return 0;
  for (const std::string& text : {(*found)->facts.distribution, (*found)->facts.axes}) fuzz::checkLine(text);
  return 0;
}
