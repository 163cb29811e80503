#include "pipeline/stages/calibration_files.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "calib/boards/calibration_picture.h"
#include "calib/lens_files/lens_files.h"
#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/stages/calibration_json.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> remarks_of(const BoardPhotographs& found,
                                    const BoardCalibration& calibration) {
    std::vector<std::string> remarks{"Calibrated by lumi from " +
                                         counted(calibration.views.size(), "photograph") +
                                         " of a board (" + std::string(name_of(found.kind)) +
                                         "): RMS " + number_text(calibration.rms_px, 3) +
                                         " px, held out " + held_out_text(calibration) + ".",
                                     "One standard deviation and 95 % interval of each parameter:"};
    for (const LensParameter& parameter : calibration.parameters) {
        remarks.push_back("  " + parameter_text(parameter));
    }
    if (calibration.bow) remarks.push_back(text_of(*calibration.bow) + ".");
    return remarks;
}

}  // namespace

std::string held_out_text(const BoardCalibration& calibration) {
    if (!calibration.held_out_rms_px)
        return "not predicted: what is left without some photographs does not tell the lens";
    return number_text(*calibration.held_out_rms_px, 3) + " px";
}

std::string parameter_text(const LensParameter& parameter) {
    const int digits = std::abs(parameter.value) < 10 ? 5 : 2;
    std::string text = parameter.name + " = " + number_text(parameter.value, digits);
    if (parameter.sigma == 0) return text + "  (held)";
    return text + "  +- " + number_text(parameter.sigma, digits) +
           "  95 %: " + number_text(parameter.low, digits) + " to " +
           number_text(parameter.high, digits);
}

std::vector<std::string> write_calibration(const fs::path& folder, const BoardPhotographs& found,
                                           const BoardCalibration& calibration) {
    std::vector<std::string> written;
    const std::vector<std::string> remarks = remarks_of(found, calibration);
    for (const LensFormat format : kLensFormats) {
        const fs::path path = folder / usual_file_name(format);
        try {
            write_lens_file(path, calibration.lens, format, remarks);
            written.push_back(path.string());
        } catch (const Error& error) {
            if (error.code() != "E-LENS-FORMAT") throw;
            fs::remove(path);
        }
    }
    const fs::path picture = folder / "calibration.svg";
    write_whole_text(picture, calibration_svg(calibration));
    written.push_back(picture.string());
    const fs::path figures = folder / "calibration.json";
    write_whole_text(figures, json_text(calibration_json(found, calibration)));
    written.push_back(figures.string());
    return written;
}

}  // namespace lumi
