#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball::testing {

/// What a SPIR-V module has of instructions and calls.
///
/// Source: SPIR-V Specification 1.6, sections 2.3 (the layout of a module and an instruction) and 3.42.
struct SpirvModule {
  struct Function {
    std::string name;                  ///< in GLSL, without its parameters: "arrivingLight"; empty: it has none
    std::vector<std::uint32_t> calls;  ///< the function of each call in it
  };

  std::map<std::uint32_t, Function> functions;  ///< by their numbers in the module
  std::uint32_t main = 0;                       ///< the number of the entry point
  int instructions = 0;  ///< in the bodies of functions: what computes or branches, without variables and labels
  int samplings = 0;     ///< those of them that sample or fetch texels
};

/// words    of the machine's byte order
/// errors   bad_file: this is not a module, or an instruction in it reaches beyond its end
Result<SpirvModule> parseSpirv(std::span<const std::uint32_t> words);

/// How often a function's body stands in the program once all calls are replaced by bodies: the number of ways to it
/// from main along calls; of all functions of that name together.
int countCopies(const SpirvModule& module, std::string_view name);

}  // namespace mirrorball::testing
