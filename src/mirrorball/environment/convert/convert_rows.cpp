#include "mirrorball/environment/convert/convert_rows.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/conversion.h"
#include "mirrorball/environment/convert/parallel_conversion.h"
#include "mirrorball/environment/convert/rows_needed.h"

namespace mirrorball {
namespace {

/// A window of this size moves seldom enough that all cores are busy in between.
constexpr std::size_t kUsualWindow_bytes = std::size_t{256} << 20;

/// So many rows are decoded at a time.
constexpr int kRowsPerRead = 64;

/// Strips and the rows that they need, ordered by the first of these.
struct Plan {
  std::vector<Strip> strips;
  std::vector<RowRange> rows;
  int max_rows = 0;
};

Plan planOf(const Conversion& conversion, int height) {
  const std::vector<Strip> strips = conversion.strips();
  std::vector<RowRange> rows(strips.size());
  parallelFor(strips.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) rows[i] = rowsNeeded(conversion, strips[i], height);
  });
  std::vector<std::size_t> order(strips.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rows[a].begin < rows[b].begin; });
  Plan plan;
  for (const std::size_t index : order) {
    plan.strips.push_back(strips[index]);
    plan.rows.push_back(rows[index]);
    plan.max_rows = std::max(plan.max_rows, rows[index].count());
  }
  return plan;
}

/// Rows that are of no use any more go, and those that are wanted are read.
class RowFeed {
 public:
  RowFeed(RowReader& reader, EnvironmentMap& window) : reader_(reader), window_(window) {}

  /// wanted   begins not before the one wanted last
  Result<void> feed(RowRange wanted) {
    window_.dropRowsBefore(wanted.begin);
    while (window_.rows().end < wanted.end) {
      const int next = window_.rows().end;
      const int until = next < wanted.begin ? wanted.begin : wanted.end;
      MIRRORBALL_TRY(rows, read(next, std::min(until - next, kRowsPerRead)));
      window_.appendRows(rows);
      window_.dropRowsBefore(wanted.begin);
    }
    return {};
  }

 private:
  Result<Image> read(int first, int count) {
    MIRRORBALL_TRY(rows, reader_.read(count));
    const NonFinite bad = findNonFinite(rows);
    if (bad.count == 0) return rows;
    return fail(ErrorCode::non_finite,
                reader_.description().name + ": has texels that are NaN or infinite, the first at (" +
                    std::to_string(bad.first.x) + ", " + std::to_string(first + bad.first.y) + ")",
                FixHint::repair);
  }

  RowReader& reader_;
  EnvironmentMap& window_;
};

/// How many strips from `begin` on find their rows in one window.
std::size_t endOfGroup(const Plan& plan, std::size_t begin, int capacity) {
  std::size_t end = begin;
  while (end < plan.rows.size() && plan.rows[end].end <= plan.rows[begin].begin + capacity) ++end;
  return end;
}

RowRange rowsOfGroup(const Plan& plan, std::size_t begin, std::size_t end) {
  RowRange rows = plan.rows[begin];
  for (std::size_t i = begin; i < end; ++i) rows.end = std::max(rows.end, plan.rows[i].end);
  return rows;
}

}  // namespace

Result<void> convertRows(RowReader& source, std::size_t memory, Projection to, int size, const Resampling& resampling,
                         const TakeTexels& take, const ProgressFunction& progress) {
  const Conversion conversion(to, size, resampling);
  MIRRORBALL_TRY_VOID(withName("the converted map", checkDimensions(conversion.extent().x, conversion.extent().y)));
  const RowReader::Description& picture = source.description();
  assert(picture.width == 2 * picture.height);
  const Plan plan = planOf(conversion, picture.height);
  const std::size_t row_bytes = std::size_t(picture.width) * std::size_t(picture.channels) * sizeof(float);
  if (std::size_t(plan.max_rows) * row_bytes > memory)
    return fail(ErrorCode::too_large,
                picture.name + ": needs " + textOfBytes(std::size_t(plan.max_rows) * row_bytes) + " for the " +
                    std::to_string(plan.max_rows) + " rows that are looked up at a time",
                FixHint::raise_memory);
  const std::size_t usual_rows = std::max(kUsualWindow_bytes / row_bytes, std::size_t(kRowsPerRead));
  const int capacity =
      std::min(std::max(plan.max_rows, static_cast<int>(std::min(usual_rows, memory / row_bytes))), picture.height);

  Environment window(EnvironmentMap::windowOfPanorama(picture.height, picture.channels, capacity));
  RowFeed feed(source, *window.map());
  ParallelConversion work(conversion, take, progress, plan.strips.size());
  for (std::size_t begin = 0; begin < plan.strips.size();) {
    const std::size_t end = endOfGroup(plan, begin, capacity);
    MIRRORBALL_TRY_VOID(feed.feed(rowsOfGroup(plan, begin, end)));
    MIRRORBALL_TRY_VOID(work.run(window, std::span(plan.strips).subspan(begin, end - begin)));
    begin = end;
  }
  return {};
}

}  // namespace mirrorball
