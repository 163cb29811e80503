#include <optional>
#include <utility>

#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

struct PoseFault {
    std::string option;
    std::string expected;
};

std::optional<PoseFault> first_fault(const PoseOptions& options) {
    if (options.lens_model != "auto" && !lens_model_named(options.lens_model)) {
        return PoseFault{"lens_model",
                         "auto, SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, "
                         "OPENCV_FISHEYE or FULL_OPENCV"};
    }
    if (options.max_features <= 0) return PoseFault{"max_features", "more than 0"};
    if (!(options.max_reprojection_error_px > 0)) {
        return PoseFault{"max_reprojection_error_px", "more than 0"};
    }
    if (options.min_track_length < 2) return PoseFault{"min_track_length", "at least 2"};
    if (!(options.min_registered_share > 0 && options.min_registered_share <= 1)) {
        return PoseFault{"min_registered_share", "more than 0 and at most 1"};
    }
    if (!(options.time_limit_s > 0)) return PoseFault{"time_limit_s", "more than 0"};
    if (options.colmap.empty()) return PoseFault{"colmap", "the name of a program"};
    return std::nullopt;
}

PoseProgram read_program(const ConfigSection& section, const char* key, PoseProgram otherwise) {
    const std::string name = section.text(key, std::string(name_of(otherwise)));
    for (const PoseProgram program : {PoseProgram::kLumi, PoseProgram::kColmap})
        if (name == name_of(program)) return program;
    section.refuse(key, R"("lumi" or "colmap")");
}

}  // namespace

std::string_view name_of(PoseProgram program) {
    return program == PoseProgram::kLumi ? "lumi" : "colmap";
}

void validate(const PoseOptions& options) {
    if (const auto fault = first_fault(options)) {
        throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                    "[poses] " + fault->option + ": expected " + fault->expected,
                    "correct this key, or remove it to use the default");
    }
}

PoseOptions read_pose_options(const ConfigSection& section) {
    PoseOptions options;
    options.lens_model = section.text("lens_model", options.lens_model);
    options.shared_lens = section.boolean("shared_lens", options.shared_lens);
    options.refine_lens = section.boolean("refine_lens", options.refine_lens);
    options.max_features = section.integer("max_features", options.max_features);
    options.max_reprojection_error_px =
        section.number("max_reprojection_error_px", options.max_reprojection_error_px);
    options.min_track_length = section.integer("min_track_length", options.min_track_length);
    options.min_registered_share =
        section.number("min_registered_share", options.min_registered_share);
    options.time_limit_s = section.number("time_limit_s", options.time_limit_s);
    options.front_end = read_program(section, "front_end", options.front_end);
    options.mapper = read_program(section, "mapper", options.mapper);
    options.colmap = section.text("colmap", options.colmap);
    options.mask_folder = section.path("masks");
    if (const auto fault = first_fault(options)) section.refuse(fault->option, fault->expected);
    return options;
}

}  // namespace lumi
