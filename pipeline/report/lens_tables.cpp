#include "pipeline/report/lens_tables.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

std::string comparison_table(const Json& compared) {
    Rows forms;
    for (const Json& form : compared) {
        std::string verdict = form.at("is_chosen").get<bool>() ? "chosen" : "";
        const auto add = [&](const std::string& word) {
            verdict += (verdict.empty() ? "" : ", ") + word;
        };
        if (form.at("predicts_best").get<bool>()) add("predicts best");
        if (form.at("has_least_bic").get<bool>()) add("least BIC");
        if (form.at("held_out_rms_px").is_null()) add(form.at("not_predicted").get<std::string>());
        const auto number = [&](const char* key, int digits) {
            return form.at(key).is_null() ? "" : number_text(form.at(key).get<double>(), digits);
        };
        forms.push_back({form.at("form").get<std::string>(), form.at("free_parameters").dump(),
                         number("rms_px", 4), number("held_out_rms_px", 4), number("excess_px2", 6),
                         number("excess_sigma_px2", 6), number("bic", 1), verdict});
    }
    return html_details("Which lens model the photographs support",
                        "<p>The fewest parameters that predict photographs which took no part "
                        "within one standard error of the best.</p>" +
                            html_table({"lens", "free", "RMS (px)", "held-out RMS (px)",
                                        "excess (px²)", "one standard error", "BIC", ""},
                                       forms));
}

}  // namespace

std::string lens_table(const Json& lens) {
    const Json sigma = lens.value("sigma", Json::array());
    Rows rows;
    for (std::size_t index = 0; index < lens.at("parameters").size(); ++index) {
        const bool is_refined = index < sigma.size() && sigma[index].get<double>() > 0;
        rows.push_back({lens.at("names").at(index).get<std::string>(),
                        number_text(lens.at("parameters")[index].get<double>(), 5),
                        is_refined ? number_text(1.96 * sigma[index].get<double>(), 5) : "held"});
    }
    const std::string size =
        lens.at("width_px").dump() + " x " + lens.at("height_px").dump() + " pixels";
    std::string html =
        "<h3>" + html_escaped("Lens for " + size + ": " + lens.at("model").get<std::string>()) +
        "</h3>\n" + html_table({"parameter", "value", "95 % within +-"}, rows);
    for (const Json& dropped : lens.value("dropped", Json::array())) {
        html += "<p>Left out, within two standard deviations of nothing: " +
                html_escaped(dropped.get<std::string>()) + "</p>\n";
    }
    if (lens.contains("compared")) html += comparison_table(lens.at("compared"));
    return html;
}

std::string pose_uncertainty_table(const Json& poses) {
    Rows rows;
    for (const Json& view : poses.value("views", Json::array())) {
        rows.push_back({view.at("name").get<std::string>(),
                        number_text(view.at("jitter_px").get<double>(), 3),
                        number_text(view.at("rotation_sigma_deg").get<double>(), 4),
                        number_text(view.at("position_sigma").get<double>(), 5)});
    }
    if (rows.empty()) return {};
    return html_details(
        "How certain each pose is",
        "<p>Standard deviations. Above 0.3 px of jitter blended pictures may show ghosts.</p>" +
            html_table({"photograph", "jitter (px)", "rotation (degrees)",
                        "position (units of the model)"},
                       rows));
}

}  // namespace lumi
