#include "pipeline/hazards/hazard_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "calib/work/whole_file.h"
#include "pipeline/hazards/hazard_chart.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

void count(EndingCounts& counts, const Attempt& attempt) {
    counts.tried += attempt.ending == Ending::kNotTried ? 0 : 1;
    counts.right += attempt.ending == Ending::kRight ? 1 : 0;
    counts.refused += attempt.ending == Ending::kRefused ? 1 : 0;
    counts.false_successes += attempt.ending == Ending::kFalse ? 1 : 0;
    counts.failed += attempt.ending == Ending::kFailed ? 1 : 0;
    counts.cpu_s += attempt.cpu_s;
}

Json attempt_json(const Attempt& attempt) {
    if (attempt.ending == Ending::kNotTried) return {};
    Json json{{"ending", name_of(attempt.ending)}, {"cpu_s", attempt.cpu_s}};
    if (attempt.ending == Ending::kRight || attempt.ending == Ending::kFalse) {
        json["placed"] = attempt.error.placed;
        // Without spread, no error relative to it is defined.
        json["position_error_share"] = std::isfinite(attempt.error.position_share)
                                           ? Json(attempt.error.position_share)
                                           : Json();
        json["rotation_error_deg"] = attempt.error.rotation_deg;
        json["focal_error_share"] = attempt.focal_error_share;
    } else {
        json["code"] = attempt.code;
        json["what"] = attempt.what;
    }
    return json;
}

Json reason_json(const std::optional<CaptureReason>& reason) {
    return reason ? Json(code_of(*reason)) : Json();
}

Json counts_json(const EndingCounts& counts) {
    return Json{{"tried", counts.tried},     {"right", counts.right},
                {"refused", counts.refused}, {"false_successes", counts.false_successes},
                {"failed", counts.failed},   {"cpu_s", counts.cpu_s}};
}

std::string attempt_text(const Attempt& attempt) {
    if (attempt.ending == Ending::kNotTried) return "-";
    if (attempt.ending == Ending::kRight || attempt.ending == Ending::kFalse) {
        return std::string(name_of(attempt.ending)) + " " + std::to_string(attempt.error.placed) +
               " " + number_text(100 * attempt.error.position_share, 1) + "% " +
               number_text(attempt.error.rotation_deg, 2) + "d";
    }
    return attempt.ending == Ending::kRefused && !attempt.code.empty()
               ? attempt.code
               : std::string(name_of(attempt.ending));
}

std::string reason_text(const std::optional<CaptureReason>& reason) {
    return reason ? std::string(code_of(*reason)) : "-";
}

std::string counts_text(const std::string& name, const EndingCounts& counts) {
    if (counts.tried == 0) return name + ": not tried\n";
    return name + ": " + std::to_string(counts.right) + " right, " +
           std::to_string(counts.refused) + " refused, " + std::to_string(counts.false_successes) +
           " false successes, " + std::to_string(counts.failed) + " failed, " +
           number_text(counts.cpu_s, 0) + " CPU s\n";
}

}  // namespace

StressSummary summary_of(const std::vector<Trial>& trials) {
    StressSummary summary;
    summary.trials = static_cast<int>(trials.size());
    for (const Trial& trial : trials) {
        count(summary.lumi, trial.lumi);
        count(summary.colmap, trial.colmap);
        summary.doctor_cpu_s += trial.doctor_cpu_s;
        const bool is_right = reason_is_right(trial);
        summary.reasons_right += is_right ? 1 : 0;
        if (trial.lumi.ending != Ending::kRight) {
            ++summary.troubled;
            summary.troubled_reasons_right += is_right ? 1 : 0;
        }
        if (trial.strength != curve_of(trial.hazard).strengths.front()) continue;
        ++summary.harmless;
        summary.harmless_refused += trial.lumi.ending == Ending::kRefused ? 1 : 0;
    }
    return summary;
}

Json hazards_json(const std::vector<Trial>& trials) {
    const StressSummary summary = summary_of(trials);
    Json rows = Json::array();
    for (const Trial& trial : trials) {
        rows.push_back({{"hazard", curve_of(trial.hazard).name},
                        {"strength", trial.strength},
                        {"seed", trial.seed},
                        {"photographs", trial.photographs},
                        {"lumi", attempt_json(trial.lumi)},
                        {"colmap", attempt_json(trial.colmap)},
                        {"true_reason", code_of(curve_of(trial.hazard).reason)},
                        {"given_reason", reason_json(trial.given_reason)},
                        {"doctor_reason", reason_json(trial.doctor_reason)},
                        {"doctor_cpu_s", trial.doctor_cpu_s},
                        {"reason_is_right", reason_is_right(trial)}});
    }
    return Json{{"bounds",
                 {{"position_error_share", kMaxPositionErrorShare},
                  {"rotation_error_deg", kMaxRotationError_deg}}},
                {"trials", summary.trials},
                {"lumi", counts_json(summary.lumi)},
                {"colmap", counts_json(summary.colmap)},
                {"harmless", summary.harmless},
                {"harmless_refused", summary.harmless_refused},
                {"reasons_right", summary.reasons_right},
                {"troubled", summary.troubled},
                {"troubled_reasons_right", summary.troubled_reasons_right},
                {"doctor_cpu_s", summary.doctor_cpu_s},
                {"rows", std::move(rows)}};
}

std::string hazards_csv(const std::vector<Trial>& trials) {
    std::ostringstream csv;
    csv << "hazard,strength,seed,lumi,lumi_code,lumi_placed,lumi_position_error_share,"
           "lumi_rotation_error_deg,lumi_cpu_s,colmap,colmap_placed,colmap_position_error_share,"
           "colmap_rotation_error_deg,colmap_cpu_s,true_reason,given_reason,doctor_cpu_s\n";
    for (const Trial& trial : trials) {
        csv << curve_of(trial.hazard).name << ',' << trial.strength << ',' << trial.seed << ','
            << name_of(trial.lumi.ending) << ',' << trial.lumi.code << ','
            << trial.lumi.error.placed << ',' << trial.lumi.error.position_share << ','
            << trial.lumi.error.rotation_deg << ',' << trial.lumi.cpu_s << ','
            << name_of(trial.colmap.ending) << ',' << trial.colmap.error.placed << ','
            << trial.colmap.error.position_share << ',' << trial.colmap.error.rotation_deg << ','
            << trial.colmap.cpu_s << ',' << code_of(curve_of(trial.hazard).reason) << ','
            << reason_text(trial.given_reason) << ',' << trial.doctor_cpu_s << '\n';
    }
    return csv.str();
}

std::string trial_text(const Trial& trial) {
    std::ostringstream strength;
    strength << trial.strength;
    return column(curve_of(trial.hazard).name, 13) + column(strength.str(), 10) +
           column(std::to_string(trial.seed), 6) + column(attempt_text(trial.lumi), 26) +
           column(attempt_text(trial.colmap), 26) + column(reason_text(trial.given_reason), 22) +
           (reason_is_right(trial) ? "" : "not right");
}

std::string hazards_text(const std::vector<Trial>& trials) {
    std::string text = column("hazard", 13) + column("strength", 10) + column("seed", 6) +
                       column("lumi", 26) + column("COLMAP alone", 26) +
                       column("reason given", 22) + "\n";
    for (const Trial& trial : trials) text += trial_text(trial) + "\n";
    const StressSummary summary = summary_of(trials);
    text += counts_text("lumi", summary.lumi) + counts_text("COLMAP alone", summary.colmap);
    text += "harmless: " + std::to_string(summary.harmless_refused) + " of " +
            std::to_string(summary.harmless) + " refused\n";
    text += "reason right: " + std::to_string(summary.reasons_right) + " of " +
            std::to_string(summary.trials) + "; where poses did not come out right: " +
            std::to_string(summary.troubled_reasons_right) + " of " +
            std::to_string(summary.troubled) + "\n";
    return text + "doctor: " + number_text(summary.doctor_cpu_s, 1) + " CPU s\n";
}

void write_hazard_report(const std::filesystem::path& folder, const std::vector<Trial>& trials,
                         const Progress& progress) {
    write_json_file(folder / "hazards.json", hazards_json(trials));
    write_whole_text(folder / "hazards.csv", hazards_csv(trials));
    draw_hazard_chart(folder / "hazards.svg", trials, progress);
}

}  // namespace lumi
