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

std::vector<std::string> headings(bool has_subject) {
    std::vector<std::string> texts{"",     "PSNR (dB)", "covered (dB)",        "SSIM",
                                   "FLIP", "sharpness", "dB, exposure fitted", "covered (%)",
                                   "ms",   "CPU ms"};
    if (has_subject) texts.insert(texts.end(), {"subject (dB)", "of it covered (%)"});
    return texts;
}

std::vector<std::string> row_of(const std::string& name, const Json& score, bool has_subject) {
    std::vector<std::string> row{name,
                                 number_or_dash(score.at("psnr_db"), 2),
                                 number_or_dash(score.at("psnr_covered_db"), 2),
                                 number_or_dash(score.at("ssim"), 4),
                                 number_or_dash(score.at("flip"), 4),
                                 number_or_dash(score.at("edge_sharpness"), 3),
                                 number_or_dash(score.at("psnr_gain_fitted_db"), 2),
                                 number_or_dash(score.at("coverage"), 2, 100.0),
                                 number_or_dash(score.at("ms"), 1),
                                 number_or_dash(score.at("cpu_ms"), 1)};
    if (has_subject) {
        row.push_back(number_or_dash(score.at("psnr_subject_db"), 2));
        row.push_back(number_or_dash(score.at("subject_coverage"), 2, 100.0));
    }
    return row;
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
    return "<p>Where the blended cameras disagree, the picture is wrong: the rank correlation of "
           "ghost energy with the true error is " +
           number_text(correlation.get<double>(), 2) + " over blocks of 16 pixels.</p>\n";
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
    html += ghost_remark(evaluation) + "<p>Drawn with " +
            html_escaped(text_of(evaluation.at("gl"))) +
            ". Intervals are bootstrap intervals of the mean over views; fewer than six views "
            "are told by their least and greatest. Interior: between cameras; border: continued "
            "beyond the outermost ones.</p>\n";
    return html_section("How close it comes", html);
}

}  // namespace lumi
