// Fits the table of lobe rows that the program holds (docs/lobe_rows.md): run
// build/bench/bench/fit_lobe_rows src/mirrorball/bake/lobe_row/lobe_rows.ktx2
#include <cstdio>
#include <cstdlib>

#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/codec/texture/texture_file.h"

int main(int count, char** arguments) {
  using namespace mirrorball;
  if (count != 2) {
    std::fprintf(stderr, "fit_lobe_rows FILE.ktx2\n");
    return EXIT_FAILURE;
  }
  const auto progress = [](std::size_t done, std::size_t total) {
    std::fprintf(stderr, "\rfitted %zu of %zu", done, total);
    return true;
  };
  const auto table = fittedLobeRowTable(progress);
  const Result<void> written =
      table ? writeImageSet(arguments[1], ImageSet(*table)) : Result<void>(tl::unexpected(table.error()));
  std::fprintf(stderr, "\n");
  if (written) return EXIT_SUCCESS;
  std::fprintf(stderr, "%s\n", written.error().message.c_str());
  return EXIT_FAILURE;
}
