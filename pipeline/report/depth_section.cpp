#include <algorithm>
#include <map>

#include "calib/pictures/image_io.h"
#include "pipeline/report/sections.h"
#include "pipeline/report/spread.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kDepthWidthPx = 320;
constexpr std::size_t kMaxPictures = 24;
constexpr std::size_t kPicturesAtOnce = 6;
const std::string kEnding = ".inverse_depth.png";

std::vector<fs::path> depth_pictures(const fs::path& folder) {
    std::vector<fs::path> pictures;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().string().ends_with(kEnding)) pictures.push_back(entry.path());
    }
    std::sort(pictures.begin(), pictures.end());
    return pictures;
}

/// The photographs' names by those of their depth pictures, which are names for any file system.
std::map<std::string, std::string> photographs_by_stem(const Json& depth) {
    std::vector<std::string> names;
    for (const Json& view : depth.at("views")) names.push_back(text_of(view.at("name")));
    const std::vector<std::string> stems = file_stems_of_views(names);
    std::map<std::string, std::string> photographs;
    for (std::size_t i = 0; i < names.size(); ++i) photographs[stems[i]] = names[i];
    return photographs;
}

std::string picture_figure(const fs::path& path,
                           const std::map<std::string, std::string>& photographs) {
    const std::string file = path.filename().string();
    const std::string stem = file.substr(0, file.size() - kEnding.size());
    const auto photograph = photographs.find(stem);
    return html_figure(read_color_image(path), kDepthWidthPx,
                       photograph == photographs.end() ? stem : photograph->second);
}

}  // namespace

std::string depth_section(const ReportSources& sources) {
    const Json depth = evidence_of(sources.stages, "depth");
    if (depth.is_null()) return {};
    const std::map<std::string, std::string> photographs = photographs_by_stem(depth);
    const std::vector<fs::path> pictures = depth_pictures(sources.workspace.stage_folder("depth"));
    std::string first;
    std::string more;
    const std::vector<std::size_t> shown = spread(pictures.size(), kMaxPictures);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        // The first few are spread over the capture, too.
        const bool is_first = i % std::max<std::size_t>(1, shown.size() / kPicturesAtOnce) == 0;
        (is_first ? first : more) += picture_figure(pictures[shown[i]], photographs);
    }
    std::string html = "<p>Inverse depth: near is bright, far is dark.</p>\n";
    if (depth.contains("warning"))
        html += "<p>" + html_escaped(text_of(depth.at("warning"))) + "</p>\n";
    html += html_grid(first);
    if (!more.empty()) html += html_details("More depth", html_grid(more));
    TableRows rows;
    for (const Json& view : depth.at("views")) {
        rows.push_back({text_of(view.at("name")), text_of(view.at("model")),
                        number_text(100.0 * view.at("confident_share").get<double>(), 1),
                        text_of(view.at("sparse_residual_px"))});
    }
    html += html_details("Every view", html_table({"view", "model", "agreed on by other views (%)",
                                                   "distance to sparse points (px)"},
                                                  rows));
    return html_section("Depth", html);
}

}  // namespace lumi
