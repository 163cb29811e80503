#include <algorithm>

#include "calib/pictures/image_io.h"
#include "calib/work/counted.h"
#include "pipeline/report/sections.h"
#include "pipeline/report/spread.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/stages/removed_transients.h"
#include "pipeline/text/html.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

void append_left_out(TableRows& rows, const Json& left_out) {
    for (const Json& entry : left_out) {
        rows.push_back(
            {text_of(entry.at("name")), text_of(entry.at("code")), text_of(entry.at("reason"))});
    }
}

bool is_listed(const Json& left_out, const std::string& name) {
    return std::any_of(left_out.begin(), left_out.end(), [&](const Json& entry) {
        return entry.at("name").get<std::string>() == name;
    });
}

/// Every photograph that was read, and what became of it.
std::string used_photographs(const ReportSources& sources) {
    const Json poses = evidence_of(sources.stages, "poses");
    const Json pack = evidence_of(sources.stages, "pack");
    TableRows rows;
    for (const Photograph& photograph :
         read_photograph_list(sources.workspace.stage_folder("ingest")).photographs) {
        std::string use = "read";
        if (!poses.is_null()) {
            use = is_listed(poses.at("not_registered"), photograph.name) ? "no pose" : "used";
        }
        if (!pack.is_null() && use == "used") {
            const auto held_out = pack.at("held_out").get<std::vector<std::string>>();
            const bool is_held_out =
                std::binary_search(held_out.begin(), held_out.end(), photograph.name);
            const auto packed = pack.value("packed", std::vector<std::string>{photograph.name});
            if (is_held_out)
                use = "held out";
            else if (std::find(packed.begin(), packed.end(), photograph.name) == packed.end())
                use = "left out of the package";
        }
        rows.push_back(
            {photograph.name,
             std::to_string(photograph.width_px) + " x " + std::to_string(photograph.height_px),
             use});
    }
    return html_details("Every photograph",
                        html_table({"photograph", "size in pixels", "use"}, rows));
}

/// What was laid over photographs, and taken out.
std::string removed_overlays(const Json& ingest) {
    if (!ingest.contains("overlays")) return {};
    std::string html;
    for (const Json& overlay : ingest.at("overlays")) {
        html += "<p>" + html_escaped(overlay.at("what").get<std::string>()) + "</p>\n";
    }
    return html;
}

/// From what photographs were converted, and what else was done to their colours.
std::string color_notes_of(const Json& ingest) {
    if (!ingest.contains("colors")) return {};
    std::string html;
    for (const Json& note : ingest.at("colors")) {
        html += "<p>" + html_escaped(note.get<std::string>()) + ".</p>\n";
    }
    return html;
}

/// What was there for one photograph alone, and what the package shows instead.
std::string removed_transients(const ReportSources& sources) {
    constexpr int kPictureWidthPx = 480;
    constexpr std::size_t kMostPictures = 6;
    const Json pack = evidence_of(sources.stages, "pack");
    if (pack.is_null() || !pack.contains("transients") || pack.at("transients").empty()) return {};
    const Json& transients = pack.at("transients");
    std::string figures;
    for (const std::size_t i : spread(transients.size(), kMostPictures)) {
        const auto file = sources.workspace.stage_folder("pack") / kTransientFolder /
                          transients[i].at("picture").get<std::string>();
        figures += html_figure(read_color_image(file), kPictureWidthPx,
                               transients[i].at("name").get<std::string>());
    }
    return "<p>Something was there for one photograph alone, " + std::to_string(transients.size()) +
           " times, and was painted over as other photographs show the scene (left: as taken; "
           "right: as packed; <code>[package] keep_transients = true</code> leaves it in).</p>\n" +
           html_grid(figures);
}

}  // namespace

std::string photographs_section(const ReportSources& sources) {
    const Json ingest = evidence_of(sources.stages, "ingest");
    if (ingest.is_null()) return {};
    const Json poses = evidence_of(sources.stages, "poses");
    const int photographs = ingest.at("photographs").get<int>();
    std::string html = "<p>" + counted(photographs, "photograph") +
                       (photographs == 1 ? " was" : " were") + " read";
    if (!poses.is_null()) {
        html += ", " + text_of(poses.at("photographs_registered")) + " of them found their place";
    }
    html += ".</p>\n" + color_notes_of(ingest) + removed_overlays(ingest);
    TableRows rows;
    append_left_out(rows, ingest.at("left_out"));
    if (!poses.is_null()) append_left_out(rows, poses.at("not_registered"));
    if (!rows.empty()) html += html_table({"left out", "code", "why"}, rows);
    html += removed_transients(sources);
    return html_section("Photographs", html + used_photographs(sources));
}

}  // namespace lumi
