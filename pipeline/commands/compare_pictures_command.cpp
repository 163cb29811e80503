#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/frame_files.h"
#include "pipeline/evaluate/edge_sharpness.h"
#include "pipeline/evaluate/flip.h"
#include "pipeline/evaluate/gain_fit.h"
#include "pipeline/evaluate/heat_map.h"
#include "pipeline/evaluate/image_metrics.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

struct PictureComparison {
    std::filesystem::path reference;
    std::filesystem::path test;
    std::filesystem::path flip_map;  ///< Where to write one; empty: nowhere.
};

/// The figures of a held-out view (see ViewScore) for any two pictures; null is what has no value.
Json comparison_json(const PictureComparison& comparison) {
    if (!comparison.flip_map.empty()) check_picture_out(comparison.flip_map, "--flip-map");
    const ColorImage reference = read_color_image(comparison.reference);
    const ColorImage test = read_color_image(comparison.test);
    const FloatImage flip = flip_error_map(reference, test);
    if (!comparison.flip_map.empty()) {
        write_png(comparison.flip_map, heat_map(flip, kFlipFullScale));
    }
    const GrayImage everywhere(reference.width(), reference.height(), 255);
    const auto sharpness = edge_sharpness(reference, test, everywhere);
    const auto fit = fit_gain(reference, test, everywhere);
    return Json{{"width_px", reference.width()},
                {"height_px", reference.height()},
                {"psnr_db", psnr_db(reference, test)},
                {"psnr_gain_fitted_db", fit ? Json(fit->psnr_db) : Json()},
                {"ssim", structural_similarity(reference, test)},
                {"flip", mean_error(flip)},
                {"edge_sharpness", sharpness ? Json(*sharpness) : Json()}};
}

std::string comparison_text(const Json& figures) {
    std::string text;
    for (const auto& [name, value] : figures.items()) {
        text += name + std::string(22 - name.size(), ' ') +
                (value.is_null()             ? "-"
                 : value.is_number_integer() ? std::to_string(value.get<int>())
                                             : number_text(value.get<double>(), 7)) +
                "\n";
    }
    return text;
}

}  // namespace

void add_compare_pictures_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(app, "compare-pictures",
                                    "PSNR, SSIM, FLIP and edge sharpness of one picture beside "
                                    "another of the same size, over the full frame",
                                    "lumi compare-pictures photograph.png rendering.png");
    const auto comparison = std::make_shared<PictureComparison>();
    command.add_option("REFERENCE", comparison->reference, "What it should look like")->required();
    command.add_option("TEST", comparison->test, "What it looks like")->required();
    command.add_option("--flip-map", comparison->flip_map,
                       "Writes where the two differ, dark blue (nowhere) to yellow (0.5 and more)");
    command.callback([comparison, &context] {
        context.chosen = [comparison, &context] {
            const Json figures = comparison_json(*comparison);
            if (context.json) {
                context.print_result(figures);
            } else {
                context.print_result(comparison_text(figures));
            }
        };
    });
}

}  // namespace lumi
