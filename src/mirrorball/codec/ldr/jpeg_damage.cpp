#include "mirrorball/codec/ldr/jpeg_damage.h"

#include <algorithm>

#include <jerror.h>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

constexpr std::size_t kLongestText = 80;

/// Of the rows of blocks that a decoder goes through in one step, as texels.
std::size_t stepRows(const jpeg_decompress_struct& codec) { return std::size_t(codec.max_v_samp_factor) * DCTSIZE; }

/// How many groups of blocks the current scan has in a step; with one component they are its single blocks.
std::size_t groupsInStep(const jpeg_decompress_struct& codec) {
  const int rows = codec.comps_in_scan == 1 ? codec.cur_comp_info[0]->v_samp_factor : 1;
  return std::size_t(codec.MCUs_per_row) * std::size_t(rows);
}

/// How many rows beyond a step have colours that are mixed with those in it, where colours have fewer rows than texels.
std::size_t mixedRows(const jpeg_decompress_struct& codec) {
  for (int c = 0; c < codec.num_components; ++c)
    if (codec.comp_info[c].v_samp_factor < codec.max_v_samp_factor) return 1;
  return 0;
}

/// Whether the current scan brings the mean of each block.
bool bringsMeans(const jpeg_decompress_struct& codec) {
  return codec.progressive_mode == FALSE || (codec.Ss == 0 && codec.Ah == 0);
}

}  // namespace

void JpegDamage::note(jpeg_decompress_struct& codec) {
  const jpeg_error_mgr& warning = *codec.err;
  switch (warning.msg_code) {
    case JWRN_JPEG_EOF:
      ends_early_ = true;
      return;
    case JWRN_HIT_MARKER:
      lacks_data_ = true;
      return missInterval(codec);
    case JWRN_EXTRANEOUS_DATA:
      stray_bytes_ += static_cast<std::size_t>(std::max(warning.msg_parm.i[0], 0));
      return;
    case JWRN_NOT_SEQUENTIAL:
      odd_end_of_band_ = warning.msg_parm.i[1];
      return;
    case JWRN_HUFF_BAD_CODE:
    case JWRN_ARITH_BAD_CODE:
    case JWRN_MUST_RESYNC:
      missInterval(codec);
      break;
    default:
      break;
  }
  if (message_[0] == '\0') warning.format_message(reinterpret_cast<j_common_ptr>(&codec), message_);
}

void JpegDamage::missInterval(const jpeg_decompress_struct& codec) {
  if (is_missing_.empty()) return;
  if (!bringsMeans(codec)) {
    is_coarse_ = true;
    return;
  }
  const std::size_t step = codec.input_iMCU_row;
  const std::size_t interval = codec.restart_interval;
  const std::size_t mixed = mixedRows(codec);
  const std::size_t begin = std::max(step * stepRows(codec), mixed) - mixed;
  if (interval == 0) return miss(begin, is_missing_.size());
  // Where in the step the decoder is, libjpeg does not tell: its last group may be the first of an interval.
  const std::size_t groups = groupsInStep(codec);
  const std::size_t last_group = (step * groups + groups - 1) / interval * interval + interval - 1;
  miss(begin, (last_group / groups + 1) * stepRows(codec) + mixed);
}

void JpegDamage::miss(std::size_t begin, std::size_t end) {
  const std::size_t rows = is_missing_.size();
  begin = std::min(begin, rows);
  end = std::clamp(end, begin, rows);
  std::fill(is_missing_.begin() + std::ptrdiff_t(begin), is_missing_.begin() + std::ptrdiff_t(end), std::uint8_t{1});
  while (end_ > 0 && is_missing_[end_ - 1] != 0) --end_;
}

void JpegDamage::endAt(std::size_t first, const char* message) {
  miss(first, is_missing_.size());
  if (message_[0] == '\0') std::snprintf(message_, sizeof message_, "%s", message);
}

void JpegDamage::checkScans(const jpeg_decompress_struct& codec) {
  for (int c = 0; c < codec.num_components; ++c)
    if (codec.comp_info[c].quant_table == nullptr) {  // taken when the component's first scan begins
      lacks_data_ = true;
      miss(0, is_missing_.size());
    }
  if (!ends_early_ || codec.progressive_mode == FALSE || codec.coef_bits == nullptr) return;
  // The digits that are still to come of each frequency; −1: all.
  for (int c = 0; c < codec.num_components; ++c)
    is_coarse_ |= std::any_of(codec.coef_bits[c], codec.coef_bits[c] + DCTSIZE2, [](int bits) { return bits != 0; });
}

std::size_t JpegDamage::missingRows() const {
  return static_cast<std::size_t>(std::count(is_missing_.begin(), is_missing_.end(), std::uint8_t{1}));
}

void JpegDamage::blacken(Image8& picture) const { blackenRows(picture, is_missing_); }

std::string JpegDamage::cause() const {
  return message_[0] == '\0' ? "its data end within its first row of blocks" : excerpt(message_, kLongestText);
}

std::string JpegDamage::remarkOnRows() const {
  const std::size_t count = missingRows();
  const std::string those = missingRowsText(count);
  const bool are_last = end() + count == is_missing_.size();
  if (are_last && lacks_data_ && (ends_early_ || message_[0] == '\0')) return earlyEndText(count);
  const auto first = std::find(is_missing_.begin(), is_missing_.end(), std::uint8_t{1}) - is_missing_.begin();
  return "is damaged from row " + std::to_string(first) + " on" +
         (message_[0] == '\0' ? "" : " (" + excerpt(message_, kLongestText) + ")") + ": " + those;
}

std::string JpegDamage::remark() const {
  std::vector<std::string> parts;
  if (odd_end_of_band_ >= 0)
    parts.push_back("its scan says that it ends at frequency " + std::to_string(odd_end_of_band_) +
                    " of 63, as phones of Samsung write it: read with all");
  const bool misses_rows = missingRows() > 0;
  if (misses_rows) parts.push_back(remarkOnRows());
  if (is_coarse_) parts.emplace_back("ends before its last scan: it is coarser than it was meant to be");
  if (ends_early_ && !misses_rows && !is_coarse_) parts.emplace_back("lacks its end marker; all of its rows are there");
  if (stray_bytes_ > 0 && !misses_rows)
    parts.push_back(counted(stray_bytes_, "byte") + " between its segments belong to nothing, and are passed over");
  if (message_[0] != '\0' && !misses_rows)
    parts.push_back("is read although libjpeg warns: " + excerpt(message_, kLongestText));
  return join(parts, "; ");
}

}  // namespace mirrorball
