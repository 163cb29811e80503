#include "pipeline/bench/rival_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "calib/work/whole_file.h"
#include "pipeline/text/csv.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/optional_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kColumnWidth = 12;
constexpr int kCsvDecimals = 6;

/// A figure of a method: where it stands in the table, in CSV and in JSON.
struct Figure {
    const char* name;
    const char* heading;  ///< In the table; empty: not there.
    int decimals;
    double scale;  ///< In the table.
    std::optional<double> (*value)(const RivalFigures& rival);
    /// Null for what is no figure of a frame by itself.
    std::optional<double> (*of_frame)(const RivalFrameFigures& frame) = nullptr;
};

const std::vector<Figure>& figures_of_rivals() {
    using Value = std::optional<double>;
    using Rival = RivalFigures;
    using Frame = RivalFrameFigures;
    static const std::vector<Figure> figures{
        {"pictures", "pictures", 0, 1, [](const Rival& r) -> Value { return r.pictures; }},
        {"triangles", "triangles", 0, 1, [](const Rival& r) -> Value { return r.triangles; }},
        {"cpu_ms", "CPU ms", 2, 1, [](const Rival& r) { return r.cpu_ms; }},
        {"depth_cpu_ms", "of depth", 2, 1, [](const Rival& r) { return r.depth_cpu_ms; }},
        {"wall_ms", "", 2, 1, [](const Rival& r) { return r.wall_ms; }},
        {"frames_per_s", "frames/s", 0, 1,
         [](const Rival& r) -> Value {
             return r.wall_ms ? Value(1000 / *r.wall_ms) : std::nullopt;
         }},
        {"cpu_ratio", "ratio", 2, 1, [](const Rival& r) { return r.cpu_ratio; }},
        {"resampling_cpu_s", "resampl. s", 1, 1, [](const Rival& r) { return r.resampling_cpu_s; }},
        {"psnr_db", "dB", 2, 1, [](const Rival& r) -> Value { return r.psnr_db; },
         [](const Frame& f) -> Value { return f.psnr_db; }},
        {"psnr_as_drawn_db", "as drawn", 2, 1,
         [](const Rival& r) -> Value { return r.psnr_as_drawn_db; },
         [](const Frame& f) -> Value { return f.psnr_as_drawn_db; }},
        {"psnr_common_db", "common", 2, 1, [](const Rival& r) { return r.psnr_common_db; },
         [](const Frame& f) { return f.psnr_common_db; }},
        {"psnr_covered_db", "covered", 2, 1, [](const Rival& r) { return r.psnr_covered_db; },
         [](const Frame& f) { return f.psnr_covered_db; }},
        {"covered_frames", "of frames", 0, 1,
         [](const Rival& r) -> Value { return r.covered_frames; }},
        {"coverage", "cover %", 1, 100, [](const Rival& r) -> Value { return r.coverage; },
         [](const Frame& f) -> Value { return f.coverage; }},
        {"psnr_off_cameras_common_db", "off cameras", 2, 1,
         [](const Rival& r) { return r.off_cameras.psnr_common_db; }},
        {"psnr_off_cameras_covered_db", "off covered", 2, 1,
         [](const Rival& r) { return r.off_cameras.psnr_covered_db; }},
        {"off_cameras_coverage", "off cover %", 1, 100,
         [](const Rival& r) -> Value { return r.off_cameras.coverage; }},
        {"wrong_layer_share", "wrong %", 3, 100,
         [](const Rival& r) { return r.wrong_layer_share; }},
        {"avoidable_wrong_layer_share", "avoidable", 3, 100,
         [](const Rival& r) { return r.avoidable_wrong_layer_share; }},
        {"flicker", "flicker", 3, 1, [](const Rival& r) { return r.flicker; }}};
    return figures;
}

Json frame_json(const RivalFrameFigures& frame) {
    Json json = Json::object();
    for (const Figure& figure : figures_of_rivals())
        if (figure.of_frame) json[figure.name] = optional_json(figure.of_frame(frame));
    return json;
}

Json rival_json(const RivalFigures& rival) {
    Json json{{"method", rival.method}, {"settings", rival.settings}};
    for (const Figure& figure : figures_of_rivals())
        json[figure.name] = optional_json(figure.value(rival));
    json["frames"] = Json::array();
    for (const RivalFrameFigures& frame : rival.frames) json["frames"].push_back(frame_json(frame));
    return json;
}

std::string cell_text(const std::optional<double>& value, int decimals) {
    return value ? number_text(*value, decimals) : "";
}

std::string frames_csv(const RivalScene& scene, const RivalFigures& rival) {
    std::string csv;
    for (std::size_t i = 0; i < rival.frames.size(); ++i) {
        std::vector<std::string> cells{scene.name, rival.method, rival.settings,
                                       std::to_string(i + 1)};
        for (const Figure& figure : figures_of_rivals())
            cells.push_back(
                figure.of_frame ? cell_text(figure.of_frame(rival.frames[i]), kCsvDecimals) : "");
        csv += csv_row(cells);
    }
    return csv;
}

constexpr const char* kNameHeading = "method";

std::string name_with_settings(const RivalFigures& rival) {
    return rival.method + (rival.settings.empty() ? "" : ", " + rival.settings);
}

/// Of the first column.
std::size_t name_width(const RivalScene& scene) {
    std::size_t width = std::string(kNameHeading).size();
    for (const RivalFigures& rival : scene.rivals)
        width = std::max(width, name_with_settings(rival).size());
    return width;
}

std::string row_text(const RivalFigures& rival, std::size_t name_width) {
    std::string text = padded_right(name_with_settings(rival), name_width);
    for (const Figure& figure : figures_of_rivals()) {
        if (*figure.heading == 0) continue;
        const auto value = figure.value(rival);
        text += padded_left(value ? number_text(figure.scale * *value, figure.decimals) : "-",
                            kColumnWidth);
    }
    return text + "\n";
}

std::string heading_text(std::size_t name_width) {
    std::string text = padded_right(kNameHeading, name_width);
    for (const Figure& figure : figures_of_rivals())
        if (*figure.heading != 0) text += padded_left(figure.heading, kColumnWidth);
    return text + "\n";
}

}  // namespace

Json rival_scenes_json(const std::vector<RivalScene>& scenes) {
    Json list = Json::array();
    for (const RivalScene& scene : scenes) {
        Json rivals = Json::array();
        for (const RivalFigures& rival : scene.rivals) rivals.push_back(rival_json(rival));
        list.push_back({{"scene", scene.name},
                        {"photographs", scene.photographs},
                        {"paper", scene.paper},
                        {"common_share", scene.common_share},
                        {"off_cameras_common_share", scene.off_cameras_common_share},
                        {"adaptive_occlusion_share", scene.adaptive_occlusion_share},
                        {"per_pixel_occlusion_share", scene.per_pixel_occlusion_share},
                        {"rivals", std::move(rivals)}});
    }
    return {{"scenes", std::move(list)}};
}

std::string rivals_csv(const std::vector<RivalScene>& scenes) {
    std::vector<std::string> names{"scene", "method", "settings", "frame"};
    for (const Figure& figure : figures_of_rivals()) names.emplace_back(figure.name);
    std::string csv = csv_row(names);
    for (const RivalScene& scene : scenes) {
        for (const RivalFigures& rival : scene.rivals) {
            std::vector<std::string> cells{scene.name, rival.method, rival.settings, "mean"};
            for (const Figure& figure : figures_of_rivals())
                cells.push_back(cell_text(figure.value(rival), kCsvDecimals));
            csv += csv_row(cells) + frames_csv(scene, rival);
        }
    }
    return csv;
}

std::string rivals_text(const std::vector<RivalScene>& scenes) {
    std::string text;
    for (const RivalScene& scene : scenes) {
        const std::size_t width = name_width(scene);
        text += scene.name + ": " + counted(scene.photographs, "photograph") +
                " (the paper: " + scene.paper + ")\n" + heading_text(width);
        for (const RivalFigures& rival : scene.rivals) text += row_text(rival, width);
        text +=
            "dB: of all pixels, where a method covers none filled with the same surroundings "
            "for all; as drawn: there with lumi's own guesses, of what is resampled, too, and "
            "black in paper2001, heigl and plain code; common: of the " +
            number_text(100 * scene.common_share, 1) +
            " % of pixels that all methods cover that draw from the photographs' depth (of heigl "
            "triangles decide, too); covered: of what it covers itself; off cameras: as common, of "
            "eyes a tenth of the way nearer to the scene and farther from it than the photographs "
            "(" +
            number_text(100 * scene.off_cameras_common_share, 1) +
            " % of their pixels), off covered: of what it covers there; wrong, avoidable: of what "
            "it covers, what shows another surface, and where some photograph shows the right "
            "one\nocclusion correction takes " +
            number_text(100 * scene.adaptive_occlusion_share, 1) + " % of adaptive, " +
            number_text(100 * scene.per_pixel_occlusion_share, 1) +
            " % of perpixel (the paper: 7 to 10 %); what is resampled is drawn by lumi's own "
            "modes; plain code runs on one core\n\n";
    }
    return text;
}

void write_rival_report(const std::filesystem::path& folder,
                        const std::vector<RivalScene>& scenes) {
    write_json_file(folder / "rivals.json", rival_scenes_json(scenes));
    write_whole_text(folder / "rivals.csv", rivals_csv(scenes));
}

}  // namespace lumi
