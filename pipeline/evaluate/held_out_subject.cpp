#include "pipeline/evaluate/held_out_subject.h"

#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "meshing/depth_scene/view_mask.h"
#include "pipeline/stages/depth_stage.h"
#include "pipeline/stages/straightened_masks.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Each pixel of the larger picture takes the one of the smaller that its centre falls in.
GrayImage enlarged(const GrayImage& mask, int width, int height) {
    GrayImage large(width, height);
    for (int y = 0; y < height; ++y) {
        const auto source_y = static_cast<int>((y + 0.5) * mask.height() / height);
        for (int x = 0; x < width; ++x) {
            large(x, y) = mask(static_cast<int>((x + 0.5) * mask.width() / width), source_y);
        }
    }
    return large;
}

SubjectMask before_background(Rgb8 background, int max_width_px) {
    return [=](const std::string&, const ColorImage& photograph) {
        const int width = photograph.width();
        const int height = photograph.height();
        if (width <= max_width_px) return mask_of_background(photograph, background);
        const int small_height = std::max(1, height * max_width_px / width);
        return enlarged(
            mask_of_background(resized(photograph, max_width_px, small_height), background), width,
            height);
    };
}

SubjectMask drawn_in(const fs::path& folder) {
    return [=](const std::string& name, const ColorImage& photograph) {
        const fs::path file = straightened_mask_file(folder, name);
        if (!fs::is_regular_file(file)) return GrayImage();
        GrayImage mask = read_gray_png(file);
        if (mask.width() == photograph.width() && mask.height() == photograph.height()) {
            return mask;
        }
        return enlarged(mask, photograph.width(), photograph.height());
    };
}

}  // namespace

EvaluationOptions judging_subject(EvaluationOptions options, const WorkspaceLayout& workspace) {
    const fs::path depth_folder = workspace.stage_folder("depth");
    const auto marker = read_done_marker(depth_folder / "done.json");
    if (!marker) return options;
    const Json subject = Json::parse(marker->evidence.facts_json).value("subject", Json());
    if (subject.is_null()) return options;
    options.subject_from = subject.at("from");
    if (options.subject_from == kSubjectDrawn) {
        options.subject_mask = drawn_in(depth_folder / kMaskFolder);
    } else {
        const Json& color = subject.at("color");
        options.subject_mask =
            before_background({color.at(0), color.at(1), color.at(2)}, subject.at("width_px"));
    }
    return options;
}

}  // namespace lumi
