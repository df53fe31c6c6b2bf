#include "program_size/spirv_module.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace mirrorball::testing {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;

// Instructions by their codes.
constexpr std::uint32_t kName = 5;
constexpr std::uint32_t kEntryPoint = 15;
constexpr std::uint32_t kFunction = 54;
constexpr std::uint32_t kFunctionEnd = 56;
constexpr std::uint32_t kFunctionCall = 57;
constexpr std::uint32_t kFirstSampling = 87;  // OpImageSampleImplicitLod
constexpr std::uint32_t kLastSampling = 97;   // OpImageDrefGather

/// What stands in functions and does nothing: OpLine, OpFunctionParameter, OpVariable, OpLoopMerge, OpSelectionMerge,
/// OpLabel, OpNoLine.
constexpr std::array<std::uint32_t, 7> kIdle{8, 55, 59, 246, 247, 248, 317};

/// Characters, four a word from the lowest byte on, up to a zero.
std::string readText(std::span<const std::uint32_t> words) {
  std::string text;
  for (const std::uint32_t word : words)
    for (int shift = 0; shift < 32; shift += 8) {
      const char character = static_cast<char>((word >> shift) & 0xffu);
      if (character == '\0') return text;
      text += character;
    }
  return text;
}

/// Reads the instructions of a module one after the other.
class Reader {
 public:
  /// instruction   whole, with its first word
  void read(std::span<const std::uint32_t> instruction) {
    const std::uint32_t code = instruction[0] & 0xffffu;
    // Names come before functions, and the parameters stand behind GLSL's.
    if (code == kName && instruction.size() > 2) {
      const std::string name = readText(instruction.subspan(2));
      names_[instruction[1]] = name.substr(0, name.find('('));
    } else if (code == kEntryPoint && instruction.size() > 2) {
      module_.main = instruction[2];
    } else if (code == kFunction && instruction.size() > 2) {
      function_ = &module_.functions[instruction[2]];
      function_->name = names_[instruction[2]];
    } else if (code == kFunctionEnd) {
      function_ = nullptr;
    } else if (function_) {
      readBody(code, instruction);
    }
  }

  SpirvModule module() && { return std::move(module_); }

 private:
  void readBody(std::uint32_t code, std::span<const std::uint32_t> instruction) {
    if (std::find(kIdle.begin(), kIdle.end(), code) != kIdle.end()) return;
    ++module_.instructions;
    if (code >= kFirstSampling && code <= kLastSampling) ++module_.samplings;
    if (code == kFunctionCall && instruction.size() > 3) function_->calls.push_back(instruction[3]);
  }

  SpirvModule module_;
  SpirvModule::Function* function_ = nullptr;  // whose body is read
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace

Result<SpirvModule> parseSpirv(std::span<const std::uint32_t> words) {
  if (words.size() < kHeaderWords || words[0] != kMagic) return fail(ErrorCode::bad_file, "this is not SPIR-V");
  Reader reader;
  for (words = words.subspan(kHeaderWords); !words.empty();) {
    const std::size_t size = words[0] >> 16;
    if (size == 0 || size > words.size())
      return fail(ErrorCode::bad_file, "an instruction of the SPIR-V module does not end in it");
    reader.read(words.first(size));
    words = words.subspan(size);
  }
  return std::move(reader).module();
}

int countCopies(const SpirvModule& module, std::string_view name) {
  std::map<std::uint32_t, int> known;  // copies that a call of a function adds
  const auto countBelow = [&](const auto& self, std::uint32_t number) -> int {
    if (const auto found = known.find(number); found != known.end()) return found->second;
    const auto function = module.functions.find(number);
    if (function == module.functions.end()) return 0;
    int copies = function->second.name == name ? 1 : 0;
    for (const std::uint32_t called : function->second.calls) copies += self(self, called);
    return known[number] = copies;  // SPIR-V has no recursion
  };
  return countBelow(countBelow, module.main);
}

}  // namespace mirrorball::testing
