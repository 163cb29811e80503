#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/doctor/examination.h"
#include "calib/doctor/match_graph_picture.h"
#include "calib/ingest/overlay_removal.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "calib/work/printable.h"
#include "calib/work/process_memory.h"
#include "calib/work/whole_file.h"
#include "meshing/depth/depth_memory.h"
#include "pipeline/commands/commands.h"
#include "pipeline/config/build_config.h"
#include "pipeline/line/chosen_workspace.h"
#include "pipeline/line/named_paths.h"
#include "pipeline/stages/left_out_json.h"
#include "pipeline/stages/overlays_json.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct DoctorRequest {
    fs::path config;
    fs::path workspace;
};

const char* verdict_word(Severity verdict) {
    switch (verdict) {
        case Severity::kNote:
            return "good";
        case Severity::kRisk:
            return "at risk";
        case Severity::kHopeless:
            return "hopeless";
    }
    return "";
}

int exit_code_of(Severity verdict) {
    switch (verdict) {
        case Severity::kNote:
            return 0;
        case Severity::kRisk:
            return static_cast<int>(ErrorKind::kPartialResult);
        case Severity::kHopeless:
            return static_cast<int>(ErrorKind::kDegenerateCapture);
    }
    return 0;
}

std::vector<std::string> names_of(const std::vector<PhotographQuality>& photographs) {
    std::vector<std::string> names;
    for (const PhotographQuality& quality : photographs) names.push_back(quality.name);
    return names;
}

Json findings_json(const std::vector<Finding>& findings) {
    Json json = Json::array();
    for (const Finding& finding : findings) {
        json.push_back({{"code", code_of(finding.reason)},
                        {"severity", verdict_word(finding.severity)},
                        {"what", finding.what},
                        {"advice", advice_for(finding.reason)},
                        {"photographs", finding.photographs}});
    }
    return json;
}

Json photographs_json(const std::vector<PhotographQuality>& photographs) {
    Json json = Json::array();
    for (const PhotographQuality& quality : photographs) {
        json.push_back({{"name", quality.name},
                        {"features", quality.features},
                        {"blur_sigma_px", quality.blur_sigma_px},
                        {"noise_sigma", quality.noise_sigma},
                        {"contrast", quality.contrast()},
                        {"clipped_share", quality.clipped_share},
                        {"mean_linear", quality.mean_linear}});
    }
    return json;
}

Json pairs_json(const CaptureEvidence& evidence) {
    Json json = Json::array();
    for (const PairGeometry& pair : evidence.pairs) {
        json.push_back({{"photographs", {pair.pair.first, pair.pair.second}},
                        {"inliers", pair.pair.inliers.size()},
                        {"median_angle_deg", pair.median_angle_deg},
                        {"epipoles_in_view", pair.epipoles_in_view}});
    }
    return json;
}

/// What the depth stage of a build will take at most, by the sizes of the photographs.
double depth_mib(const Examination& seen, const DepthOptions& options, int threads) {
    std::vector<std::uint64_t> pixels;
    for (const Eigen::Vector2i& size : seen.build_sizes_px) {
        const double scale = std::min(1.0, 1.0 * options.max_width_px / size.x());
        pixels.push_back(static_cast<std::uint64_t>(scale * scale * size.x() * size.y()));
    }
    release_free_memory();
    const DepthMemory memory =
        predicted_depth_memory(pixels, options.model, resolve_threads(threads),
                               static_cast<std::uint64_t>(options.max_memory_mib) << 20,
                               memory_in_use().value_or(0), options.max_neighbours);
    return static_cast<double>(memory.peak()) / (1 << 20);
}

Json examination_json(const Examination& seen, double depth_mib, const fs::path& picture) {
    const MotionEvidence& motion = seen.evidence.motion;
    return Json{{"verdict", verdict_word(seen.verdict())},
                {"exit_code", exit_code_of(seen.verdict())},
                {"findings", findings_json(seen.findings)},
                {"photographs", photographs_json(seen.evidence.photographs)},
                {"left_out", left_out_json(seen.left_out)},
                {"overlays", overlays_json(seen.overlays)},
                {"colors", seen.color_notes},
                {"pairs", pairs_json(seen.evidence)},
                {"rotation_share", motion.rotation_share()},
                {"planar_share", motion.planar_share()},
                {"loop_conflict_share", seen.evidence.loops.conflict_share()},
                {"median_angle_deg", median_angle_deg(seen.evidence)},
                {"groups", groups_of(match_graph_of(seen.evidence))},
                {"match_graph", printable(picture.string())},
                {"expected_build",
                 {{"cpu_s", seen.build.cpu_s},
                  {"peak_mib", std::max(seen.build.peak_mib, depth_mib)},
                  {"depth_mib", depth_mib}}},
                {"cpu_s", seen.cost.cpu_s},
                {"wall_s", seen.cost.wall_s}};
}

std::string concerned_text(const Finding& finding) {
    constexpr std::size_t kMaxNamed = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMaxNamed, finding.photographs.size()); ++i) {
        text += (i == 0 ? "     " : ", ") + printable(finding.photographs[i]);
    }
    if (finding.photographs.size() > kMaxNamed) {
        text += " and " + std::to_string(finding.photographs.size() - kMaxNamed) + " more";
    }
    return text.empty() ? text : text + "\n";
}

std::string angle_text(const CaptureEvidence& evidence) {
    if (evidence.pairs.empty()) return "";
    return "; rays meet at " + number_text(median_angle_deg(evidence), 1) +
           " degrees in the middle pair";
}

std::string examination_text(const Examination& seen, double depth_mib, const fs::path& picture) {
    std::string text = std::string("verdict: ") + verdict_word(seen.verdict()) + "\n";
    for (const Finding& finding : seen.findings) {
        text += std::string(finding.severity == Severity::kNote ? "note " : "") +
                std::string(code_of(finding.reason)) + ": " + finding.what + "\n" +
                concerned_text(finding) + "  -> " + std::string(advice_for(finding.reason)) + "\n";
    }
    for (const RemovedOverlay& overlay : seen.overlays) text += text_of(overlay) + "\n";
    for (const std::string& note : seen.color_notes) text += note + "\n";
    for (const LeftOut& left_out : seen.left_out) {
        text += "left out " + printable(left_out.name) + " (" + left_out.code +
                "): " + left_out.reason + "\n";
    }
    const CaptureEvidence& evidence = seen.evidence;
    text += "photographs: " + std::to_string(evidence.photographs.size()) +
            ", pairs of them that show the same things: " + std::to_string(evidence.pairs.size()) +
            angle_text(evidence) + "\n";
    if (seen.verdict() == Severity::kHopeless) {
        text += "a build will be refused, or place a small part of the photographs";
    } else {
        text += "a build will take about " + number_text(seen.build.cpu_s, 0) +
                " CPU s (half or twice that) and " +
                number_text(std::max(seen.build.peak_mib, depth_mib), 0) +
                " MiB (a quarter more or less), of these depth " + number_text(depth_mib, 0) +
                " MiB";
    }
    text += "; looking took " + number_text(seen.cost.cpu_s, 1) + " CPU s\n";
    return text + picture.string() + "\n";
}

/// The lens for the size the doctor looks at is scaled by the stage itself.
void run_doctor(const DoctorRequest& request, CommandContext& context) {
    const BuildConfig config = load_build_config(request.config);
    expect_named_paths(config, "pack");
    const int threads = context.threads > 0 ? context.threads : config.threads;
    const WorkspaceLayout workspace = layout_for(request.workspace, config, threads);
    const fs::path folder = workspace.folder() / "doctor";
    ExaminationOptions options;
    options.build = config.ingest;
    options.build.workspace = workspace.folder();
    options.mask_folder = config.poses.mask_folder;
    options.lens_is_told_elsewhere = !config.boards.empty() || !config.imported_poses.empty();
    const Examination seen = examine_capture(config.photographs_or_video, config.given_lens,
                                             options, folder, threads, *context.progress);
    static_cast<void>(held_out_names(names_of(seen.evidence.photographs), config.hold_out));
    const fs::path picture = folder / "match_graph.svg";
    write_whole_text(picture, match_graph_svg(seen.evidence));
    const double depth = depth_mib(seen, config.depth, threads);
    const Json json = examination_json(seen, depth, picture);
    write_json_file(folder / "doctor.json", json);
    if (context.json) {
        context.print_result(json);
    } else {
        context.print_result(examination_text(seen, depth, picture));
    }
    context.exit_code = exit_code_of(seen.verdict());
}

}  // namespace

void add_doctor_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "doctor",
                    "Looks at the photographs before the long step: what will go wrong, and what "
                    "to do about it. Exit code 0: good, 5: at risk, 4: hopeless",
                    "lumi doctor configs/fountain.toml\n         lumi doctor photos/");
    const auto request = std::make_shared<DoctorRequest>();
    command
        .add_option("CONFIG", request->config,
                    "Configuration file, a folder of photographs, or a video")
        ->required();
    command.add_option("--workspace", request->workspace, "Where to work (default: work/NAME)");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_doctor(*request, context); };
    });
}

}  // namespace lumi
