#include "pipeline/stress/run_stress.h"

#include <algorithm>

#include "pipeline/evaluate/image_metrics.h"
#include "render/lumigraph/even_exposure.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {
namespace {

std::vector<double> read_strengths(const ConfigSection& section, const Perturbation& perturbation) {
    const std::vector<double> strengths =
        section.numbers(perturbation.name, perturbation.strengths);
    const bool is_rising = std::adjacent_find(strengths.begin(), strengths.end(),
                                              std::greater_equal<>()) == strengths.end();
    if (strengths.empty() || strengths.front() <= 0.0 || !is_rising) {
        section.refuse(perturbation.name, "numbers above 0, each more than the one before");
    }
    return strengths;
}

/// Mean PSNR over the views, mode by mode.
std::vector<double> mean_psnr_db(const Lumigraph& lumigraph, const std::vector<StressView>& views,
                                 const std::vector<RenderMode>& modes, Progress& progress) {
    OffscreenRenderer renderer(lumigraph);
    std::vector<double> means;
    for (const RenderMode mode : modes) {
        double sum = 0.0;
        for (const StressView& view : views) {
            progress.throw_if_interrupted();
            sum += psnr_db(view.photograph,
                           darkened_by_lens(renderer.draw(view.eye, {.mode = mode}).color,
                                            view.eye.camera, view.falloff));
        }
        means.push_back(sum / static_cast<double>(views.size()));
    }
    return means;
}

}  // namespace

StressOptions read_stress_options(const ConfigSection& section) {
    StressOptions options;
    const int seed = section.integer("seed", static_cast<int>(options.seed));
    if (seed < 0) section.refuse("seed", "0 or more");
    options.seed = static_cast<std::uint64_t>(seed);
    options.max_loss_db = section.number("max_loss_db", options.max_loss_db);
    if (!(options.max_loss_db > 0.0)) section.refuse("max_loss_db", "more than 0");
    for (const std::string& name : section.texts("modes", {})) {
        const auto mode = render_mode_named(name);
        if (!mode) section.refuse("modes", "names of modes as in `lumi render --mode`");
        options.modes.push_back(*mode);
    }
    if (options.modes.empty()) options.modes = all_render_modes();
    const std::vector<std::string> wanted = section.texts("perturbations", {});
    std::vector<std::string> known;
    for (Perturbation perturbation : known_perturbations()) {
        known.push_back(perturbation.name);
        perturbation.strengths = read_strengths(section, perturbation);
        if (!wanted.empty() &&
            std::find(wanted.begin(), wanted.end(), perturbation.name) == wanted.end()) {
            continue;
        }
        options.perturbations.push_back(std::move(perturbation));
    }
    for (const std::string& name : wanted) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        std::string list;
        for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
        section.refuse("perturbations", "names out of: " + list);
    }
    section.expect_all_keys_known();
    return options;
}

std::vector<StressCurve> stress_curves(const StressSubject& subject, const StressOptions& options,
                                       Progress& progress) {
    const std::vector<double> unperturbed =
        mean_psnr_db(subject.lumigraph, subject.views, options.modes, progress);
    std::size_t steps = 0;
    for (const Perturbation& one : options.perturbations) steps += one.strengths.size();
    progress.begin("perturbing", steps);
    std::vector<StressCurve> curves;
    for (const Perturbation& perturbation : options.perturbations) {
        const std::size_t first = curves.size();
        for (std::size_t m = 0; m < options.modes.size(); ++m) {
            curves.push_back({perturbation.name, options.modes[m], {0.0}, {unperturbed[m]}, {}});
        }
        for (const double strength : perturbation.strengths) {
            const std::vector<double> means = mean_psnr_db(
                perturbation.apply(subject.lumigraph, strength, options.seed, subject.mesh_options),
                subject.views, options.modes, progress);
            for (std::size_t m = 0; m < means.size(); ++m) {
                curves[first + m].strengths.push_back(strength);
                curves[first + m].psnr_db.push_back(means[m]);
            }
            progress.advance();
        }
    }
    for (StressCurve& curve : curves) {
        curve.breaking_point = breaking_point_of(curve, options.max_loss_db);
    }
    return curves;
}

}  // namespace lumi
