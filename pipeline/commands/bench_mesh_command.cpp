#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/bench/arrangement_benchmark.h"
#include "pipeline/bench/mesh_benchmark.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

using Arrangements = std::vector<ArrangementFigures>;

Json arrangements_json(const Arrangements& arrangements) {
    Json rows = Json::array();
    for (const ArrangementFigures& row : arrangements) {
        rows.push_back({{"name", row.name},
                        {"cameras", row.cameras},
                        {"construction", row.construction},
                        {"cameras_kept", row.cameras_kept},
                        {"shells", row.shells},
                        {"rays", row.rays},
                        {"rays_answered", row.rays_answered},
                        {"rays_with_one_face", row.rays_with_one_face},
                        {"most_cameras_a_ray", row.most_cameras_a_ray},
                        {"worst_sum_error", row.worst_sum_error},
                        {"worst_inconsistency", row.worst_inconsistency},
                        {"largest_jump", row.largest_jump},
                        {"worst_unslid_epipole_loss", row.worst_unslid_epipole_loss},
                        {"cpu_s", row.cpu_s}});
    }
    return rows;
}

Json timings_json(const std::vector<MeshTiming>& timings) {
    Json rows = Json::array();
    for (const MeshTiming& timing : timings) {
        rows.push_back({{"cameras", timing.cameras}, {"cpu_s", timing.cpu_s}});
    }
    return rows;
}

Json growth_json(const std::vector<ArrangementGrowth>& all) {
    Json rows = Json::array();
    for (const ArrangementGrowth& growth : all) {
        rows.push_back({{"name", growth.name},
                        {"timings", timings_json(growth.timings)},
                        {"growth_exponent", growth.growth_exponent}});
    }
    return rows;
}

Json report_json(const MeshBenchmark& result) {
    Json weights = Json::array();
    for (const WeightsFigures& way : result.weights) {
        weights.push_back({{"name", way.name},
                           {"covered_share", way.covered_share},
                           {"mean_inconsistency", way.mean_inconsistency},
                           {"largest_inconsistency", way.largest_inconsistency},
                           {"inconsistency_shares", way.inconsistency_shares},
                           {"largest_jump", way.largest_jump},
                           {"jumps_per_path", way.jumps_per_path},
                           {"continuity_p99", way.continuity_p99},
                           {"continuity_max", way.continuity_max}});
    }
    return Json{{"captures", result.captures},
                {"cameras", result.cameras},
                {"cameras_kept", result.cameras_kept},
                {"rays", result.rays},
                {"rays_with_one_face", result.rays_with_one_face},
                {"least_kernel_over_scene", result.least_kernel_over_scene},
                {"captures_repaired_by_flips", result.captures_repaired_by_flips},
                {"captures_repaired_by_slides", result.captures_repaired_by_slides},
                {"captures_not_repaired", result.captures_not_repaired},
                {"cameras_slid", result.cameras_slid},
                {"rms_slide_share", result.rms_slide_share},
                {"largest_slide_share", result.largest_slide_share},
                {"worst_epipole_loss", result.worst_epipole_loss},
                {"rms_epipole_loss", result.rms_epipole_loss},
                {"worst_epipole_loss_over_bound", result.worst_epipole_loss_over_bound},
                {"worst_unslid_epipole_loss", result.worst_unslid_epipole_loss},
                {"convex_cameras_kept", result.convex_cameras_kept},
                {"convex_rms_push_share", result.convex_rms_push_share},
                {"convex_largest_push_share", result.convex_largest_push_share},
                {"inconsistency_bin_ends", kInconsistencyBinEnds},
                {"weights", std::move(weights)},
                {"timings", timings_json(result.timings)},
                {"growth_exponent", result.growth_exponent}};
}

std::string percent(double share, int digits) { return number_text(100 * share, digits) + " %"; }

std::string share_text(long part, long whole) {
    const double share = whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
    return std::to_string(part) + " of " + std::to_string(whole) + " (" + percent(share, 4) + ")";
}

std::string scientific(double value) {
    std::array<char, 20> text{};
    std::snprintf(text.data(), text.size(), "%.0e", value);
    return value == 0 ? "0" : text.data();
}

/// One line an arrangement and number of cameras.
std::string arrangements_text(const Arrangements& arrangements) {
    std::string text =
        "arrangement                 cameras kept shells mesh    one face  a ray  inconsistency  "
        "jump   epipole  CPU ms\n";
    for (const ArrangementFigures& row : arrangements) {
        std::array<char, 240> line{};
        std::snprintf(
            line.data(), line.size(),
            "%-27s %7d %4d %6d %-7s %6.1f %%  %5d  %13s  %-6s %-8s %6.1f\n", row.name.c_str(),
            row.cameras, row.cameras_kept, row.shells, row.construction.c_str(),
            100.0 * static_cast<double>(row.rays_with_one_face) / static_cast<double>(row.rays),
            row.most_cameras_a_ray, scientific(row.worst_inconsistency).c_str(),
            scientific(row.largest_jump).c_str(), scientific(row.worst_unslid_epipole_loss).c_str(),
            1000 * row.cpu_s);
        text += line.data();
    }
    return text;
}

std::string growth_text(const std::vector<ArrangementGrowth>& all) {
    std::string text =
        "CPU ms of the mesh of ever more cameras, and their power that it grows by\n";
    for (const ArrangementGrowth& growth : all) {
        std::array<char, 240> name{};
        std::snprintf(name.data(), name.size(), "%-27s", growth.name.c_str());
        text += name.data();
        for (const MeshTiming& timing : growth.timings) {
            text +=
                "  " + std::to_string(timing.cameras) + ": " + number_text(1000 * timing.cpu_s, 1);
        }
        text += "  power " + number_text(growth.growth_exponent, 2) + "\n";
    }
    return text;
}

/// One line a way of weighing.
std::string consistency_text(const std::vector<WeightsFigures>& ways) {
    std::string text = padded_right("rays in %, by inconsistency", 28) + padded_left("0", 8);
    for (std::size_t i = 1; i < kInconsistencyBinEnds.size(); ++i)
        text += padded_left("<= " + number_text(kInconsistencyBinEnds[i], i == 1 ? 3 : 2), 9);
    text += "\n";
    for (const WeightsFigures& way : ways) {
        text += padded_right("  " + way.name, 28) +
                padded_left(number_text(100 * way.inconsistency_shares[0], 2), 8);
        for (std::size_t i = 1; i < way.inconsistency_shares.size(); ++i)
            text += padded_left(number_text(100 * way.inconsistency_shares[i], 2), 9);
        text += "\n";
    }
    return text;
}

std::string report_text(const MeshBenchmark& result) {
    std::string text = std::to_string(result.captures) + " random captures\n";
    text += "cameras that are vertices     " + share_text(result.cameras_kept, result.cameras) +
            "\n  of the paper's convex mesh  " +
            share_text(result.convex_cameras_kept, result.cameras) + "; or pushed out by " +
            percent(result.convex_rms_push_share, 1) + " rms, " +
            percent(result.convex_largest_push_share, 1) + " at most\n";
    text += "rays that enter one face      " + share_text(result.rays_with_one_face, result.rays) +
            "\n";
    text += "repaired by flips, by slides, not   " +
            std::to_string(result.captures_repaired_by_flips) + ", " +
            std::to_string(result.captures_repaired_by_slides) + ", " +
            std::to_string(result.captures_not_repaired) +
            "; slid: " + share_text(result.cameras_slid, result.cameras) + " by " +
            percent(result.rms_slide_share, 2) + " rms, " + percent(result.largest_slide_share, 1) +
            " at most\nown weight lost on own rays   " +
            number_text(result.worst_unslid_epipole_loss, 12) +
            " where not slid; over all cameras " + number_text(result.rms_epipole_loss, 3) +
            " rms, " + number_text(result.worst_epipole_loss, 3) + " at most, " +
            number_text(result.worst_epipole_loss_over_bound, 3) + " of its bound at most\n";
    text +=
        "weights of rays that two eyes see, 0.2 to 3.2 camera distances off what they look at, "
        "the same for all ways:\n";
    for (const WeightsFigures& way : result.weights) {
        text += way.name + ": " + percent(way.covered_share, 1) +
                " of rays covered, inconsistency " + number_text(way.mean_inconsistency, 4) +
                " (mean), " + number_text(way.largest_inconsistency, 4) +
                " (largest); largest jump " + number_text(way.largest_jump, 4) + ", " +
                number_text(way.jumps_per_path, 1) + " a path; change over a path " +
                number_text(way.continuity_p99, 1) + " (99 %), " +
                number_text(way.continuity_max, 1) + " (largest)\n";
    }
    text += consistency_text(result.weights);
    for (const MeshTiming& timing : result.timings) {
        text += std::to_string(timing.cameras) + " cameras  " + number_text(timing.cpu_s, 3) +
                " CPU s\n";
    }
    return text + "growth: cameras to the power of " + number_text(result.growth_exponent, 2) +
           "\n";
}

void run_bench_mesh(const MeshBenchmarkOptions& options, const std::filesystem::path& pictures,
                    const CommandContext& context) {
    if (!pictures.empty()) {
        draw_arrangements(pictures, options.seed);
        if (context.json) context.print_result(Json{{"pictures", pictures.string()}});
        context.say(pictures.string() + "\n");
        return;
    }
    const MeshBenchmark result = benchmark_mesh(options, *context.progress);
    const Arrangements arrangements = benchmark_arrangements(options.seed, *context.progress);
    const std::vector<ArrangementGrowth> growth =
        time_arrangements(options.most_cameras_timed, options.seed, *context.progress);
    if (context.json) {
        Json report = report_json(result);
        report["arrangements"] = arrangements_json(arrangements);
        report["arrangement_growth"] = growth_json(growth);
        context.print_result(report);
    } else {
        context.print_result(report_text(result) + arrangements_text(arrangements) +
                             growth_text(growth));
    }
}

}  // namespace

void add_bench_mesh_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "bench-mesh", "What the camera mesh keeps, costs and how it compares, at random",
        "lumi bench-mesh --json");
    const auto options = std::make_shared<MeshBenchmarkOptions>();
    command.add_option("--captures", options->captures, "Random captures all around a scene")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command.add_option("--rays", options->rays, "Random rays, over all captures")
        ->check(CLI::Range(1, 1000000000))
        ->capture_default_str();
    command.add_option("--roughness", options->roughness, "Share by which distances vary")
        ->check(number_from_to(0.0, 0.9))
        ->capture_default_str();
    command.add_option("--scene", options->scene_share, "Radius of the scene over the distance")
        ->check(number_from_to(0.01, 0.99))
        ->capture_default_str();
    command
        .add_option("--most-cameras", options->most_cameras_timed,
                    "Up to which number of cameras time is taken")
        ->check(CLI::Range(1000, 10000000))
        ->capture_default_str();
    command.add_option("--seed", options->seed, "Of all randomness")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()))
        ->capture_default_str();
    const auto pictures = std::make_shared<std::filesystem::path>();
    command.add_option("--pictures", *pictures,
                       "Measure nothing: draw the mesh of every arrangement into this folder");
    command.callback([options, pictures, &context] {
        context.chosen = [options, pictures, &context] {
            run_bench_mesh(*options, *pictures, context);
        };
    });
}

}  // namespace lumi
