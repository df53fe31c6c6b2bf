// Asks two formulas a question.

#include <cstdio>

#include "formula/formula.h"

int main() {
  const glm::vec3 right(1.0f, 0.0f, 0.0f);
  std::printf("+X lies on face %d\n", mirrorball::formula::cubeFace(right));
  std::printf("glass reflects %.4f at normal incidence\n", mirrorball::formula::fresnelDielectric(1.0f, 1.0f / 1.5f));
}
