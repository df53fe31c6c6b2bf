#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/formatted.h"
#include "cli/json_values.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/study/fresnel_forms.h"

namespace mirrorball::cli {
namespace {

constexpr int kAngleStep = 5;  // degrees between the rows of the table

/// All that `fresnel` was told.
struct FresnelRequest {
  std::string material = {};
  float ior = 1.5f;
  std::string output = {};
  bool json = false;
  GivenOptions given;
};

const auto kFresnelOptions = std::to_array<Option<FresnelRequest>>({
    {{.name = "ior",
      .value = "N",
      .minimum = 0.1,
      .maximum = 10,
      .help = "instead of a material: a dielectric's index of refraction, inside relative to outside"},
     &FresnelRequest::ior},
    {{.name = "output",
      .value = "OUT",
      .help = "also plot the forms, .svg; -.svg is standard output, without the table",
      .letter = "o",
      .takes_path = true},
     &FresnelRequest::output},
    {{.name = "json", .help = "print JSON"}, &FresnelRequest::json},
});

/// What the curves are of.
struct FresnelSubject {
  std::string title;  ///< "gold", "index 1.5"
  std::vector<FresnelCurves> curves;
};

/// errors   usage
Result<FresnelSubject> subjectOf(const FresnelRequest& request) {
  const bool has_ior = request.given.contains("ior");
  if (request.material.empty() != has_ior)
    return fail(ErrorCode::usage, has_ior
                                      ? "name a material or give --ior, not both"
                                      : "name a metal or a glass, such as gold or bk7, or give an index: --ior 1.5");
  Material material;
  material.ior = request.ior;
  if (!has_ior) {
    MIRRORBALL_TRY(named, materialNamed(request.material));
    material = std::move(named);
  }
  MIRRORBALL_TRY(curves, fresnelCurves(material));
  return FresnelSubject{has_ior ? "index " + shortText(double(request.ior)) : material.name, std::move(curves)};
}

std::string curveTable(const FresnelCurves& curves) {
  std::string text = formatted("%-10s", "angle");
  for (const std::string_view name : kFresnelFormNames) text += formatted("%-11s", std::string(name).c_str());
  text.erase(text.find_last_not_of(' ') + 1);
  for (int degrees = 0; degrees <= 90; degrees += kAngleStep) {
    text += formatted("\n%-10d", degrees);
    for (std::size_t form = 0; form < kFresnelFormNames.size(); ++form)
      text += formatted(form + 1 < kFresnelFormNames.size() ? "%-11.5f" : "%.5f",
                        double(curves.reflectanceAtAngle(FresnelForm(form), degrees)));
  }
  return text + "\n";
}

std::string textOf(const FresnelSubject& subject) {
  std::string text;
  for (const FresnelCurves& curves : subject.curves) {
    const EmpiricalFit& fit = curves.empirical;
    if (!text.empty()) text += "\n";
    text += subject.title + (curves.name.empty() ? "" : ", " + curves.name) + formatted(": n %.5g", double(curves.n)) +
            (curves.k > 0.0f ? formatted(", k %.5g", double(curves.k)) : "") +
            formatted(", %.5g at normal incidence\n", double(curves.f0)) + curveTable(curves) +
            formatted("schlick   off by up to %.4f\n", double(curves.schlick_error)) +
            formatted("f82       off by up to %.4f with f82_tint=%.3f\n", double(curves.f82_error),
                      double(curves.f82_tint)) +
            formatted(
                "empirical off by up to %.4f with fresnel_offset=%.3f fresnel_scale=%.3f fresnel_power=%.3f, its "
                "best fit\n",
                double(fit.greatest_error), double(fit.offset), double(fit.scale), double(fit.power));
  }
  return text;
}

std::string jsonOf(const FresnelSubject& subject) {
  Json json;
  json["title"] = subject.title;
  json["curves"] = Json::array();
  for (const FresnelCurves& curves : subject.curves) {
    const EmpiricalFit& fit = curves.empirical;
    Json one;
    one["channel"] = curves.name.empty() ? Json() : Json(curves.name);
    one["n"] = numberOf(double(curves.n));
    one["k"] = numberOf(double(curves.k));
    one["f0"] = numberOf(double(curves.f0));
    one["schlick"] = {{"greatest_error", numberOf(double(curves.schlick_error))}};
    one["f82"] = {{"f82_tint", numberOf(double(curves.f82_tint))},
                  {"greatest_error", numberOf(double(curves.f82_error))}};
    one["empirical"] = {{"fresnel_offset", numberOf(double(fit.offset))},
                        {"fresnel_scale", numberOf(double(fit.scale))},
                        {"fresnel_power", numberOf(double(fit.power))},
                        {"greatest_error", numberOf(double(fit.greatest_error))}};
    one["table"] = Json::array();
    for (int degrees = 0; degrees <= 90; degrees += kAngleStep) {
      Json row{{"angle", degrees}};
      for (std::size_t form = 0; form < kFresnelFormNames.size(); ++form)
        row[std::string(kFresnelFormNames[form])] =
            numberOf(double(curves.reflectanceAtAngle(FresnelForm(form), degrees)));
      one["table"].push_back(std::move(row));
    }
    json["curves"].push_back(std::move(one));
  }
  return printedJson(json);
}

/// errors   usage; io
Result<void> writePlot(const FresnelSubject& subject, const std::string& output) {
  const std::string svg = fresnelPlotOf(subject.curves, subject.title);
  MIRRORBALL_TRY_VOID(writeFile(output, {reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size()}));
  announce(output);
  return {};
}

Result<void> tellFresnel(const FresnelRequest& request, bool prints) {
  const std::string& output = request.output;
  MIRRORBALL_TRY(subject, subjectOf(request));
  if (!output.empty()) {
    if (extensionOf(output) != "svg") return fail(ErrorCode::usage, output + ": the plot is a picture of lines, .svg");
    MIRRORBALL_TRY_VOID(checkFolder(output));
    MIRRORBALL_TRY_VOID(writePlot(subject, output));
  }
  if (prints) print(request.json ? jsonOf(subject) : textOf(subject));
  return {};
}

}  // namespace

Command fresnelCommand() {
  auto request = std::make_shared<FresnelRequest>();
  Command command{
      .name = "fresnel",
      .help = "Tells what a metal or a glass reflects at each angle, by every form of Fresnel's law",
      .about =
          "MATERIAL is a built-in metal or glass; `--ior` stands for any other dielectric. Printed are the "
          "reflectance by each form, and the parameters that bring `f82` and `empirical` nearest to the exact "
          "one, as `--set` takes them. A metal is told for red, green and blue.",
      .examples = {{"fresnel gold", "tables for red, green and blue, and the best fits"},
                   {"fresnel --ior 1.5 -o fresnel.svg", "the same of a dielectric, with a plot"}}};
  addArgument(command,
              {.name = "MATERIAL",
               .help = "a built-in metal or glass, such as gold or bk7; left out where --ior is given",
               .names = materialNames},
              request->material);
  addOptions<FresnelRequest>(command, kFresnelOptions, *request, &request->given);
  command.action = [request]() -> Result<void> {
    const bool prints = !request->output.starts_with("-.");
    if (request->json && !prints)
      return fail(ErrorCode::usage, request->output + ": standard output has the JSON; name a file");
    return withStandardStreams({}, request->output, [&] { return tellFresnel(*request, prints); });
  };
  return command;
}

}  // namespace mirrorball::cli
