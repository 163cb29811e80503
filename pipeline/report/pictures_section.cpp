#include <algorithm>

#include "calib/pictures/image_io.h"
#include "pipeline/evaluate/comparison_strip.h"
#include "pipeline/report/sections.h"
#include "pipeline/report/spread.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kPictureWidthPx = 960;
constexpr int kMapWidthPx = 480;
constexpr std::size_t kMaxViews = 6;

std::string map_figure(const fs::path& folder, const Json& view, const char* key,
                       const std::string& caption) {
    if (!view.contains(key)) return {};
    return html_figure(read_color_image(folder / view.at(key).get<std::string>()), kMapWidthPx,
                       caption);
}

/// What else the photographs were good for, beside judging.
std::string part_taken(const ReportSources& sources) {
    if (sources.target.is_null())
        return "These photographs took part in finding the cameras and in nothing else: depth, "
               "camera mesh and pictures were made without them.";
    return "These photographs took part in finding the cameras, and settings were chosen by these "
           "photographs, so that others may be reproduced less well; depth, camera mesh and "
           "pictures were made without them.";
}

std::string view_pictures(const fs::path& folder, const Json& view) {
    const ComparisonPanels panels =
        panels_of(read_color_image(folder / view.at("picture").get<std::string>()));
    const std::string name = text_of(view.at("name"));
    const std::string beside = html_pair(
        html_figure(panels.photograph, kPictureWidthPx, name + ": the photograph, not used"),
        html_figure(panels.rendering, kPictureWidthPx,
                    "What lumi draws from there: " +
                        number_text(view.at("psnr_db").get<double>(), 1) + " dB"));
    const std::string maps =
        html_figure(panels.error, kMapWidthPx,
                    "Error: dark blue is none, bright yellow is 64 of 255 and more; hatched was "
                    "not drawn") +
        map_figure(folder, view, "flip_picture",
                   "What the eye notices when the two are flipped (FLIP): bright is 0.5 and more") +
        map_figure(folder, view, "ghost_picture",
                   "Where the blended cameras disagree (ghost energy, known without the "
                   "photograph): bright is 32 of 255 and more");
    return beside + html_details("Where they differ", html_grid(maps));
}

}  // namespace

std::string pictures_section(const ReportSources& sources) {
    if (sources.evaluation.is_null()) return {};
    const Json& views = sources.evaluation.at("views");
    std::string html = "<p>" + part_taken(sources) + "</p>\n";
    for (const std::size_t index : spread(views.size(), kMaxViews)) {
        html += view_pictures(sources.workspace.evaluation_folder(), views.at(index));
    }
    if (views.size() > kMaxViews) {
        html += "<p>" + std::to_string(kMaxViews) + " of " + std::to_string(views.size()) +
                " are shown; all lie in the folder evaluation.</p>\n";
    }
    return html_section("Seen from where no photograph was used", html);
}

}  // namespace lumi
