#include <algorithm>

#include "pipeline/evaluate/metric_words.h"
#include "pipeline/evaluate/view_score.h"
#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

std::string number_or_dash(const Json& value, int decimals, double factor = 1.0) {
    return value.is_null() ? "-" : number_text(factor * value.get<double>(), decimals);
}

/// What stands in the tables, column by column.
std::vector<MetricWords> told_metrics(bool has_subject) {
    std::vector<std::string> names{"psnr_db",        "psnr_covered_db",     "ssim",     "flip",
                                   "edge_sharpness", "psnr_gain_fitted_db", "coverage", "ms",
                                   "cpu_ms"};
    if (has_subject) names.insert(names.end(), {"psnr_subject_db", "subject_coverage"});
    std::vector<MetricWords> told;
    for (const std::string& name : names) {
        const auto has_name = [&](const MetricWords& words) { return words.name == name; };
        told.push_back(*std::find_if(metric_words().begin(), metric_words().end(), has_name));
    }
    return told;
}

/// "PSNR (dB)".
std::string heading_of(const MetricWords& words) {
    const std::string unit = words.unit;
    return words.words + (unit.empty() ? "" : " (" + unit + ")");
}

std::vector<std::string> headings(bool has_subject) {
    std::vector<std::string> texts{""};
    for (const MetricWords& words : told_metrics(has_subject)) texts.push_back(heading_of(words));
    return texts;
}

std::vector<std::string> row_of(const std::string& name, const Json& score, bool has_subject) {
    std::vector<std::string> row{name};
    for (const MetricWords& words : told_metrics(has_subject)) {
        const double factor = std::string(words.unit) == "%" ? 100.0 : 1.0;
        row.push_back(number_or_dash(score.at(words.name), words.decimals, factor));
    }
    return row;
}

std::string legend(bool has_subject) {
    TableRows rows;
    for (const MetricWords& words : told_metrics(has_subject))
        rows.push_back({heading_of(words), words.meaning});
    return html_details("What the figures mean", html_table({"figure", "meaning"}, rows));
}

/// The bounds of an interval as two scores, for a row each.
Json bound_of(const Json& interval, std::size_t side) {
    Json bound = Json::object();
    for (const auto& [key, range] : interval.items()) {
        bound[key] = range.is_null() ? Json() : range.at(side);
    }
    return bound;
}

/// The range of every figure over the views, as an interval of it.
Json ranges_of(const Json& views) {
    Json ranges = Json::object();
    for (const ScoreMetric& metric : score_metrics()) {
        std::vector<double> values;
        for (const Json& view : views) {
            const Json& value = view.at(metric.name);
            if (!value.is_null()) values.push_back(value.get<double>());
        }
        const auto range = range_of(values);
        ranges[metric.name] = range ? Json{range->low, range->high} : Json();
    }
    return ranges;
}

TableRows summary_rows(const Json& scores, bool has_subject) {
    TableRows rows{row_of("mean", scores.at("mean"), has_subject)};
    const Json& views = scores.at("views");
    if (views.size() >= kFewestForInterval) {
        rows.push_back(row_of("95 %, from", bound_of(scores.at("interval"), 0), has_subject));
        rows.push_back(row_of("95 %, to", bound_of(scores.at("interval"), 1), has_subject));
    } else if (views.size() > 1) {
        const Json ranges = ranges_of(views);
        rows.push_back(row_of("least", bound_of(ranges, 0), has_subject));
        rows.push_back(row_of("greatest", bound_of(ranges, 1), has_subject));
    }
    for (const char* place : {"interior", "border"}) {
        const Json& group = scores.at(place);
        const auto count = group.at("views").get<int>();
        if (count == 0) continue;
        rows.push_back(row_of(std::string(place) + " (" + std::to_string(count) + ")",
                              group.at("mean"), has_subject));
    }
    return rows;
}

std::string mode_tables(const std::string& mode, const Json& scores, bool has_subject) {
    TableRows rows;
    for (const Json& view : scores.at("views")) {
        rows.push_back(row_of(text_of(view.at("name")), view, has_subject));
    }
    return "<h3>" + html_escaped(mode) + "</h3>" +
           html_table(headings(has_subject), summary_rows(scores, has_subject)) +
           html_details("Every view", html_table(headings(has_subject), rows));
}

/// Evaluations of early versions say nothing of it.
std::string common_pixels_remark(const Json& rivals) {
    const auto common = rivals.find("common_pixels");
    if (common == rivals.end()) return {};
    std::string html = "<p>Over the " + number_text(100 * common->at("share").get<double>(), 1) +
                       " % of pixels that all methods cover that draw from the photographs' depth:";
    const char* separator = " ";
    for (const auto& [method, psnr_db] : common->at("psnr_db").items()) {
        if (psnr_db.is_null()) continue;
        html +=
            separator + html_escaped(method) + " " + number_text(psnr_db.get<double>(), 2) + " dB";
        separator = ", ";
    }
    return html + ".</p>\n";
}

/// Other methods, a line each, and why some are not among them.
std::string rivals_table(const Json& rivals, bool has_subject) {
    if (rivals.is_null()) return {};
    TableRows rows;
    for (const auto& [method, scores] : rivals.at("methods").items())
        rows.push_back(row_of(method, scores.at("mean"), has_subject));
    std::string html = "<h3>Other methods</h3>" + html_table(headings(has_subject), rows);
    for (const auto& [method, reason] : rivals.at("left_out").items())
        html += "<p>Not drawn: " + html_escaped(method) + ". " + html_escaped(text_of(reason)) +
                ".</p>\n";
    html += common_pixels_remark(rivals);
    return html +
           "<p>Means. Unstructured lumigraph, view-dependent texture, forward warping and, without "
           "depth, dynamically reparameterized are drawn in plain code; two-plane and spherical "
           "from photographs that were resampled.</p>\n";
}

std::string ghost_remark(const Json& evaluation) {
    const Json& correlation = evaluation.at("ghost_rank_correlation").at("between_blocks");
    if (correlation.is_null()) return {};
    constexpr double kTells = 0.4;
    constexpr double kHardlyTells = 0.1;
    const auto rank = correlation.get<double>();
    const std::string what = rank >= kTells ? "Where the blended cameras disagree, the picture is "
                                              "wrong"
                             : rank >= kHardlyTells
                                 ? "Where the blended cameras disagree hardly tells where the "
                                   "picture is wrong"
                                 : "Where the blended cameras disagree says nothing here of where "
                                   "the picture is wrong";
    return "<p>" + what + ": the rank correlation of ghost energy with the true error is " +
           number_text(rank, 2) +
           " over blocks of 16 pixels. (Ghost energy: how far the photographs that are blended at "
           "a pixel disagree, in squared levels of luma.)</p>\n";
}

}  // namespace

std::string figures_section(const ReportSources& sources) {
    const Json& evaluation = sources.evaluation;
    if (evaluation.is_null()) return {};
    const bool has_subject = !evaluation.at("subject_from").is_null();
    std::string html = mode_tables(text_of(evaluation.at("mode")), evaluation, has_subject);
    for (const auto& [mode, scores] : evaluation.at("modes").items()) {
        html += mode_tables(mode, scores, has_subject);
    }
    html += rivals_table(evaluation.at("rivals"), has_subject);
    if (has_subject) {
        html += "<p>Subject: the pixels of each photograph told from the rest by " +
                html_escaped(text_of(evaluation.at("subject_from"))) +
                ", drawn or not; the other figures are of the frame.</p>\n";
    }
    html += legend(has_subject) + ghost_remark(evaluation) + "<p>Drawn with " +
            html_escaped(text_of(evaluation.at("gl"))) +
            ". Intervals are bootstrap intervals of the mean over views; fewer than six views "
            "are told by their least and greatest. Interior: between cameras; border: continued "
            "beyond the outermost ones.</p>\n";
    return html_section("How close it comes", html);
}

}  // namespace lumi
